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

/** Drags with a button along places, with keys held. */
async function dragAlong(editor, places, { button = "left", keys = [] } = {}) {
  const { mouse, keyboard } = editor.page;
  await mouse.move(...places[0]);
  await editor.frames(2);
  for (const key of keys) await keyboard.down(key);
  await mouse.down({ button });
  for (const place of places) {
    await mouse.move(...place);
    await editor.frames(1);
  }
  await mouse.up({ button });
  for (const key of keys) await keyboard.up(key);
  await editor.frames(3);
}

editorTest("a lasso and a circle select, with x-ray through the surface too", { sizes: [SMALL] }, async (editor) => {
  const count = async () => (await editor.state()).selection.ids.length;
  const ids = [0, 1, 2, 3, 4, 5, 6, 7];
  await editor.press("1");
  const places = await Promise.all((await positions(editor, ids)).map((position) => editor.project(position)));
  const [left, top, width, height] = (await editor.state()).view.rect;
  const [x0, y0, x1, y1] = [left + 4, top + 4, left + width - 4, top + height - 4];
  const everything = [[x0, y0], [(x0 + x1) / 2, y0], [x1, y0], [x1, y1], [x0, y1]];
  const circle = (middle, radius) => Array.from({ length: 25 }, (_, step) => {
    const angle = step / 24 * 2 * Math.PI;
    return [middle[0] + radius * Math.cos(angle), middle[1] + radius * Math.sin(angle)];
  });
  const lasso = { button: "right", keys: ["Control"] };
  await dragAlong(editor, everything, lasso);
  assert.equal(await count(), 7, "the eighth vertex is behind the cube");
  const selected = (await editor.state()).selection.ids;
  const hidden = ids.find((id) => !selected.includes(id));

  // One vertex alone, and a second one added.
  await dragAlong(editor, circle(places[selected[0]], 14), lasso);
  assert.deepEqual((await editor.state()).selection.ids, [selected[0]]);
  await dragAlong(editor, circle(places[selected[1]], 14), { button: "right", keys: ["Control", "Shift"] });
  assert.equal(await count(), 2);

  await editor.page.mouse.move(5, 5);
  await editor.frames(3);
  const solid = await editor.screenshot();
  await editor.press("Alt+x");
  await editor.frames(3);
  const glass = await editor.screenshot("x-ray");
  assert.ok(glass.difference(solid, around(places[hidden], 16)) > 3, "the hidden edges show");
  await dragAlong(editor, everything, lasso);
  assert.equal(await count(), 8);
  await editor.clickAt(places[hidden]);
  assert.deepEqual((await editor.state()).selection.ids, [hidden]);
  await editor.press("Alt+x");

  // The circle adds along its way; with Ctrl it removes; a stroke is one step.
  await editor.press("Escape");
  await editor.press("Shift+C");
  await dragAlong(editor, [places[selected[0]], places[selected[1]]]);
  assert.ok(await count() >= 2);
  const painted = await count();
  await dragAlong(editor, [places[selected[0]], places[selected[0]]], { keys: ["Control"] });
  assert.equal(await count(), painted - 1);
  await editor.press("Control+z");
  assert.equal(await count(), painted);
  await editor.press("Escape");
});

editorTest("a double-click selects a loop, in slow frames too", { sizes: [SMALL] }, async (editor) => {
  await editor.run({ op: "new", shape: "grid", columns: 6, rows: 6 });
  await editor.press("2");
  const vertex = (column, row) => row * 7 + column;
  const [x, y] = await editor.project(middle(await positions(editor, [vertex(2, 2), vertex(3, 2)])));
  await editor.page.mouse.move(x, y);
  await editor.frames(2);
  // Every frame takes longer than the two clicks may be apart.
  await editor.page.evaluate(() => {
    const busy = () => {
      const end = performance.now() + 700;
      while (performance.now() < end);
      if (!window.isIdle) requestAnimationFrame(busy);
    };
    requestAnimationFrame(busy);
  });
  const session = await editor.context.newCDPSession(editor.page);
  const send = (type, clickCount) =>
    session.send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons: 1, clickCount });
  await Promise.all([send("mousePressed", 1), send("mouseReleased", 1), send("mousePressed", 2), send("mouseReleased", 2)]);
  await editor.page.evaluate(() => { window.isIdle = true; });
  await session.detach();
  await editor.until("the loop is selected", async () => (await editor.state()).selection.ids.length === 6);
  assert.equal((await editor.state()).selection.kind, "edge");
});

editorTest("criteria, hiding and switching work by menus and keys, and undo steps through them", { sizes: [SMALL] }, async (editor) => {
  await editor.run({ op: "new", shape: "torus" });
  const { faces } = (await editor.state()).document;
  const selected = async () => {
    const { kind, ids } = (await editor.state()).selection;
    return [kind, ids.length];
  };
  const hidden = async () => (await editor.state()).document.objects[0].hidden ?? 0;

  await editor.click("Select", "button");
  await editor.click("By criterion", "button");
  await editor.click("Select quads", "button");
  assert.deepEqual(await selected(), ["face", faces]);
  await editor.press("2");
  assert.deepEqual(await selected(), ["edge", 2 * faces]);
  await editor.press("Control+z");
  await editor.press("Control+z");
  assert.deepEqual((await selected())[1], 0);
  assert.deepEqual((await editor.state()).history.undo, ["New shape"], "selecting is no edit");

  await editor.press("4");
  await editor.page.mouse.move(5, 5);
  await editor.frames(3);
  const before = await editor.screenshot();
  await editor.select("face", Array.from({ length: 300 }, (_, id) => id));
  await editor.press("h");
  assert.deepEqual([await hidden(), ...(await selected())], [300, "face", 0]);
  await editor.frames(3);
  const rect = (await editor.state()).view.rect;
  const after = await editor.screenshot("faces hidden");
  assert.ok(after.difference(before, rect) > 500, "hidden faces aren't drawn");
  await editor.press("Control+a");
  assert.deepEqual(await selected(), ["face", faces - 300]);
  await editor.click("Reveal", "button");
  assert.equal(await hidden(), 0);
  await editor.run({ op: "select-elements", faces: [5, 6] });
  await editor.press("/");
  assert.equal(await hidden(), faces - 2);
  await editor.press("/");
  assert.equal(await hidden(), 0);

  const outcome = await editor.run({ op: "select-sharp-edges", angle: 10, mode: "extend" });
  assert.match(outcome.message, /^Select sharp edges: .* edges found$/);
  await editor.run({ op: "name-selection", name: "Sharp" });
  const count = (await selected())[1];
  const [object] = (await editor.state()).document.objects;
  assert.deepEqual(object.selections, [{ name: "Sharp", kind: "edge", count }]);
});
