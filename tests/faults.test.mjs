// Faults that people met while trying the editor, each as they met it.

import assert from "node:assert/strict";

import { DESKTOP, PHONE, SMALL, editorTest } from "./harness.mjs";
import { grid } from "./support/meshes.mjs";

const sizes = [SMALL];

const undoable = async (editor) => (await editor.state()).history.undo;

const refusals = async (editor) => (await editor.ui()).filter(({ role }) => role === "alert").map(({ name }) => name);

/** Clicks into a number field and selects what it holds. */
async function enter(editor, name) {
  const { rect: [x, y, width, height] } = await editor.find(name, "spinButton");
  await editor.clickAt([x + width / 2, y + height / 2]);
  await editor.press("Control+a");
}

editorTest("decimals typed into the last operation's fields arrive whole", { sizes }, async (editor) => {
  await editor.run({ op: "bevel-edges", edges: [0], width: 0.1 });
  await enter(editor, "Width");
  // One frame after each character, as a person types.
  for (const character of "0.2") await editor.press(character);
  await editor.press("Enter");
  const { positions } = JSON.parse(await editor.export("json"));
  assert.ok(positions.flat().some((value) => Math.abs(Math.abs(value) - 0.8) < 1e-6), "0.2 from the corners");
  assert.deepEqual(await undoable(editor), ["Bevel edges"]);
  assert.deepEqual(await refusals(editor), [], "no part of the number was applied");
});

editorTest("a transform that a key started takes typed numbers", { sizes }, async (editor) => {
  await editor.select("vertex", [0, 1, 2, 3, 4, 5, 6, 7]);
  const before = JSON.parse(await editor.export("json")).positions;
  await editor.press("g");
  await editor.press("x");
  for (const character of "1/4") await editor.press(character);
  await editor.press("Enter");
  const after = JSON.parse(await editor.export("json")).positions;
  assert.deepEqual(after, before.map(([x, y, z]) => [x + 0.25, y, z]));
});

editorTest("Separate says what to choose", { renderers: ["webgl2"], sizes: [DESKTOP] }, async (editor) => {
  await editor.click("Mesh", "button");
  const separate = await editor.find(/^Separate/, "button");
  assert.equal(separate.disabled, true);
  assert.match(separate.description, /select/i);
});

editorTest("Fill hole works from an edge on the boundary, by menu, palette and panel", { sizes }, async (editor) => {
  await editor.open("open.obj", grid(3, 3));
  await editor.run({ op: "delete-faces", faces: [4] });
  const { faces } = (await editor.state()).document;
  // An edge of the hole in the middle.
  const find = async () => {
    for (let id = 0; id < 24; id += 1) {
      const edge = await editor.element("edge", id);
      const ends = await Promise.all(edge.vertices.map(async (v) => (await editor.element("vertex", v)).position));
      if (ends.every(([x, y]) => x >= 1 && x <= 2 && y >= 1 && y <= 2)) return id;
    }
    throw new Error("no edge of the hole");
  };
  const edge = await find();
  await editor.select("edge", [edge]);
  await editor.press("Control+k");
  await editor.page.keyboard.type("fill hole");
  await editor.frames(2);
  await editor.press("Enter");
  await editor.until("the hole is filled", async () => (await editor.state()).document.faces === faces + 1);
  await editor.press("Control+z");
  await editor.select("edge", [edge]);
  await editor.press("Alt+f");
  assert.equal((await editor.state()).document.faces, faces + 1, "by its key");
});

editorTest("the save dialog keeps the name it was given", { renderers: ["webgl2"], sizes }, async (editor) => {
  await editor.press("Control+s");
  const { rect: [x, y, width, height] } = await editor.find("File name", "textInput");
  await editor.clickAt([x + width / 2, y + height / 2]);
  await editor.press("Control+a");
  await editor.page.keyboard.type("mug");
  const download = editor.page.waitForEvent("download");
  await editor.click("Save", "button");
  assert.match((await download).suggestedFilename(), /^mug\./);
  await editor.press("Control+s");
  assert.equal((await editor.find("File name", "textInput")).value, "mug");
});

editorTest("keys after Escape and Ctrl+K in one slow frame go to the palette", { sizes }, async (editor) => {
  await editor.select("face", [0]);
  await editor.press("e");
  const session = await editor.context.newCDPSession(editor.page);
  await editor.page.evaluate(() => {
    // The next frame takes longer than the typing.
    requestAnimationFrame(() => { const end = performance.now() + 1500; while (performance.now() < end); });
  });
  const key = (key, code, modifiers = 0) => [
    ["rawKeyDown", key, code, modifiers], ...(key.length === 1 && !modifiers ? [["char", key, code, 0]] : []),
    ["keyUp", key, code, modifiers],
  ];
  const events = [
    ...key("Escape", "Escape"), ...key("k", "KeyK", 2), ...[..."sud"].flatMap((c) => key(c, `Key${c.toUpperCase()}`)),
  ];
  await Promise.all(events.map(([type, key, code, modifiers]) => session.send("Input.dispatchKeyEvent", {
    type, key, code, modifiers, windowsVirtualKeyCode: key === "Escape" ? 27 : key.toUpperCase().charCodeAt(0),
    ...(type === "char" ? { text: key } : {}),
  })));
  await session.detach();
  await editor.frames(4);
  assert.equal((await editor.state()).document.faces, 6, "no letter acted on the mesh");
  assert.deepEqual(await undoable(editor), []);
  const field = (await editor.ui()).find(({ role, value }) => role === "textInput" && value === "sud");
  assert.ok(field, "the letters are in the palette's field");
});

editorTest("menu rows on a phone are high enough for a finger", { sizes: [PHONE] }, async (editor) => {
  await editor.byRole("button", "Menu");
  await editor.click("Mesh", "button");
  await editor.frames(3);
  const rows = (await editor.ui()).filter(({ role, rect }) => role === "button" && rect[2] > 100);
  assert.ok(rows.length > 5);
  // The edge of the screen cuts the last row, which scrolls.
  const bottom = Math.max(...rows.map(({ rect }) => rect[1] + rect[3]));
  for (const { name, rect } of rows.filter(({ rect }) => rect[1] + rect[3] < bottom)) {
    assert.ok(rect[3] >= 43.5, `${name} is ${rect[3]} high`);
  }
});
