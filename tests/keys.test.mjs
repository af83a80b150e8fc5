// The presets of keys, with real keys and a real mouse.

import assert from "node:assert/strict";

import { SMALL, editorTest } from "./harness.mjs";

const sizes = [SMALL];

/** Notes the page's keys; the answer tells whether the browser was kept from acting on one. */
async function watchKeys(editor) {
  await editor.page.evaluate(() => {
    window.seen = {};
    // The event on the canvas goes no further, so it is looked at later.
    window.addEventListener("keydown", (event) => {
      window.seen[(event.ctrlKey ? "Control+" : "") + event.key] = event;
    }, true);
  });
  return (key) => editor.page.evaluate((key) => window.seen[key]?.defaultPrevented, key);
}

/** Presses a key of the number pad with NumLock on, which Playwright's own keyboard has off. */
async function pressOnPad(editor, digit) {
  const session = await editor.context.newCDPSession(editor.page);
  const key = { key: digit, code: `Numpad${digit}`, location: 3, isKeypad: true, windowsVirtualKeyCode: 96 + Number(digit) };
  await session.send("Input.dispatchKeyEvent", { type: "keyDown", text: digit, ...key });
  await session.send("Input.dispatchKeyEvent", { type: "keyUp", ...key });
  await session.detach();
  await editor.frames();
}

const view = async (editor) => (await editor.state()).view;

/** A place beside the cube, and how far one can drag from there. */
async function beside(editor) {
  const { rect: [x, y, width, height] } = await view(editor);
  // Above the axes in the corner.
  return [x + width - 60, y + height - 130];
}

editorTest("the keys and the mouse of Blender", { sizes, query: "?keys=blender" }, async (editor) => {
  assert.equal((await view(editor)).keys, "blender");
  const kept = await watchKeys(editor);
  await editor.press("3");
  assert.equal((await view(editor)).list, "face");
  await editor.press("a");
  assert.equal((await editor.state()).selection.ids.length, 6);
  await editor.press("Alt+a");
  assert.equal((await editor.state()).selection.ids.length, 0);

  await pressOnPad(editor, "3");
  const side = await view(editor);
  assert.equal(side.list, "face", "the number pad has keys of its own");
  assert.ok(Math.abs(side.yaw - Math.PI / 2) < 1e-6 && Math.abs(side.pitch) < 1e-6);

  await editor.press("Control+r");
  assert.equal(await kept("Control+r"), true);
  const cut = (await editor.ui()).some(({ name }) => name?.includes("Cut, then slide"));
  assert.ok(cut, "the loop cut at the pointer, and no reload");
  await editor.press("Escape");

  await editor.select("face", [0]);
  await editor.press("s");
  await editor.press("y");
  for (const key of [".", "7", "5", "Enter"]) await editor.press(key);
  const { history } = await editor.state();
  assert.equal(history.undo.length, 1, `scaled: ${JSON.stringify(history.undo)}`);

  // Dragging beside the mesh selects; the middle button turns the view.
  await editor.press("Shift+c");
  await editor.press("1");
  await editor.press("Alt+a");
  const before = await view(editor);
  const from = await beside(editor);
  const { rect: [x, y] } = before;
  await editor.drag(from, [x + 58, y + 70]);
  assert.equal((await editor.state()).selection.ids.length, 7, "a box around what is visible");
  assert.equal((await view(editor)).yaw, before.yaw);
  await editor.drag(from, [from[0] - 60, from[1] - 20], { button: "middle" });
  assert.notEqual((await view(editor)).yaw, before.yaw);

  // In a list, Ctrl+R is the browser's.
  await editor.click("Vertex 2", "listBoxOption");
  await editor.press("Control+b");
  assert.equal(await kept("Control+b"), false);
  await editor.page.keyboard.press("Control+d");
  assert.equal(await kept("Control+d"), false, "not a key of this preset");
});

editorTest("the keys and the mouse of Maya", { sizes, query: "?keys=maya" }, async (editor) => {
  const kept = await watchKeys(editor);
  for (const [key, list] of [["F10", "edge"], ["Alt+F10", "half-edge"], ["F11", "face"], ["F9", "vertex"]]) {
    await editor.press(key);
    assert.equal((await view(editor)).list, list, key);
  }
  assert.equal(await kept("F11"), true);
  await editor.select("face", [0]);
  await editor.press("Control+e");
  await editor.press("1");
  await editor.press("Enter");
  assert.equal((await editor.state()).document.faces, 10);
  await editor.press("z");
  assert.equal((await editor.state()).document.faces, 6);

  const from = await beside(editor);
  const before = await view(editor);
  await editor.page.keyboard.down("Alt");
  await editor.drag(from, [from[0] - 60, from[1] - 20]);
  const turned = await view(editor);
  assert.notEqual(turned.yaw, before.yaw);
  await editor.drag(from, [from[0] - 60, from[1] - 20], { button: "middle" });
  const moved = await view(editor);
  assert.equal(moved.yaw, turned.yaw);
  assert.notDeepEqual(moved.target, turned.target);
  await editor.drag(from, [from[0] - 60, from[1] - 20], { button: "right" });
  await editor.page.keyboard.up("Alt");
  assert.notEqual((await view(editor)).distance, moved.distance);
});

editorTest("changed keys and the preset last", { sizes, renderers: ["webgl2"] }, async (editor) => {
  assert.equal((await view(editor)).keys, "course");
  await editor.press("F1");
  await editor.click("Find by name", "textInput");
  await editor.page.keyboard.type("upsample");
  await editor.frames();
  await editor.click("Upsample (subdivide): U");
  await editor.press("Control+u");
  await editor.find("Upsample (subdivide): Ctrl+U");
  await editor.press("Escape");
  await editor.press("Control+u");
  assert.equal((await editor.state()).document.faces, 24);
  await editor.find("Undo", "link");
  await editor.press("Control+z");
  await editor.page.reload();
  await editor.ready();
  await editor.press("u");
  assert.equal((await editor.state()).document.faces, 6);
  assert.deepEqual((await view(editor)).changed_keys, { upsample: ["Ctrl+U"] });

  await editor.click("Edit");
  await editor.click("Keys");
  await editor.click("Blender keys");
  await editor.press("Escape");
  await editor.page.reload();
  await editor.ready();
  assert.equal((await view(editor)).keys, "blender");
  await editor.press("a");
  assert.equal((await editor.state()).selection.ids.length, 8);
});
