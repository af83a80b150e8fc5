// The interface's scale and the page's layouts: places stay right, and both come back on the next visit.

import assert from "node:assert/strict";

import { DESKTOP, editorTest } from "./harness.mjs";

const once = { renderers: ["webgl2"], sizes: [DESKTOP] };

/** Chooses an entry of a submenu of the View menu. */
async function view(editor, submenu, entry) {
  await editor.click("View", "button");
  await editor.click(submenu, "button");
  await editor.click(entry);
  await editor.frames(6);
}

/** Where the viewport is, in CSS pixels, according to the state and to the accessibility tree. */
async function viewport(editor) {
  const { rect } = (await editor.state()).view;
  const { rect: shown } = await editor.find("Viewport", "canvas");
  for (const at of [0, 1, 2, 3]) assert.ok(Math.abs(rect[at] - shown[at]) < 1, `${rect} is not ${shown}`);
  return rect;
}

/** Clicks where `project` says that a vertex is, and says whether that selects it. */
async function clickVertex(editor, id) {
  await editor.clickAt(await editor.project((await editor.element("vertex", id)).position));
  const { kind, ids } = (await editor.state()).selection;
  return kind === "vertex" && ids.length === 1 && ids[0] === id;
}

editorTest("the interface scales, and what is clicked is what is seen", once, async (editor) => {
  const [left, , width] = await viewport(editor);
  for (const [entry, zoom] of [["80 %", 0.8], ["150 %", 1.5]]) {
    await view(editor, "Interface scale", entry);
    const [x, y, w, h] = await viewport(editor);
    assert.ok(Math.abs(x - left * zoom) < 2, `the panels are ${zoom} times as wide: ${x}`);
    assert.ok(x + w < DESKTOP.width && y + h < DESKTOP.height, "nothing lies outside the window");
    assert.ok(zoom < 1 ? w > width : w < width);
    await editor.press("Home");
    await editor.frames(4);
    const found = [];
    for (const id of [0, 1, 2, 3, 4, 5, 6, 7]) {
      if (await clickVertex(editor, id)) found.push(id);
    }
    assert.equal(found.length, 7, `${entry}: clicks find the vertices ${found}, and one is behind the cube`);
    await editor.screenshot(entry);
  }
  await editor.page.reload();
  await editor.ready();
  const [x] = await viewport(editor);
  assert.ok(Math.abs(x - left * 1.5) < 2, "the scale is kept");
});

editorTest("layouts come back as they were left", once, async (editor) => {
  await editor.find("Go to id", "textInput");
  await view(editor, "Layout", "Model layout");
  const absent = async (name) => (await editor.ui()).every((node) => node.name !== name);
  assert.ok(await absent("Go to id"), "lists are closed");
  const [x] = await viewport(editor);
  assert.ok(x < 2, "the viewport comes first");
  await editor.screenshot("model layout");
  await editor.page.reload();
  await editor.ready();
  assert.ok(await absent("Go to id"), "and stay closed");
  await view(editor, "Layout", "Study layout");
  await editor.find("Go to id", "textInput");
});
