// Looks, colours and marks in the viewport, in both renderers.

import assert from "node:assert/strict";

import { SMALL, editorTest } from "./harness.mjs";
import { PNG } from "./support/packages.mjs";

/** The viewport without its rim, where the axes and the legend are. */
async function middle(editor) {
  const [x, y, width, height] = (await editor.state()).view.rect;
  return [x + width * 0.3, y + height * 0.25, width * 0.4, height * 0.5].map(Math.round);
}

const LOOKS = [
  ["Light at the camera", "course"],
  ["Clay", "clay"],
  ["Pearl", "pearl"],
  ["Metal", "metal"],
  ["Red wax", "red-wax"],
  ["Zebra stripes", "zebra"],
  ["Colours without light", "flat"],
  ["Hidden line", "hidden-line"],
  ["Normals as colours", "normals"],
  ["Face orientation", "orientation"],
  ["Studio lights", "studio"],
];

editorTest("each look draws the model in its own way", { sizes: [SMALL] }, async (editor) => {
  await editor.run({ op: "new", shape: "torus" });
  await editor.press("w");
  await editor.page.mouse.move(5, 5);
  const rect = await middle(editor);
  const seen = [];
  for (const [name, look] of LOOKS) {
    await editor.choose(name);
    assert.equal((await editor.state()).view.look, look);
    const picture = await editor.screenshot(`look ${look}`);
    for (const [other, before] of seen) {
      assert.ok(picture.difference(before, rect) > 200, `${look} differs from ${other}`);
    }
    seen.push([look, picture]);
  }
});

editorTest("vertex colours, measures and marks are drawn", { sizes: [SMALL] }, async (editor) => {
  const square = "v -1 0 0 1 0 0\nv 1 0 0 0 0 1\nv 1 2 0 0 0 1\nv -1 2 0 1 0 0\nf 1 2 3 4\n";
  await editor.open("square.obj", square);
  await editor.press("Alt+1");
  await editor.page.mouse.move(5, 5);
  // The view glides there.
  await editor.frames(30);
  const colour = async (point, name) => {
    const [x, y] = await editor.project(point);
    return (await editor.screenshot(name)).at(Math.round(x), Math.round(y));
  };
  const left = await colour([-0.8, 1.2, 0], "vertex colours");
  const right = await colour([0.8, 1.2, 0]);
  assert.ok(left[0] > left[2] + 60 && right[2] > right[0] + 60, `red and blue: ${left}, ${right}`);

  await editor.choose("Valence");
  assert.equal((await editor.state()).view.color_by, "valence");
  const [r, g, b] = await colour([0, 1.2, 0], "valence");
  assert.ok(b > r + 40, `two edges at each vertex are few: ${r} ${g} ${b}`);

  await editor.choose("Boundary edges");
  assert.deepEqual((await editor.state()).view.marks, ["boundary"]);
  const marked = await editor.screenshot("boundary");
  assert.ok(marked.count(([r, g, b]) => g > 120 && r < 60 && b < 120, await middle(editor)) > 20, "a green edge");
});

/** A picture of two by two pixels, enlarged: red and green above blue and white. */
function quarters(size = 64) {
  const png = new PNG({ width: size, height: size });
  const colors = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]];
  for (let y = 0; y < size; y += 1) {
    for (let x = 0; x < size; x += 1) {
      const color = colors[(x < size / 2 ? 0 : 1) + (y < size / 2 ? 0 : 2)];
      png.data.set([...color, 255], (y * size + x) * 4);
    }
  }
  return PNG.sync.write(png);
}

editorTest("images of materials are drawn, also when they come later", { sizes: [SMALL] }, async (editor) => {
  const square = [
    "mtllib square.mtl", "v -1 0 0", "v 1 0 0", "v 1 2 0", "v -1 2 0",
    "vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1", "usemtl tiles", "f 1/1 2/2 3/3 4/4", "",
  ].join("\n");
  const library = "newmtl tiles\nKd 1 1 1\nmap_Kd quarters.png\n";
  await editor.drop({ name: "square.obj", content: square }, { name: "square.mtl", content: library });
  await editor.until("the square is open", async () => (await editor.state()).document.faces === 1);
  assert.equal((await editor.state()).view.textures[0].state, "missing");
  await editor.drop({ name: "quarters.png", content: quarters() });
  await editor.until("the image is shown", async () => (await editor.state()).view.textures[0].state === "shown");
  assert.equal((await editor.state()).view.look, "texture");
  await editor.press("Alt+1");
  await editor.page.mouse.move(5, 5);
  await editor.frames(30);
  const picture = await editor.screenshot("textures");
  const largest = async (point) => {
    const [x, y] = await editor.project(point);
    const [r, g, b] = picture.at(Math.round(x), Math.round(y));
    return [r > 150, g > 150, b > 150].map(Number).join("");
  };
  assert.equal(await largest([-0.5, 1.5, 0]), "100", "red above on the left");
  assert.equal(await largest([0.5, 1.5, 0]), "010", "green above on the right");
  assert.equal(await largest([-0.5, 0.5, 0]), "001", "blue below on the left");
  assert.equal(await largest([0.5, 0.5, 0]), "111", "white below on the right");
});
