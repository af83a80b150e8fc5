// Opening files by drop, file picker, paste and script, and saving them.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";

import { SMALL, editorTest } from "./harness.mjs";
import { ODD_TRIANGLE, TWO_COLORS_MTL, TWO_COLORS_OBJ, grid } from "./support/meshes.mjs";
import { readsShared, shared } from "./support/shared.mjs";

/** The lines of an OBJ that define its mesh. */
function meshLines(obj) {
  return obj.toString().split("\n").filter((line) => /^[vf] /.test(line));
}

/** The state of the document as scripts see it, to compare before and after. */
async function snapshot(editor) {
  const { document, selection, history } = await editor.state();
  return { document, selection, history, obj: (await editor.export("obj")).toString() };
}

async function alerts(editor) {
  return (await editor.ui()).filter((node) => node.role === "alert").map((node) => node.name);
}

editorTest("files are dropped, picked and pasted, and broken ones change nothing", { sizes: [SMALL] }, async (editor) => {
  // Drop a file.
  await editor.drop({ name: "sheet.obj", content: grid(4, 3) });
  await editor.until("the file is open", async () => (await editor.state()).document.name === "sheet");
  const { document } = await editor.state();
  assert.equal(document.vertices, 20);
  assert.equal(document.faces, 12);
  assert.equal(document.edges, 31);
  assert.equal(document.halfedges, 62);
  assert.equal(document.boundary_loops, 1);
  assert.equal(document.euler, 1);
  assert.equal(document.dirty, false);
  await editor.find("Vertices: 20", "label");
  await editor.find("Vertex 9", "listBoxOption");
  const obj = await editor.export("obj");
  assert.deepEqual(meshLines(obj), meshLines(grid(4, 3)), "saved as it was read");

  // A broken file: the document is kept, and a message gives the reason.
  const before = await snapshot(editor);
  await editor.drop({ name: "poem.obj", content: "roses are red\nviolets are blue\n" });
  await editor.until("a message names the file", async () =>
    (await alerts(editor)).some((text) => text.includes("poem.obj") && text.includes("not an OBJ")));
  await editor.drop({ name: "picture.png", content: Buffer.from("\x89PNG\r\n\x1a\n\0\0\0\r", "latin1") });
  await editor.until("a message names the file", async () =>
    (await alerts(editor)).some((text) => text.includes("picture.png")));
  await assert.rejects(editor.open("empty.obj", ""), /empty\.obj/);
  assert.deepEqual(await snapshot(editor), before);

  // A partly broken file: the rest loads, and the report names the lines.
  const report = await editor.open("half.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
  assert.equal(report.created.faces, 1);
  assert.equal(report.warnings.length, 1);
  assert.match(report.warnings[0], /line 5/);

  // Pick files.
  const choosing = editor.page.waitForEvent("filechooser");
  await editor.click("Open…", "button");
  const chooser = await choosing;
  assert.equal(chooser.isMultiple(), true);
  const file = (name, text) => ({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
  await chooser.setFiles([file("two.obj", TWO_COLORS_OBJ), file("colors.mtl", TWO_COLORS_MTL)]);
  await editor.until("the files are open", async () => (await editor.state()).document.name === "two");
  assert.equal((await editor.element("face", 0)).color, "#ff0000");
  assert.equal((await editor.element("face", 1)).color, "#0000ff");

  // Paste a model; in a text field, text stays text.
  const paste = (text) => editor.page.evaluate((text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text", text);
    document.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  }, text);
  await editor.click("Go to id", "textInput");
  await paste("7");
  await editor.until("the field holds the text", async () => (await editor.find("Go to id")).value === "7");
  assert.equal((await editor.state()).document.name, "two");
  await editor.press("Escape");
  await paste(ODD_TRIANGLE);
  await editor.until("the text is open", async () => (await editor.state()).document.vertices === 3);
});

editorTest("a saved file opens again with the same bits and colours", { sizes: [SMALL] }, async (editor) => {
  const saved = async () => {
    const downloads = [];
    const listen = (download) => downloads.push(download);
    editor.page.on("download", listen);
    await editor.press("Control+s");
    await editor.press("Enter");
    return async (count) => {
      await editor.until(`${count} downloads`, () => downloads.length === count);
      editor.page.off("download", listen);
      return Promise.all(downloads.map(async (download) => ({
        name: download.suggestedFilename(),
        content: await readFile(await download.path()),
      })));
    };
  };

  await editor.open("odd.obj", ODD_TRIANGLE);
  await editor.run({ op: "set-vertex-position", vertex: 1, position: [1 / 3, -1e-30, 16777217] });
  assert.equal((await editor.state()).document.dirty, true);
  const [odd] = await (await saved())(1);
  assert.equal(odd.name, "odd.obj");
  assert.equal((await editor.state()).document.dirty, false);
  assert.deepEqual(odd.content, await editor.export("obj"), "the download is what scripts get");
  const positions = () => Promise.all([0, 1, 2].map(async (id) => (await editor.element("vertex", id)).position));
  const before = await positions();
  assert.deepEqual(before[1].map(Math.fround), [1 / 3, -1e-30, 16777217].map(Math.fround));
  await editor.drop(odd);
  await editor.until("the file is open again", async () => (await editor.state()).history.undo.length === 3);
  assert.deepEqual(await positions(), before);

  await editor.drop({ name: "colors.mtl", content: TWO_COLORS_MTL }, { name: "two.obj", content: TWO_COLORS_OBJ });
  await editor.until("the files are open", async () => (await editor.state()).document.name === "two");
  await editor.run({ op: "set-face-color", faces: [1], color: "#12abef" });
  const files = await (await saved())(2);
  assert.deepEqual(files.map((file) => file.name).sort(), ["two.mtl", "two.obj"]);
  await editor.undo();
  assert.equal((await editor.element("face", 1)).color, "#0000ff");
  await editor.drop(...files);
  await editor.until("the colour is back", async () => (await editor.element("face", 1)).color === "#12abef");
  assert.equal((await editor.element("face", 0)).color, "#ff0000");
  assert.equal((await editor.element("face", 0)).corners.length, 4);
});

const models = { ...readsShared, renderers: ["webgpu"], sizes: [SMALL] };
editorTest("real models are opened, drawn and saved", models, async (editor) => {
  const path = shared("models/common/cow.obj");
  const cow = await readFile(path);
  await editor.drop(path);
  await editor.until("the cow is open", async () => (await editor.state()).document.name === "cow");
  assert.equal((await editor.state()).document.faces, 5804);
  const faces = (obj) => obj.toString().match(/^f /gm).length;
  assert.equal(faces(await editor.export("obj")), faces(cow));
  await editor.frames(3);
  await editor.screenshot("cow");

  const opened = await editor.open("spot.obj", await readFile(shared("models/common/spot_quadrangulated.obj")));
  assert.deepEqual(opened.created, { vertices: 2930, edges: 5856, faces: 2928 });
  await editor.run({ op: "subdivide-catmull-clark" });
  assert.equal((await editor.state()).document.faces, 4 * 2928);
  await editor.frames(3);
  await editor.screenshot("spot subdivided");
});
