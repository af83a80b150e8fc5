// Saving to the file that was opened, by handles as the browser's dialog and the system give them. Here they are of files in
// the origin private file system, which need no dialog.

import assert from "node:assert/strict";

import { SMALL, editorTest } from "./harness.mjs";
import { grid } from "./support/meshes.mjs";

const once = { renderers: ["webgl2"], sizes: [SMALL] };

/** Makes a file of this name, which the page can choose in its dialog. */
const offer = (editor, name, text) => editor.page.evaluate(async ([name, text]) => {
  const root = await navigator.storage.getDirectory();
  const handle = await root.getFileHandle(name, { create: true });
  const writable = await handle.createWritable();
  await writable.write(text);
  await writable.close();
  window.showOpenFilePicker = async () => [handle];
}, [name, text]);

const content = (editor, name) => editor.page.evaluate(async (name) => {
  const root = await navigator.storage.getDirectory();
  return (await (await root.getFileHandle(name)).getFile()).text();
}, name);

const faces = (text) => text.split("\n").filter((line) => line.startsWith("f ")).length;

async function openOffered(editor, name) {
  await editor.click("Open…", "button");
  await editor.until("the file is open", async () => (await editor.state()).document.name === name);
}

editorTest("save writes to the file that was opened", once, async (editor) => {
  const downloads = [];
  editor.page.on("download", (download) => downloads.push(download));
  await offer(editor, "part.obj", grid(2, 2));
  await openOffered(editor, "part");
  await editor.run({ op: "poke-faces", faces: [0] });
  assert.equal((await editor.state()).document.dirty, true);
  await editor.press("Control+s");
  await editor.until("the file is written", async () => faces(await content(editor, "part.obj")) === 7);
  await editor.until("nothing is unsaved", async () => (await editor.state()).document.dirty === false);
  assert.deepEqual(downloads, []);

  // The file of a document that undo has brought back stays as it is.
  await editor.page.keyboard.press("Control+z");
  await editor.until("the edit is undone", async () => (await editor.state()).document.faces === 4);
  await editor.undo();
  assert.notEqual((await editor.state()).document.name, "part");
  await editor.press("Control+s");
  await editor.find("File name");
  await editor.press("Escape");
  assert.equal(faces(await content(editor, "part.obj")), 7);
});

editorTest("after a reload, save still writes to the file", once, async (editor) => {
  await offer(editor, "part.obj", grid(2, 2));
  await openOffered(editor, "part");
  await editor.run({ op: "poke-faces", faces: [0] });
  await editor.page.waitForTimeout(1000);
  await editor.page.reload();
  await editor.page.evaluate(() => window.meshwright.ready);
  await editor.until("the document is back", async () => (await editor.state()).document.name === "part");
  // What the file is saved to is read from the browser's storage meanwhile.
  await editor.page.waitForTimeout(1000);
  await editor.press("Control+s");
  await editor.until("the file is written", async () => faces(await content(editor, "part.obj")) === 7);
});

editorTest("a file that may not be written is said not to be, and stays", once, async (editor) => {
  await offer(editor, "part.obj", grid(2, 2));
  await openOffered(editor, "part");
  await editor.run({ op: "poke-faces", faces: [0] });
  await editor.page.evaluate(() => {
    FileSystemFileHandle.prototype.requestPermission = async () => "denied";
  });
  await editor.press("Control+s");
  const said = async () => (await editor.ui()).some(({ role, name }) => role === "alert" && /not allowed/.test(name));
  await editor.until("the reason is said", said);
  assert.equal(faces(await content(editor, "part.obj")), 4);
  assert.equal((await editor.state()).document.dirty, true);
});

editorTest("files that the system opens with the installed page arrive", once, async (editor) => {
  await offer(editor, "launched.obj", grid(3, 1));
  // As a browser does that has such a queue: it keeps the files until the page asks for them.
  await editor.context.addInitScript(() => {
    const launch = async (consumer) => {
      const root = await navigator.storage.getDirectory();
      consumer({ files: [await root.getFileHandle("launched.obj")] });
    };
    Object.defineProperty(window, "launchQueue", { value: { setConsumer: launch } });
  });
  await editor.page.reload();
  await editor.ready();
  await editor.until("the file is open", async () => (await editor.state()).document.name === "launched");
  await editor.run({ op: "poke-faces", faces: [0] });
  await editor.press("Control+s");
  await editor.until("the file is written", async () => faces(await content(editor, "launched.obj")) === 6);
});
