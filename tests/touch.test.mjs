// Navigating the view with fingers, mouse and trackpad.

import assert from "node:assert/strict";

import { PHONE, SMALL, editorTest } from "./harness.mjs";
import { fingers } from "./support/fingers.mjs";

const view = async (editor) => (await editor.state()).view;

/** A place in the viewport where there is no mesh. */
async function beside(editor) {
  const { rect: [x, y, width, height] } = await view(editor);
  return [x + width / 2, y + height - 60];
}

const near = (a, b, by = 1e-6) => Math.abs(a - b) <= by;

editorTest("fingers orbit, pan and zoom the view", { renderers: ["webgl2"], sizes: [PHONE] }, async (editor) => {
  const [x, y] = await beside(editor);
  const document = JSON.stringify((await editor.state()).document);

  const first = await view(editor);
  await fingers(editor, [[x, y], [x - 70, y - 30]]);
  const turned = await view(editor);
  assert.ok(Math.abs(turned.yaw - first.yaw) > 0.1 && Math.abs(turned.pitch - first.pitch) > 0.05, "one finger turns");
  assert.deepEqual(turned.target, first.target);
  assert.equal(turned.distance, first.distance);

  await fingers(editor, [[x - 40, y], [x - 90, y]], [[x + 40, y], [x + 90, y]]);
  const near1 = await view(editor);
  assert.ok(near1.distance < turned.distance * 0.8, `spread fingers come closer: ${near1.distance}`);
  await fingers(editor, [[x - 90, y], [x - 40, y]], [[x + 90, y], [x + 40, y]]);
  const back = await view(editor);
  assert.ok(back.distance > near1.distance * 1.25, "pinching goes away");
  assert.ok(near(back.yaw, turned.yaw, 0.02) && near(back.pitch, turned.pitch, 0.02), "neither turns");

  await fingers(editor, [[x - 40, y], [x - 40, y - 80]], [[x + 40, y], [x + 40, y - 80]]);
  const moved = await view(editor);
  assert.notDeepEqual(moved.target, back.target, "two fingers together move the view");
  assert.ok(near(moved.distance, back.distance, back.distance * 0.05), "and come no closer");

  assert.equal(JSON.stringify((await editor.state()).document), document, "looking changes nothing");
  assert.deepEqual((await editor.state()).selection.ids, [], "and selects nothing");
});

editorTest("taps add to the selection while add is on", { renderers: ["webgl2"], sizes: [PHONE] }, async (editor) => {
  await editor.click("Face mode", "button");
  const middle = async (id) => {
    const corners = await Promise.all((await editor.element("face", id)).corners.map(async (corner) =>
      (await editor.element("vertex", corner)).position));
    return editor.project([0, 1, 2].map((axis) => corners.reduce((sum, p) => sum + p[axis] / corners.length, 0)));
  };
  const selected = async () => (await editor.state()).selection.ids;
  // Two faces that are seen: a tap on their middles selects them.
  const seen = [];
  for (const id of [0, 1, 2, 3, 4, 5]) {
    await editor.clickAt(await middle(id));
    if ((await selected())[0] === id) seen.push(id);
  }
  assert.ok(seen.length >= 2, `faces ${seen} are seen`);
  const [first, second] = seen;
  await editor.clickAt(await middle(first));
  await editor.click("Add to selection", "button");
  await editor.clickAt(await middle(second));
  assert.deepEqual(await selected(), [first, second].sort());
  await editor.clickAt(await beside(editor));
  assert.deepEqual(await selected(), [first, second].sort(), "a near miss keeps the selection");
  await editor.clickAt(await middle(first));
  assert.deepEqual(await selected(), [second], "a tap on a selected one removes it");
  await editor.click("Add to selection", "button");
  await editor.clickAt(await middle(first));
  assert.deepEqual(await selected(), [first]);
});

const small = { renderers: ["webgl2"], sizes: [SMALL] };
editorTest("the mouse and the trackpad orbit, pan, zoom and frame", small, async (editor) => {
  const [x, y, width, height] = (await view(editor)).rect;
  // Beside the tool bar.
  const free = [x + 70, y + height - 40];
  const to = [free[0] + 90, free[1] - 40];

  const first = await view(editor);
  await editor.drag(free, to);
  const turned = await view(editor);
  assert.notEqual(turned.yaw, first.yaw);
  assert.notEqual(turned.pitch, first.pitch);
  assert.deepEqual(turned.target, first.target, "a drag beside the mesh turns");

  await editor.drag(free, to, { button: "middle" });
  assert.notEqual((await view(editor)).yaw, turned.yaw, "so does the middle button, anywhere");

  const before = await view(editor);
  await editor.drag(free, to, { button: "right" });
  const moved = await view(editor);
  assert.notDeepEqual(moved.target, before.target, "the right button moves");
  assert.equal(moved.yaw, before.yaw);
  assert.deepEqual((await editor.ui()).filter((node) => node.name === "Select all"), [], "and opens no menu");

  // Zooming with the wheel keeps the point under the pointer in place.
  const seen = async (id) => {
    const corner = (await editor.element("vertex", id)).position;
    const at = await editor.project(corner);
    return { corner, at, inside: at[0] > x && at[0] < x + width && at[1] > y && at[1] < y + height };
  };
  const { corner, at } = (await Promise.all([0, 1, 2, 3, 4, 5, 6, 7].map(seen))).find(({ inside }) => inside);
  await editor.page.mouse.move(...at);
  await editor.frames(2);
  await editor.page.mouse.wheel(0, -240);
  await editor.until("the wheel comes closer", async () => (await view(editor)).distance < moved.distance * 0.9);
  await editor.frames(10);
  const zoomed = await editor.project(corner);
  assert.ok(Math.hypot(zoomed[0] - at[0], zoomed[1] - at[1]) < 12, `${at} went to ${zoomed}`);

  // A pinch on a trackpad arrives as a wheel event with Ctrl.
  const { distance } = await view(editor);
  await editor.page.keyboard.down("Control");
  await editor.page.mouse.wheel(0, 120);
  await editor.page.keyboard.up("Control");
  await editor.until("a pinch goes away", async () => (await view(editor)).distance > distance * 1.05);

  // Home frames the mesh: it is fully visible and fills the viewport.
  await editor.page.mouse.move(5, 5);
  await editor.press("Home");
  await editor.frames(20);
  const corners = await Promise.all([0, 1, 2, 3, 4, 5, 6, 7].map(async (id) =>
    editor.project((await editor.element("vertex", id)).position)));
  for (const [px, py] of corners) {
    assert.ok(px >= x && py >= y && px <= x + width && py <= y + height, `${px}, ${py} is outside`);
  }
  const extent = (axis) => Math.max(...corners.map((c) => c[axis])) - Math.min(...corners.map((c) => c[axis]));
  assert.ok(Math.max(extent(0) / width, extent(1) / height) > 0.4, "and fills the viewport");
});
