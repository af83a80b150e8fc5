// Saving in every format: what the dialog says is lost, and what comes back.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdir, mkdtemp, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { promisify } from "node:util";

import { DESKTOP, PHONE, SMALL, editorTest } from "./harness.mjs";
import { TWO_COLORS_MTL, TWO_COLORS_OBJ } from "./support/meshes.mjs";
import { cli } from "./support/packages.mjs";

/** Runs `act`, which saves `count` files, and gives those. */
async function downloads(editor, count, act) {
  const seen = [];
  const listen = (download) => seen.push(download);
  editor.page.on("download", listen);
  await act();
  await editor.until(`${count} downloads`, () => seen.length === count);
  editor.page.off("download", listen);
  return Promise.all(seen.map(async (download) => ({
    name: download.suggestedFilename(),
    content: await readFile(await download.path()),
  })));
}

const counts = async (editor) => {
  const { vertices, edges, faces, boundary_loops: loops, components, euler } = (await editor.state()).document;
  return { vertices, edges, faces, loops, components, euler };
};

// The code of each format, its name in the dialog, and the files that it saves.
const FORMATS = [
  ["obj", "OBJ", ["Torus.obj", "Torus.mtl"]],
  ["ply", "PLY", ["Torus.ply"]],
  ["ply-text", "PLY (text)", ["Torus.ply"]],
  ["stl", "STL", ["Torus.stl"]],
  ["stl-text", "STL (text)", ["Torus.stl"]],
  ["off", "OFF", ["Torus.off"]],
  ["dae", "COLLADA", ["Torus.dae"]],
  ["glb", "GLB", ["Torus.glb"]],
  ["gltf", "glTF", ["Torus.gltf", "Torus.bin"]],
  ["json", "Half-edge JSON", ["Torus.json"]],
];

const once = { renderers: ["webgl2"], sizes: [SMALL] };
editorTest("every format is saved from the dialog and opens again", once, async (editor) => {
  await editor.run({ op: "new", shape: "torus", segments: 12, tube_segments: 6 });
  await editor.run({ op: "triangulate-faces" });
  await editor.run({ op: "delete-faces", faces: [0, 1, 2] });
  await editor.run({ op: "set-face-color", faces: [7], color: "#3366cc" });
  const before = await counts(editor);
  const steps = (await editor.state()).history.undo.length;
  assert.equal(before.loops, 1);

  for (const [code, name, expected] of FORMATS) {
    const files = await downloads(editor, expected.length, async () => {
      await editor.press("Control+s");
      await editor.click("Format", "comboBox");
      await editor.click(name, "button");
      await editor.click("Save", "button");
    });
    assert.deepEqual(files.map((file) => file.name), expected, name);
    // Scripts get the same bytes, or a single self-contained file where the dialog saves two.
    const scripted = await editor.export(code);
    if (code === "gltf") {
      await editor.drop({ name: "Torus.gltf", content: scripted });
      await editor.until("it opens alone", async () => (await editor.state()).history.undo.length === steps + 1);
      assert.deepEqual(await counts(editor), before, `${name} for scripts`);
      await editor.undo();
    } else {
      assert.ok(scripted.equals(files[0].content), `${name} for scripts`);
    }
    if (code === "json") {
      const { positions, faces, edges } = JSON.parse(scripted.toString());
      assert.deepEqual([positions.length, edges.length, faces.length], [before.vertices, before.edges, before.faces]);
      continue;
    }
    await editor.drop(...files);
    await editor.until(`${name} opens`, async () => (await editor.state()).history.undo.length === steps + 1);
    assert.deepEqual(await counts(editor), before, name);
    const { document } = await editor.state();
    assert.equal(document.name, "Torus");
    const painted = await editor.page.evaluate((faces) => Array.from({ length: faces }, (_, id) =>
      window.meshwright.element("face", id)).filter((face) => face.color === "#3366cc").length, before.faces);
    assert.equal(painted, code.startsWith("stl") ? 0 : 1, `${name}: the colour`);
    await editor.undo();
  }
});

/** Documents of each kind, as files, with the code, name and extension of each format that holds them. */
const DOCUMENTS = [
  {
    files: [{ name: "two.obj", content: TWO_COLORS_OBJ }, { name: "colors.mtl", content: TWO_COLORS_MTL }],
    formats: FORMATS.map(([code, name, [file]]) => [code, name, file.replace(/.*\./, "")]),
  },
  { files: [{ name: "arc.bzc", content: "4\n0 0  1 2  3 2  4 0\n" }], formats: [["bzc", "BZC", "bzc"]] },
  {
    files: [{
      name: "saddle.bez",
      content: `1\n${[0, 1, 2, 3].flatMap((y) => [0, 1, 2, 3].map((x) => `${x} ${y} ${x * y}`)).join("\n")}\n`,
    }],
    formats: [["bez", "BEZ", "bez"]],
  },
];

/** The files that the command line writes when it converts the first of some files, by name. */
async function converted(files, code, extension) {
  const folder = await mkdtemp(join(tmpdir(), "meshwright-"));
  try {
    for (const { name, content } of files) await writeFile(join(folder, name), content);
    const stem = files[0].name.replace(/\.\w+$/, "");
    const out = join(folder, "out");
    await mkdir(out);
    const target = join(out, `${stem}.${extension}`);
    await promisify(execFile)(cli, ["convert", join(folder, files[0].name), target, "--format", code]);
    const names = await readdir(out);
    return new Map(await Promise.all(names.map(async (name) => [name, await readFile(join(out, name))])));
  } finally {
    await rm(folder, { recursive: true });
  }
}

editorTest("every format has the bytes of the command line", once, async (editor) => {
  // All formats that the command line knows are compared, but for projects, which hold the history too.
  const { stderr } = await promisify(execFile)(cli, ["convert", "a.obj", "b", "--format", "?"]).catch((error) => error);
  const codes = stderr.match(/the codes are (.*)/)[1].split(", ").filter((code) => code !== "meshwright").toSorted();
  assert.deepEqual(DOCUMENTS.flatMap(({ formats }) => formats.map(([code]) => code)).toSorted(), codes);

  for (const { files, formats } of DOCUMENTS) {
    await editor.drop(...files);
    const stem = files[0].name.replace(/\.\w+$/, "");
    await editor.until(`${stem} is open`, async () => (await editor.state()).document.name === stem);
    for (const [code, name, extension] of formats) {
      const expected = await converted(files, code, extension);
      const saved = await downloads(editor, expected.size, async () => {
        await editor.press("Control+s");
        await editor.click("Format", "comboBox");
        await editor.click(name, "button");
        await editor.click("Save", "button");
      });
      assert.deepEqual(saved.map((file) => file.name).toSorted(), [...expected.keys()].toSorted(), code);
      for (const file of saved) {
        assert.ok(file.content.equals(expected.get(file.name)), `${code}: ${file.name} differs`);
      }
    }
  }
});

editorTest("scripts open and export all files of a model", once, async (editor) => {
  const api = (name, ...args) => editor.page.evaluate(async ([name, args]) => {
    const answer = await window.meshwright[name](...args);
    return Array.isArray(answer) ? answer.map(({ name, content }) => [name, content.length]) : answer;
  }, [name, args]);
  const opened = await api("openFiles", [
    { name: "two.obj", content: TWO_COLORS_OBJ }, { name: "colors.mtl", content: TWO_COLORS_MTL },
  ]);
  assert.equal(opened.created.faces, 2);
  assert.equal((await editor.element("face", 0)).color, "#ff0000");
  assert.deepEqual((await api("exportFiles", "obj")).map(([name]) => name), ["two.obj", "two.mtl"]);
  const gltf = await api("exportFiles", "gltf");
  assert.deepEqual(gltf.map(([name]) => name), ["two.gltf", "two.bin"]);
  assert.ok(gltf.every(([, length]) => length > 50));
  await assert.rejects(editor.export("doc"), /"doc" is not a format.*obj, ply, ply-text, stl/);
  await assert.rejects(api("openFiles", []), /array of \{name, content\}/);
  await assert.rejects(api("openFiles", [{ name: "a.obj" }]), /content as a string/);
});

const both = { sizes: [DESKTOP, PHONE] };
editorTest("the dialog lists what a format cannot hold before saving", both, async (editor) => {
  await editor.run({ op: "set-face-color", faces: [0], color: "#ff0000" });
  await editor.run({ op: "set-crease", edges: [0], sharpness: 2 });
  if (editor.size.touch) {
    await editor.click("Save…", "button");
  } else {
    await editor.click("File", "button");
    await editor.click(/^Save…/, "button");
  }
  await editor.click("Format", "comboBox");
  await editor.screenshot("formats");
  await editor.click("STL", "button");
  await editor.find("STL holds triangles only: 6 polygons are cut into triangles.", "label");
  await editor.find("STL holds no creases: 1 crease is lost.", "label");
  const { width, height } = editor.size;
  for (const { rect: [x, y, w, h], name } of await editor.ui()) {
    assert.ok(x >= -1 && y >= -1 && x + w <= width + 1 && y + h <= height + 1, `${name} is cut off`);
  }
  await editor.screenshot("losses");
  await editor.click("Cancel", "button");
  assert.equal((await editor.ui()).some((node) => node.name === "File name"), false);
  assert.equal((await editor.state()).document.dirty, true);
});
