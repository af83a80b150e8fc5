// A first visit: the welcome view offers where to start, leaves the model free, and goes away with the first action.

import assert from "node:assert/strict";

import { DESKTOP, PHONE, editorTest } from "./harness.mjs";

const isShown = async (editor) => (await editor.ui()).some(({ name }) => name === "Close welcome");

editorTest("the first click goes to the model below the welcome view", { welcome: true, sizes: [DESKTOP, PHONE] }, async (editor) => {
  await editor.find("Start with Mug", "button");
  await editor.frames(20);
  await editor.screenshot("welcome");
  const { document, history } = await editor.state();
  assert.equal(document.faces, 6, "the document is the cube");
  assert.deepEqual(history.undo, []);
  await editor.clickAt(await editor.project([0, 0.3, 1]));
  assert.equal((await editor.state()).selection.ids.length, 1, "the click selects");
  assert.equal(await isShown(editor), false);
});

editorTest("a sample opens from the welcome view and undo brings the cube back", { welcome: true }, async (editor) => {
  await editor.click("Start with Mug", "button");
  await editor.until("the mug is open", async () => (await editor.state()).document.name === "Mug");
  assert.equal(await isShown(editor), false);
  await editor.frames(10);
  await editor.screenshot("mug");
  await editor.press("Control+z");
  assert.equal((await editor.state()).document.faces, 6);
});

editorTest("a script and a key close the welcome view", { welcome: true }, async (editor) => {
  assert.equal(await isShown(editor), true);
  await editor.select("face", [0]);
  await editor.frames();
  assert.equal(await isShown(editor), false);
  await editor.click("Welcome", "button");
  assert.equal(await isShown(editor), true);
  await editor.press("Escape");
  assert.equal(await isShown(editor), false);
});
