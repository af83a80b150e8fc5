// Flying with real keys and a real mouse.

import assert from "node:assert/strict";

import { SMALL, editorTest } from "./harness.mjs";

const view = async (editor) => (await editor.state()).view;

/** Where the eye is, and the direction in which it looks: y points upwards. */
function seen({ target, yaw, pitch, distance }) {
  const forward = [-Math.sin(yaw) * Math.cos(pitch), -Math.sin(pitch), -Math.cos(yaw) * Math.cos(pitch)];
  return { eye: target.map((t, axis) => t - forward[axis] * distance), forward };
}

const minus = (a, b) => a.map((x, axis) => x - b[axis]);
const dot = (a, b) => a.reduce((sum, x, axis) => sum + x * b[axis], 0);

/** Holds a key for some frames; returns how far the eye has moved. */
async function hold(editor, key) {
  const before = seen(await view(editor)).eye;
  await editor.page.keyboard.down(key);
  await editor.frames(8);
  await editor.page.keyboard.up(key);
  await editor.frames(2);
  return minus(seen(await view(editor)).eye, before);
}

async function takeOff(editor) {
  const [x, y] = await editor.project([0, 0, 0]);
  await editor.page.mouse.move(x, y);
  await editor.frames(2);
  await editor.press("Shift+Backquote");
  await editor.frames(4);
}

editorTest("Shift+` flies with W, A, S, D and the pointer, and Escape flies back", { sizes: [SMALL] }, async (editor) => {
  const before = await view(editor);
  const steps = (await editor.state()).history.undo.length;
  await takeOff(editor);
  await editor.screenshot("flying");
  const { forward } = seen(before);
  const ahead = await hold(editor, "w");
  const length = Math.hypot(...ahead);
  assert.ok(length > 0.01, `W moved the eye by ${ahead}`);
  assert.ok(dot(ahead, forward) > 0.999 * length, `W flies forward: ${ahead}`);
  const back = await hold(editor, "s");
  assert.ok(dot(back, forward) < 0, `S flies backward: ${back}`);
  const left = await hold(editor, "a");
  assert.ok(Math.abs(dot(left, forward)) < 0.01 * Math.hypot(...left), `A flies sideways: ${left}`);
  const right = await hold(editor, "d");
  assert.ok(dot(left, right) < 0, "D flies the other way");
  const up = await hold(editor, "e");
  assert.ok(up[1] > 0.01 && Math.hypot(up[0], up[2]) < 1e-3, `E rises: ${up}`);

  // The pointer turns the eye where it is.
  const { eye } = seen(await view(editor));
  const yaw = (await view(editor)).yaw;
  const [x, y] = [SMALL.width / 2, SMALL.height / 2];
  await editor.page.mouse.move(x - 60, y, { steps: 3 });
  await editor.page.mouse.move(x + 60, y, { steps: 6 });
  await editor.frames(4);
  assert.notEqual((await view(editor)).yaw, yaw);
  assert.ok(Math.hypot(...minus(seen(await view(editor)).eye, eye)) < 1e-3, "the eye stays");

  await editor.press("Escape");
  await editor.frames(60);
  const after = await view(editor);
  for (const name of ["yaw", "pitch", "distance"]) assert.ok(Math.abs(after[name] - before[name]) < 1e-6, name);
  assert.ok(Math.hypot(...minus(after.target, before.target)) < 1e-6, "Escape flies back");
  assert.equal((await editor.state()).history.undo.length, steps, "keys of the flight edit nothing");
  // The keys mean again what they meant.
  assert.deepEqual((await hold(editor, "w")).map((x) => Math.abs(x) < 1e-6), [true, true, true]);
});

editorTest("a click ends the flight where the eye is, close to a surface too", { sizes: [SMALL] }, async (editor) => {
  await takeOff(editor);
  for (let i = 0; i < 12; i++) await hold(editor, "w");
  const there = seen(await view(editor)).eye;
  await editor.page.mouse.down();
  await editor.page.mouse.up();
  await editor.frames(60);
  const after = seen(await view(editor)).eye;
  assert.ok(Math.hypot(...minus(after, there)) < 1e-3, `${after} is where ${there} was`);
});
