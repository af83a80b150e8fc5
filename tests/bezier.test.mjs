// Bezier curves and surfaces: opening files, dragging control points, playing the construction, tessellating.

import assert from "node:assert/strict";

import { DESKTOP, PHONE, SMALL, editorTest } from "./harness.mjs";
import { readsShared, shared } from "./support/shared.mjs";

const CURVE = { name: "arc.bzc", content: "4\n0 0  1 2  3 2  4 0\n" };

/** Two arched patches that share a border, as a .bez file. */
function arches() {
  const patch = (left) => [0, 1, 2, 3].map((row) => [0, 1, 2, 3]
    .map((column) => `${left + column} ${row} ${column % 3 ? 1.2 : 0}`).join(" ")).join("\n");
  return { name: "arches.bez", content: `2\n${patch(0)}\n${patch(3)}\n` };
}

const object = async (editor, at = 0) => (await editor.state()).document.objects[at];
const player = async (editor) => (await editor.state()).view.bezier;
const near = (a, b, within = 0.05) => a.every((value, axis) => Math.abs(value - b[axis]) < within);

async function open(editor, file) {
  await editor.drop(file);
  const name = (file.name ?? file).replace(/^.*\//, "").replace(/\.\w+$/, "");
  await editor.until(`${name} is open`, async () => (await editor.state()).document.name === name);
  await editor.frames(3);
}

/** The point at t of a cubic Bezier curve, in closed form. */
const cubic = (p, t) => [0, 1, 2].map((axis) =>
  (1 - t) ** 3 * p[0][axis] + 3 * (1 - t) ** 2 * t * p[1][axis] + 3 * (1 - t) * t ** 2 * p[2][axis] +
  t ** 3 * p[3][axis]);

/** A square around a point of the page. */
const around = ([x, y], size) => [x - size / 2, y - size / 2, size, size];

editorTest("a curve is opened, edited and played", { sizes: [SMALL] }, async (editor) => {
  await open(editor, CURVE);
  assert.deepEqual((await object(editor)).bezier, {
    kind: "curve", points: [[0, 0, 0], [1, 2, 0], [3, 2, 0], [4, 0, 0]],
  });
  await editor.screenshot("curve");

  // Drag a control point: one undo step, within the plane.
  const from = await editor.project([1, 2, 0]);
  await editor.drag(from, [from[0] - 30, from[1] + 40]);
  const { points } = (await object(editor)).bezier;
  assert.equal(points[1][2], 0);
  const now = await editor.project(points[1]);
  assert.ok(Math.hypot(now[0] - from[0] + 30, now[1] - from[1] - 40) < 4, `dragged to ${now}`);
  assert.equal((await editor.state()).history.undo.length, 2);

  // Show the construction level by level.
  const pictures = [];
  await editor.page.mouse.move(5, 5);
  for (const level of [1, 2, 3]) {
    await editor.press("e");
    assert.equal((await player(editor)).level, level);
    pictures.push(await editor.screenshot(`level ${level}`));
  }
  const { rect } = (await editor.state()).view;
  assert.ok(pictures[1].difference(pictures[0], rect) > 50 && pictures[2].difference(pictures[1], rect) > 20);
  // The last level is the point of the closed form.
  const at = await editor.project(cubic(points, 0.5));
  assert.ok(pictures[2].difference(pictures[1], around(at, 16)) > 20, "the last level is the point on the curve");
  await editor.press("c");
  assert.equal((await player(editor)).whole, false);
  await editor.frames(2);
  const half = await editor.screenshot("half the curve");
  const far = await editor.project(cubic(points, 0.85));
  assert.ok(half.difference(pictures[2], around(far, 24)) > 10, "beyond t the curve is not drawn");
  await editor.press("c");

  // Play and pause.
  await editor.click("Play", "button");
  await editor.until("t moves", async () => (await player(editor)).t > 0.55);
  await editor.click("Pause", "button");
  const { t } = await player(editor);
  await editor.frames(5);
  assert.equal((await player(editor)).t, t);

  // Insert a point by double click, delete it with a key, elevate the degree, split, and undo everything.
  const middle = [0, 1, 2].map((axis) => (points[1][axis] + points[2][axis]) / 2);
  const [x, y] = await editor.project(middle);
  await editor.page.mouse.move(x, y);
  await editor.frames(2);
  await editor.page.mouse.dblclick(x, y);
  await editor.until("a point is added", async () => (await object(editor)).bezier.points.length === 5);
  assert.ok(near((await object(editor)).bezier.points[2], middle));
  await editor.press("Delete");
  assert.deepEqual((await object(editor)).bezier.points, points);
  await editor.click("Elevate degree", "button");
  assert.equal((await object(editor)).bezier.points.length, 5);
  await editor.undo();
  await editor.run({ op: "bezier-split", t: 0.5 });
  const [first, second] = (await editor.state()).document.objects;
  assert.ok(near(first.bezier.points[3], cubic(points, 0.5), 1e-5));
  assert.deepEqual(first.bezier.points[3], second.bezier.points[0]);
  await editor.screenshot("split");
  while (await editor.undo() !== null);
  assert.equal((await object(editor)).bezier, undefined);
});

editorTest("a surface is opened, edited, played and tessellated", { sizes: [SMALL] }, async (editor) => {
  await open(editor, arches());
  assert.deepEqual((await object(editor)).bezier, { kind: "surface", patches: 2 });
  await editor.screenshot("surface");
  const area = (await editor.state()).view.rect;

  // The construction at (u, v): three levels along the rows, then three along the column.
  await editor.page.mouse.move(5, 5);
  const before = await editor.screenshot();
  for (let level = 1; level <= 6; level += 1) {
    await editor.press("e");
    assert.equal((await player(editor)).level, level);
  }
  const constructed = await editor.screenshot("construction");
  assert.ok(constructed.difference(before, area) > 100);
  const slider = await editor.find("v", "slider");
  const [x, y, width, height] = slider.rect;
  await editor.drag([x + width * 0.3, y + height / 2], [x + width * 0.05, y + height / 2]);
  assert.ok((await player(editor)).v < 0.4);
  await editor.page.mouse.move(5, 5);
  await editor.frames(2);
  assert.ok((await editor.screenshot("another v")).difference(constructed, area) > 100);

  // Drag a point inside the first patch: the displayed mesh follows.
  const inside = await editor.page.evaluate(() => {
    for (let id = 0; ; id += 1) {
      const { position: [x, y] } = window.meshwright.element("vertex", id);
      if (Math.abs(x - 1) < 0.3 && Math.abs(y - 1) < 0.3) return id;
    }
  });
  const corner = await editor.element("vertex", inside);
  const at = await editor.project([1, 1, 1.2]);
  await editor.drag(at, [at[0] + 10, at[1] - 60]);
  assert.deepEqual((await player(editor)).chosen, { patch: 0, row: 1, column: 1 });
  assert.equal((await editor.state()).history.undo.length, 2);
  const moved = await editor.element("vertex", inside);
  assert.notDeepEqual(moved.position, corner.position);
  await editor.undo();
  assert.deepEqual((await editor.element("vertex", inside)).position, corner.position);

  // Mesh edits are refused until the surface is tessellated.
  await assert.rejects(editor.run({ op: "delete-faces", faces: [0] }), /Bezier/);
  await editor.click("Tessellate", "button");
  await editor.until("it is a mesh", async () => (await object(editor)).bezier === undefined);
  const { document } = await editor.state();
  assert.deepEqual([document.faces, document.vertices, document.boundary_loops], [128, 153, 1]);
  await editor.run({ op: "delete-faces", faces: [0] });
  await editor.screenshot("mesh");
});

const both = { sizes: [DESKTOP, PHONE] };
editorTest("the Bezier controls fit the screen", both, async (editor) => {
  const { width, height } = editor.size;
  for (const file of [CURVE, arches()]) {
    await open(editor, file);
    if (editor.size.touch) await editor.click("Inspector", "tab");
    await editor.find("Play", "button");
    for (let level = 0; level < 3; level += 1) await editor.click("Next level", "button");
    for (const { rect: [x, y, w, h], name } of await editor.ui()) {
      assert.ok(x >= -1 && y >= -1 && x + w <= width + 1 && y + h <= height + 1, `${name} is cut off`);
    }
    await editor.screenshot(file.name);
    if (editor.size.touch) await editor.click("Elements", "tab");
  }
});

const course = { ...readsShared, sizes: [SMALL], renderers: ["webgl2"] };
editorTest("the course's curves and surfaces open", course, async (editor) => {
  await open(editor, shared("models/cs184/teapot.bez"));
  const teapot = await object(editor);
  assert.equal(teapot.bezier.kind, "surface");
  await editor.screenshot("teapot");
  await editor.run({ op: "bezier-tessellate", resolution: 12 });
  const { document } = await editor.state();
  assert.ok(document.faces > 100 * teapot.bezier.patches, `${document.faces} faces`);
  await editor.screenshot("teapot as a mesh");
});
