// What the pictures of docs/guide show: for each, how a user brings the page there. `show` may return the part of the page
// that the picture shows, as [x, y, width, height].

import { readFile } from "node:fs/promises";

const sample = (name) => readFile(new URL(`../../web/samples/${name}.off`, import.meta.url));

/** Opens a sample of the welcome view. */
async function open(editor, name) {
  await editor.open(`${name}.off`, await sample(name));
  await editor.idle();
}

/** Moves the pointer where it points to nothing: into the bar of the menus. */
const putAway = (editor) => editor.page.mouse.move(660, 8);

/** The positions of a mesh, and its faces as their corners. */
async function meshOf(editor) {
  const { positions, halfedges, faces } = JSON.parse(await editor.export("json"));
  const corners = faces.map((first) => {
    const found = [];
    for (let at = first; found.length === 0 || at !== first; at = halfedges[at][0]) found.push(halfedges[halfedges[at][2]][3]);
    return found;
  });
  return { positions, faces: corners };
}

const middle = (mesh, face) => [0, 1, 2].map((axis) =>
  mesh.faces[face].reduce((sum, vertex) => sum + mesh.positions[vertex][axis], 0) / mesh.faces[face].length);

/** The place in a list with the highest score. */
function best(list, score) {
  return list.reduce((best, item, at) => (score(item, at) > score(list[best], best) ? at : best), 0);
}

/** Orbits the view by a drag of the middle button. */
async function orbit(editor, x, y) {
  const [left, top, width, height] = (await editor.state()).view.rect;
  const from = [left + width / 2, top + height / 2];
  await editor.drag(from, [from[0] + x, from[1] + y], { button: "middle" });
}

/** The part of the page with the model and the bar of an edit, between the tools and the inspector. */
const MODEL = [136, 96, 644, 530];

/** Starts an edit that follows the pointer with its key, and moves the pointer. */
async function live(editor, key, [x, y]) {
  const [left, top, width, height] = (await editor.state()).view.rect;
  const from = [left + width * 0.45, top + height * 0.75];
  await editor.page.mouse.move(...from);
  await editor.frames(3);
  await editor.press(key);
  for (let step = 1; step <= 4; step += 1) {
    await editor.page.mouse.move(from[0] + (x * step) / 4, from[1] + (y * step) / 4);
    await editor.frames(2);
  }
}

/** The edges of a mesh as pairs of vertices, in order. */
async function edgesOf(editor) {
  const { halfedges, edges } = JSON.parse(await editor.export("json"));
  return edges.map((first) => [halfedges[halfedges[first][2]][3], halfedges[first][3]]);
}

/** Opens the form of an operation in the right panel. */
async function form(editor, operation) {
  await editor.click("Filter operations", "textInput");
  await editor.page.keyboard.type(operation);
  await editor.press("Enter");
  await editor.frames(6);
}

export const scenes = [
  {
    name: "welcome",
    welcome: true,
    size: { width: 1280, height: 800 },
    async show(editor) {
      await putAway(editor);
      return [332, 34, 648, 732];
    },
  },
  {
    name: "editor",
    async show(editor) {
      await editor.choose("Model layout");
      await open(editor, "mug");
      await editor.press("4");
      const mesh = await meshOf(editor);
      // The band of faces below the rim.
      const band = mesh.faces.flatMap((corners, face) => {
        const [x, y, z] = middle(mesh, face);
        return corners.length === 4 && y > 1.3 && y < 1.75 && Math.hypot(x, z) > 0.85 && Math.hypot(x, z) < 0.95 ? [face] : [];
      });
      await editor.select("face", band);
      await editor.run({ op: "extrude-faces", distance: 0.07 });
      await editor.choose("Move gizmo");
      await orbit(editor, 40, 25);
      await putAway(editor);
    },
  },
  {
    name: "palette",
    async show(editor) {
      await editor.choose("Model layout");
      await editor.press("Control+k");
      await editor.page.keyboard.type("decimate");
      await editor.frames(6);
      return [284, 34, 516, 112];
    },
  },
  {
    name: "saving",
    async show(editor) {
      await open(editor, "fox");
      await editor.run({ op: "new", shape: "torus", add: true });
      await editor.choose("STL");
      await editor.frames(6);
      return [314, 70, 452, 280];
    },
  },
  {
    name: "selecting",
    async show(editor) {
      await editor.choose("Model layout");
      await open(editor, "pawn");
      await editor.press("2");
      const { positions } = await meshOf(editor);
      const edges = await edgesOf(editor);
      // An edge around the body, from which a double-click takes the whole loop.
      const edge = best(edges, ([a, b]) => {
        const [p, q] = [positions[a], positions[b]];
        return Math.abs(p[1] - q[1]) < 1e-3 ? -Math.abs(p[1] - 1.1) : -10;
      });
      await editor.select("edge", [edge]);
      await editor.run({ op: "select-related", by: "loops" });
      await putAway(editor);
      return MODEL;
    },
  },
  {
    name: "lasso",
    async show(editor) {
      await editor.choose("Model layout");
      await open(editor, "fox");
      await editor.press("4");
      await editor.choose("Lasso select");
      const [left, top, width, height] = (await editor.state()).view.rect;
      const at = (turn) => [left + width * (0.42 + 0.13 * Math.cos(turn)), top + height * (0.47 + 0.2 * Math.sin(turn))];
      await editor.page.mouse.move(...at(0));
      await editor.frames(2);
      await editor.page.mouse.down();
      for (let step = 1; step <= 22; step += 1) {
        await editor.page.mouse.move(...at((step / 24) * 2 * Math.PI));
        await editor.frames(1);
      }
      return MODEL;
    },
  },
  {
    name: "moving",
    async show(editor) {
      await editor.choose("Model layout");
      await open(editor, "chair");
      await editor.press("4");
      const mesh = await meshOf(editor);
      const back = mesh.faces.flatMap((corners, face) => (corners.every((at) => mesh.positions[at][1] > 2.9) ? [face] : []));
      await editor.select("face", back);
      await live(editor, "g", [10, -40]);
      await editor.press("y");
      await editor.frames(3);
      return MODEL;
    },
  },
  {
    name: "soft-selection",
    async show(editor) {
      await editor.choose("Model layout");
      await editor.run({ op: "new", shape: "grid", rows: 24, columns: 24 });
      await editor.choose("Soft selection");
      const { positions } = await meshOf(editor);
      const centre = best(positions, ([x, , z]) => -Math.hypot(x - 0.1, z - 0.1));
      await editor.select("vertex", [centre]);
      await live(editor, "g", [0, -70]);
      await editor.press("y");
      await editor.frames(3);
      return MODEL;
    },
  },
  {
    name: "extruding",
    async show(editor) {
      await editor.choose("Model layout");
      await editor.run({ op: "new", shape: "cube" });
      await editor.press("4");
      const mesh = await meshOf(editor);
      const face = best(mesh.faces, (_, face) => middle(mesh, face)[1]);
      await editor.select("face", [face]);
      await editor.run({ op: "inset-faces", faces: [face], amount: 0.4 });
      await live(editor, "e", [0, -60]);
      return MODEL;
    },
  },
  {
    name: "loop-cut",
    async show(editor) {
      await editor.choose("Model layout");
      await open(editor, "mug");
      const { positions } = await meshOf(editor);
      const edges = await edgesOf(editor);
      const upright = await Promise.all(edges.map(async ([a, b]) => {
        const [p, q] = [positions[a], positions[b]];
        const isBody = Math.hypot(p[0], p[2]) > 0.8 && p[0] < 0.9;
        return isBody && p[2] > 0.7 && Math.abs(p[1] - q[1]) > 0.3 ? [p, q] : null;
      }));
      const [p, q] = upright.filter(Boolean)[0];
      await editor.press("l");
      const [x, y] = await editor.project(p.map((value, axis) => (value + q[axis]) / 2));
      await editor.page.mouse.move(x + 2, y);
      await editor.frames(6);
      await editor.page.keyboard.type("2");
      await editor.frames(6);
      return MODEL;
    },
  },
  {
    name: "simplifying",
    async show(editor) {
      await editor.choose("Model layout");
      await editor.run({ op: "new", shape: "torus" });
      await form(editor, "Simplify");
      await editor.idle();
      await editor.frames(20);
      await putAway(editor);
      return [130, 34, 950, 410];
    },
  },
  {
    name: "repairing",
    async show(editor) {
      await editor.choose("Model layout");
      // Three faces at one edge, and one that faces the other way.
      const text = "v 0 0 0\nv 0 2 0\nv 2 0 0\nv 2 2 0\nv -1 0 1.6\nv -1 2 1.6\nv -1 0 -1.6\nv -1 2 -1.6\n" +
        "f 1 3 4 2\nf 1 2 6 5\nf 2 1 7 8\n";
      await editor.drop({ name: "fins.obj", content: text });
      await editor.until("fins is open", async () => (await editor.state()).document.name === "fins");
      await editor.frames(6);
      await form(editor, "Repair import");
      await editor.choose("Non-manifold places");
      await orbit(editor, 150, 60);
      await editor.press("Home");
      await putAway(editor);
      return [130, 34, 950, 440];
    },
  },
  {
    name: "curvature",
    async show(editor) {
      await editor.choose("Model layout");
      await open(editor, "pawn");
      await editor.run({ op: "subdivide-catmull-clark", levels: 1 });
      await editor.idle();
      await editor.choose("Mean curvature");
      await editor.press("w");
      await editor.frames(10);
      await putAway(editor);
      return MODEL;
    },
  },
  {
    name: "four-views",
    async show(editor) {
      await editor.choose("Model layout");
      await open(editor, "chair");
      await editor.press("Control+Alt+q");
      await editor.choose("Clay");
      await putAway(editor);
      return [0, 34, 780, 594];
    },
  },
  {
    name: "study",
    async show(editor) {
      await editor.run({ op: "new", shape: "icosahedron" });
      await editor.choose("Study layout");
      await editor.press("3");
      await editor.select("halfedge", [20]);
      await editor.frames(6);
      // It would show how slowly pictures are drawn in software.
      await editor.press("i");
      const [x, y, width, height] = (await editor.state()).view.rect;
      await editor.page.mouse.move(x + width / 2, y + height * 0.62);
    },
  },
  {
    name: "bezier",
    async show(editor) {
      await editor.choose("Model layout");
      await editor.drop({ name: "arc.bzc", content: "5\n0 0  0.6 2.2  2.4 2.6  4.4 1.8  4 0\n" });
      await editor.until("arc is open", async () => (await editor.state()).document.name === "arc");
      for (let level = 0; level < 4; level += 1) await editor.press("e");
      await editor.press("c");
      await putAway(editor);
      return [136, 34, 944, 500];
    },
  },
  {
    name: "history",
    async show(editor) {
      await editor.choose("Model layout");
      await editor.run({ op: "new", shape: "cube" });
      await editor.press("u");
      await editor.idle();
      await editor.select("face", [0, 1]);
      await editor.run({ op: "extrude-faces", distance: 0.4 });
      await editor.run({ op: "smooth" });
      await editor.idle();
      await editor.press("Control+z");
      await editor.click("History panel");
      await putAway(editor);
      return [780, 380, 300, 248];
    },
  },
  {
    name: "documents",
    async show(editor) {
      await open(editor, "mug");
      await editor.frames(60);
      await open(editor, "fox");
      await editor.frames(60);
      await editor.choose("Recent documents");
      await editor.frames(60);
      return [276, 206, 528, 246];
    },
  },
  {
    name: "sharing",
    async show(editor) {
      await editor.run({ op: "new", shape: "torus" });
      await editor.run({ op: "subdivide-catmull-clark" });
      await editor.idle();
      await editor.choose("Share");
      await editor.find("QR code of the link");
      return [328, 118, 424, 424];
    },
  },
  {
    name: "shortcuts",
    async show(editor) {
      await editor.press("F1");
      await editor.frames(6);
      return [200, 56, 680, 550];
    },
  },
  {
    name: "phone",
    size: { name: "phone", width: 390, height: 760, touch: true },
    async show(editor) {
      await open(editor, "fox");
      await editor.frames(20);
    },
  },
];
