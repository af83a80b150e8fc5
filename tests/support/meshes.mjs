// Meshes for tests, as OBJ text. The functions are self-contained, so that a page can run them too.

/** A flat grid of columns × rows unit squares in the plane z = 0, or of twice as many triangles. */
export function grid(columns, rows, { triangles = false } = {}) {
  const lines = [];
  for (let y = 0; y <= rows; y += 1) {
    for (let x = 0; x <= columns; x += 1) lines.push(`v ${x} ${y} 0`);
  }
  for (let y = 0; y < rows; y += 1) {
    for (let x = 0; x < columns; x += 1) {
      const a = y * (columns + 1) + x + 1;
      const [b, c, d] = [a + 1, a + columns + 2, a + columns + 1];
      if (triangles) lines.push(`f ${a} ${b} ${c}`, `f ${a} ${c} ${d}`);
      else lines.push(`f ${a} ${b} ${c} ${d}`);
    }
  }
  return lines.join("\n") + "\n";
}

/** A triangle whose coordinates have no short decimal form, so that a lost digit shows. */
export const ODD_TRIANGLE = [
  "v 0.1 -0.30000001192092896 1e-7",
  "v 1.0000001 0.333333343 123456.79",
  "v -2.5 3.1415927 -0.6931472",
  "f 1 2 3",
  "",
].join("\n");

/** A quad and a triangle with a material each, whose colours are in `TWO_COLORS_MTL`. */
export const TWO_COLORS_OBJ = [
  "mtllib colors.mtl",
  "v 0 0 0", "v 1 0 0", "v 1 1 0", "v 0 1 0", "v 2 0.5 0",
  "usemtl red", "f 1 2 3 4",
  "usemtl blue", "f 2 5 3",
  "",
].join("\n");

export const TWO_COLORS_MTL = "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n";
