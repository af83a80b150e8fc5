// The lists and the viewport share one selection.

import assert from "node:assert/strict";

import { SMALL, editorTest } from "./harness.mjs";
import { grid } from "./support/meshes.mjs";

/** A square around a point of the page. */
const around = ([x, y], size = 24) => [x - size / 2, y - size / 2, size, size];

const middle = (points) => [0, 1, 2].map((axis) => points.reduce((sum, p) => sum + p[axis], 0) / points.length);

async function positions(editor, ids) {
  return Promise.all(ids.map(async (id) => (await editor.element("vertex", id)).position));
}

/** The place on the page of the middle of each face of the cube. */
async function middles(editor) {
  const hits = [];
  for (let id = 0; id < 6; id += 1) {
    const { corners } = await editor.element("face", id);
    hits.push({ id, at: await editor.project(middle(await positions(editor, corners))) });
  }
  return hits;
}

editorTest("a selection in a list shows in the viewport, and the other way round", { sizes: [SMALL] }, async (editor) => {
  // From the list to the viewport.
  const vertex = 7;
  const at = await editor.project((await editor.element("vertex", vertex)).position);
  await editor.page.mouse.move(5, 5);
  await editor.frames(3);
  const before = await editor.screenshot();
  await editor.click(`Vertex ${vertex}`, "listBoxOption");
  assert.deepEqual((await editor.state()).selection, { kind: "vertex", ids: [vertex] });
  assert.equal((await editor.find(`Vertex ${vertex}`, "listBoxOption")).selected, true);
  await editor.page.mouse.move(5, 5);
  await editor.frames(3);
  const after = await editor.screenshot("vertex selected");
  assert.ok(after.difference(before, around(at)) > 20, "the vertex is marked where it projects to");

  // Shift selects the rows between, Ctrl adds or removes one.
  const row = async (id) => {
    const { rect: [x, y, width, height] } = await editor.find(`Vertex ${id}`, "listBoxOption");
    return [x + width / 2, y + height / 2];
  };
  const clickWith = async (key, id) => {
    const at = await row(id);
    await editor.page.keyboard.down(key);
    await editor.clickAt(at);
    await editor.page.keyboard.up(key);
    await editor.frames(2);
  };
  await clickWith("Shift", 4);
  assert.deepEqual((await editor.state()).selection.ids.toSorted(), [4, 5, 6, 7]);
  await clickWith("Control", 6);
  await clickWith("Control", 0);
  assert.deepEqual((await editor.state()).selection.ids.toSorted(), [0, 4, 5, 7]);

  // From the viewport to the list: a click selects the face in front.
  await editor.click("Faces", "tab");
  const hits = await middles(editor);
  const picked = new Set();
  for (const { at } of hits) {
    await editor.clickAt(at);
    const { selection } = await editor.state();
    assert.equal(selection.kind, "face");
    assert.equal(selection.ids.length, 1);
    const [id] = selection.ids;
    picked.add(id);
    assert.equal((await editor.find(`Face ${id}`, "listBoxOption")).selected, true);
  }
  assert.equal(picked.size, 3, "three sides of a cube can be seen from a corner");
  for (const id of picked) {
    await editor.clickAt(hits[id].at);
    assert.deepEqual((await editor.state()).selection.ids, [id], "the middle of a face in front is on that face");
  }

  // Links in the inspector select, and keys move the selection.
  const [face] = (await editor.state()).selection.ids;
  const { halfedge } = await editor.element("face", face);
  await editor.click(`Half-edge: Half-edge ${halfedge}`, "link");
  assert.deepEqual((await editor.state()).selection, { kind: "halfedge", ids: [halfedge] });
  const { next, twin } = await editor.element("halfedge", halfedge);
  await editor.press("n");
  assert.deepEqual((await editor.state()).selection.ids, [next]);
  await editor.select("halfedge", [halfedge]);
  await editor.press("t");
  assert.deepEqual((await editor.state()).selection.ids, [twin]);

  // A click beside the mesh clears the selection.
  const [x, y, width, height] = (await editor.state()).view.rect;
  await editor.clickAt([x + width - 20, y + height - 120]);
  assert.deepEqual((await editor.state()).selection.ids, []);
});

editorTest("a long list can show any row", { renderers: ["webgl2"], sizes: [SMALL] }, async (editor) => {
  await editor.open("large.obj", grid(300, 300));
  await editor.click("Half-edges", "tab");
  const last = (await editor.state()).document.halfedges - 1;
  const go = await editor.find("Go to id", "textInput");
  for (const id of [last, 0, 123_456]) {
    await editor.clickAt([go.rect[0] + 20, go.rect[1] + 10]);
    await editor.page.keyboard.type(String(id));
    await editor.press("Enter");
    assert.deepEqual((await editor.state()).selection, { kind: "halfedge", ids: [id] });
    assert.equal((await editor.find(`Half-edge ${id}`, "listBoxOption")).selected, true);
    // The rows show what scripts get.
    const rows = (await editor.ui()).filter((node) => node.role === "listBoxOption");
    assert.ok(rows.length > 10);
    for (const row of rows.slice(0, 3)) {
      const { next, twin } = await editor.element("halfedge", Number(row.name.split(" ").at(-1)));
      assert.match(row.value, new RegExp(`next ${next}\\b`, "i"));
      assert.match(row.value, new RegExp(`twin ${twin}\\b`, "i"));
    }
  }
});

editorTest("loops, rings, paths and neighbours are selected by mouse and keys", { sizes: [SMALL] }, async (editor) => {
  await editor.run({ op: "new", shape: "grid", columns: 6, rows: 6 });
  const vertex = (column, row) => row * 7 + column;
  const at = async (...ids) => editor.project(middle(await positions(editor, ids)));
  const selected = async () => (await editor.state()).selection;
  const clickWith = async (keys, place) => {
    for (const key of keys) await editor.page.keyboard.down(key);
    await editor.clickAt(place);
    for (const key of keys) await editor.page.keyboard.up(key);
    await editor.frames(2);
  };
  const count = async (kind, ids) => assert.deepEqual(
    await selected().then(({ kind, ids }) => [kind, ids.length]), [kind, ids],
  );

  await editor.press("2");
  const edge = await at(vertex(2, 2), vertex(3, 2));
  await clickWith(["Alt"], edge);
  await count("edge", 6);
  await clickWith(["Control", "Alt"], edge);
  await count("edge", 7);
  await clickWith(["Alt", "Shift"], edge);
  await count("edge", 6 + 7 - 1);

  await editor.press("1");
  await clickWith([], await at(vertex(1, 1)));
  await clickWith(["Control", "Shift"], await at(vertex(4, 1)));
  assert.deepEqual(await selected(), { kind: "vertex", ids: [1, 2, 3, 4].map((column) => vertex(column, 1)) });
  await editor.press("Control+Minus");
  await count("vertex", 0);
  await clickWith([], await at(vertex(3, 3)));
  await editor.press("Control+Equal");
  await count("vertex", 9);
  await editor.press("Control+l");
  await count("vertex", 49);

  // Inside a face the nearest vertex is meant; beside the mesh nothing is.
  const [x, y] = await at(vertex(3, 3), vertex(4, 4));
  const [nearX, nearY] = await at(vertex(3, 3));
  await editor.clickAt([x + (nearX - x) * 0.2, y + (nearY - y) * 0.2]);
  assert.deepEqual(await selected(), { kind: "vertex", ids: [vertex(3, 3)] });
  assert.deepEqual((await editor.state()).history.undo, ["New shape"], "selecting is no edit");
});
