// Moving the selection with the gizmo, and boxes: with a real mouse.

import assert from "node:assert/strict";

import { PHONE, SMALL, editorTest } from "./harness.mjs";
import { fingers } from "./support/fingers.mjs";

const positions = async (editor) => JSON.parse(await editor.export("json")).positions;

const undoable = async (editor) => (await editor.state()).history.undo;

const middle = (points) => [0, 1, 2].map((axis) => points.reduce((sum, p) => sum + p[axis], 0) / points.length);

/** A place on the page this many points from the cube's middle, in the direction in which an axis points. */
async function along(editor, axis, points) {
  const [x, y] = await editor.project([0, 0, 0]);
  const [toX, toY] = await editor.project([0, 1, 2].map((other) => (other === axis ? 0.1 : 0)));
  const length = Math.hypot(toX - x, toY - y);
  return [x + (toX - x) / length * points, y + (toY - y) / length * points];
}

/** The length in mesh units of the gizmo's arrows at the cube's middle, which are 84 points long. */
async function arrowLength(editor) {
  const { yaw } = (await editor.state()).view;
  const [[x, y], [rightX, rightY]] = await Promise.all(
    [[0, 0, 0], [0.1 * Math.cos(yaw), 0, -0.1 * Math.sin(yaw)]].map((point) => editor.project(point)),
  );
  return 8.4 / Math.hypot(rightX - x, rightY - y);
}

editorTest("the arrows, squares, rings and boxes of the gizmo move, rotate and scale", { sizes: [SMALL] }, async (editor) => {
  const start = await positions(editor);
  await editor.select("face", [0, 1, 2, 3, 4, 5]);

  await editor.click(/^Tool: Move/, "button");
  await editor.frames(2);
  await editor.screenshot("move gizmo");
  for (const axis of [0, 1, 2]) {
    await editor.drag(await along(editor, axis, 35), await along(editor, axis, 80));
    const moved = middle(await positions(editor));
    for (const other of [0, 1, 2]) {
      if (other === axis) assert.ok(moved[other] > 0.1, `along axis ${axis}: ${moved}`);
      else assert.equal(moved[other], 0, `along axis ${axis} alone: ${moved}`);
    }
    assert.equal((await undoable(editor)).length, 1, "a drag is one step");
    await editor.press("Control+z");
    assert.deepEqual(await positions(editor), start);
  }

  const [x, y] = await editor.project([0, 0, 0]);
  const arrow = await arrowLength(editor);
  const onGizmo = (offset) => editor.project(offset.map((part) => part * arrow));
  // The square across y moves in its plane.
  await editor.drag(await onGizmo([0.42, 0, 0.42]), await onGizmo([1.1, 0, 0.1]));
  const moved = middle(await positions(editor));
  assert.ok(moved[0] > 0.2 && moved[1] === 0 && moved[2] < -0.1, `in the plane of the square: ${moved}`);
  await editor.press("Control+z");
  assert.deepEqual(await positions(editor), start);

  await editor.click(/^Tool: Rotate/, "button");
  // The ring about y, from a place in front to another.
  const { yaw } = (await editor.state()).view;
  const onRing = (angle) => onGizmo([0.9 * Math.sin(yaw + angle), 0, 0.9 * Math.cos(yaw + angle)]);
  await editor.drag(await onRing(-0.3), await onRing(0.4));
  const about = await positions(editor);
  assert.notDeepEqual(about, start);
  for (const [at, p] of about.entries()) {
    assert.ok(Math.abs(p[1] - start[at][1]) < 1e-6, `about y: ${p}`);
    assert.ok(Math.abs(Math.hypot(p[0], p[2]) - Math.SQRT2) < 1e-4, `as far from the axis as before: ${p}`);
  }
  await editor.press("Control+z");
  const ring = 84 * 1.15;
  await editor.drag([x + ring, y], [x, y + ring]);
  const turned = await positions(editor);
  assert.notDeepEqual(turned, start);
  for (const p of turned) assert.ok(Math.abs(Math.hypot(...p) - Math.sqrt(3)) < 1e-4, "a rotation keeps lengths");
  await editor.press("Control+z");

  await editor.click(/^Tool: Scale/, "button");
  await editor.drag(await along(editor, 1, 60), await along(editor, 1, 120));
  const scaled = await positions(editor);
  for (const p of scaled) assert.deepEqual([Math.abs(p[0]), Math.abs(p[2])], [1, 1]);
  assert.ok(Math.abs(Math.max(...scaled.map((p) => p[1])) - 2) < 0.1, "twice as far is twice as tall");

  // Escape in the middle of a drag leaves no trace.
  const steps = await undoable(editor);
  const from = await along(editor, 1, 60);
  await editor.page.mouse.move(...from);
  await editor.frames(2);
  await editor.page.mouse.down();
  await editor.page.mouse.move(from[0] + 30, from[1] - 40, { steps: 4 });
  await editor.frames(2);
  assert.notDeepEqual(await positions(editor), scaled);
  await editor.press("Escape");
  await editor.page.mouse.up();
  await editor.frames(2);
  assert.deepEqual(await positions(editor), scaled);
  assert.deepEqual(await undoable(editor), steps);
});

editorTest("a box selects, adds with Shift and removes with Ctrl", { sizes: [SMALL] }, async (editor) => {
  await editor.run({ op: "new", shape: "grid", columns: 4, rows: 4 });
  await editor.press("1");
  await editor.press("Alt+7");
  await editor.frames(30);
  const place = async (column, row) => {
    const { position } = await editor.element("vertex", row * 5 + column);
    return editor.project(position);
  };
  const box = async (a, b, keys = []) => {
    const [[ax, ay], [bx, by]] = [await place(...a), await place(...b)];
    const [left, right] = [Math.min(ax, bx) - 8, Math.max(ax, bx) + 8];
    const [top, bottom] = [Math.min(ay, by) - 8, Math.max(ay, by) + 8];
    for (const key of keys) await editor.page.keyboard.down(key);
    await editor.drag([left, top], [right, bottom]);
    for (const key of keys) await editor.page.keyboard.up(key);
    await editor.frames(2);
    return (await editor.state()).selection.ids;
  };
  await editor.press("Shift+B");
  const ids = (columns, rows) => rows.flatMap((row) => columns.map((column) => row * 5 + column));
  assert.deepEqual(await box([0, 0], [1, 1]), ids([0, 1], [0, 1]));
  assert.deepEqual(await box([3, 3], [4, 4], ["Shift"]), [...ids([0, 1], [0, 1]), ...ids([3, 4], [3, 4])]);
  assert.deepEqual(await box([4, 3], [4, 4], ["Control"]), [...ids([0, 1], [0, 1]), ...ids([3], [3, 4])]);
  assert.deepEqual(await box([2, 2], [2, 2]), ids([2], [2]), "without a key it replaces");
  await editor.press("Control+z");
  assert.equal((await editor.state()).selection.ids.length, 6, "each box is a step");
});

editorTest("a finger drags a live edit, and its buttons end it", { sizes: [PHONE] }, async (editor) => {
  const before = await positions(editor);
  const begin = async () => {
    await editor.select("face", [0]);
    await editor.click(/^Tool: Extrude/, "button");
    await editor.find("Apply", "button");
    const { rect: [x, y, width, height] } = (await editor.state()).view;
    const from = [x + width / 2, y + height / 2];
    await fingers(editor, [from, [from[0] + 30, from[1] - 70]]);
  };
  const camera = (await editor.state()).view.yaw;
  await begin();
  assert.equal((await editor.state()).document.faces, 10);
  const first = await positions(editor);
  assert.equal((await editor.state()).view.yaw, camera, "the finger edits, it does not turn the view");
  assert.deepEqual(await undoable(editor), [], "no step yet");
  await editor.screenshot("extruding by finger");
  await editor.click("Cancel", "button");
  assert.deepEqual(await positions(editor), before);

  await begin();
  assert.deepEqual(await positions(editor), first, "the same way gives the same amount");
  await editor.click("Apply", "button");
  assert.deepEqual(await undoable(editor), ["Extrude faces"]);
  assert.deepEqual(await positions(editor), first);
});
