// Faults that people met while trying the editor, each as they met it.

import assert from "node:assert/strict";

import { DESKTOP, PHONE, SMALL, editorTest } from "./harness.mjs";
import { grid } from "./support/meshes.mjs";
import { contrast } from "./support/colors.mjs";

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

editorTest("Separate says what to choose, and separates it", { sizes: [DESKTOP] }, async (editor) => {
  await editor.click("Mesh", "button");
  const separate = await editor.find(/^Separate/, "button");
  assert.equal(separate.disabled, true);
  assert.match(separate.description, /select/i);
  await editor.press("Escape");
  // Its key, and Enter in the palette, say the same and do nothing.
  await editor.press("Shift+P");
  assert.deepEqual(await refusals(editor), [separate.description]);
  await editor.choose("Separate");
  assert.ok(await editor.find("Find a command", "textInput"), "another command can be chosen");
  await editor.press("Escape");
  assert.deepEqual(await undoable(editor), []);

  await editor.select("face", [0]);
  await editor.press("Shift+P");
  await editor.click("Separate", "button");
  await editor.until("there are two objects", async () => (await editor.state()).document.objects.length === 2);
  assert.deepEqual((await editor.state()).document.objects.map(({ faces }) => faces).sort(), [1, 5]);
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

editorTest("the save dialog keeps the name it was given", { sizes }, async (editor) => {
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

/** The pixels of a control that stand out from white as marks must. */
async function marked(editor, name, role) {
  const { rect } = await editor.find(name, role);
  const picture = await editor.screenshot(name);
  return { picture, rect, count: picture.count((color) => contrast(color, [255, 255, 255]) >= 3, rect) };
}

editorTest("a white swatch is outlined on a white page", { sizes: [DESKTOP] }, async (editor) => {
  await editor.choose("Light theme");
  await editor.run({ op: "set-face-color", faces: [0], color: "#ffffff" });
  await editor.select("face", [0]);
  await editor.frames(3);
  const well = await marked(editor, "Face colour", "colorWell");
  const [x, y, width, height] = well.rect;
  assert.deepEqual(well.picture.at(x + width / 2, y + height / 2), [255, 255, 255], "the colour itself");
  const around = 2 * (width + height);
  assert.ok(well.count > 0.7 * around, `${well.count} of ${around} pixels around the button`);

  await editor.click("Face colour", "colorWell");
  await editor.page.mouse.move(5, 400);
  await editor.frames(3);
  const swatch = await marked(editor, "#ffffff", "button");
  const edge = 2 * (swatch.rect[2] + swatch.rect[3]);
  assert.ok(swatch.count > 0.7 * edge, `${swatch.count} of ${edge} pixels around the swatch`);
});

editorTest("what is told of a curve names no patch", { sizes: [DESKTOP] }, async (editor) => {
  await editor.drop({ name: "arc.bzc", content: "4\n0 0  1 2  3 2  4 0\n" });
  await editor.until("the curve is open", async () => (await editor.state()).document.name === "arc");
  await editor.frames(3);
  const leaks = async (when) => {
    const texts = (await editor.ui()).flatMap(({ name, value, description }) => [name, String(value ?? ""), description ?? ""]);
    assert.deepEqual(texts.filter((text) => /\bpatch: |for a curve|\bnone\b/i.test(text)), [], when);
  };
  await leaks("at first");
  const from = await editor.project([1, 2, 0]);
  await editor.drag(from, [from[0] - 30, from[1] + 40]);
  assert.equal((await undoable(editor)).length, 2);
  await leaks("after a point was moved, which can be adjusted");
  await editor.choose("Add control point");
  await leaks("after a point was added");
  await editor.choose("Delete control point");
  await leaks("after a point was deleted");
});
