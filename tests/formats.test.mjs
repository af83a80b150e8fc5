// Opening files of every format whatever their names, and from other sites.

import assert from "node:assert/strict";
import { createServer } from "node:http";

import { SMALL, editorTest, openPage } from "./harness.mjs";
import { TWO_COLORS_OBJ, TWO_COLORS_MTL, grid } from "./support/meshes.mjs";

const once = { renderers: ["webgl2"], sizes: [SMALL] };
const CURVE = "4\n0 0\n1 2\n3 2\n4 0\n";

/** The formats, with the number of faces of a red cube saved in each, and whether its colour is kept. */
const FORMATS = [
  { format: "ply", faces: 6, color: true },
  { format: "stl", faces: 12, color: false },
  { format: "off", faces: 6, color: true },
  { format: "dae", faces: 6, color: true },
  { format: "glb", faces: 12, color: true },
  { format: "gltf", faces: 12, color: true },
];

const name = async (editor) => (await editor.state()).document.name;

editorTest("a dropped file of every format is recognised by its content", once, async (editor) => {
  await editor.run({ op: "set-face-color", faces: [0, 1, 2, 3, 4, 5], color: "#ff0000" });
  const cube = (await editor.state()).document;
  const files = [];
  for (const { format, ...rest } of FORMATS) files.push({ format, content: await editor.export(format), ...rest });
  for (const { format, content, faces, color } of files) {
    // The second time under a name without an extension.
    for (const file of [`from-${format}.${format}`, `nameless-${format}`]) {
      await editor.drop({ name: file, content });
      await editor.until(`${file} is open`, async () => (await name(editor)) === file.replace(/\.\w+$/, ""));
      const { document } = await editor.state();
      assert.equal(document.vertices, cube.vertices, `${file}: corners that are one vertex are one again`);
      assert.equal(document.faces, faces, file);
      assert.equal(document.euler, 2, file);
      assert.equal(document.boundary_loops, 0, file);
      if (color) assert.equal((await editor.element("face", 0)).color, "#ff0000", file);
    }
  }

  // Several files at once: a mesh, and one with its materials. Then broken files, which change nothing.
  await editor.drop(
    { name: "colors.mtl", content: TWO_COLORS_MTL },
    { name: "two.obj", content: TWO_COLORS_OBJ },
    { name: "sheet.obj", content: grid(2, 2) },
  );
  await editor.until("all are open", async () => (await editor.state()).document.objects.length === 2);
  const opened = (await editor.state()).document;
  assert.deepEqual(opened.objects.map((object) => object.faces).sort(), [2, 4]);

  const before = await editor.export("json");
  for (const [file, content] of [
    ["broken.ply", "ply\nformat ascii 1.0\nelement vertex many\n"],
    ["broken.stl", Buffer.alloc(90, 7)],
    ["broken.off", "OFF\nthree 1 0\n"],
    ["broken.dae", "<COLLADA><library_geometries></COLLADA>"],
    ["broken.glb", "glTF\u0002\0\0\0"],
  ]) {
    await editor.drop({ name: file, content });
    await editor.until(`a message names ${file}`, async () =>
      (await editor.ui()).some((node) => node.role === "alert" && node.name.includes(file)));
    assert.deepEqual(await editor.export("json"), before, `${file} changes nothing`);
  }
});

/** A server of another site, which may let this site read its files or not. */
async function otherSite(answer) {
  const server = createServer(answer);
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return {
    url: `http://127.0.0.1:${server.address().port}/`,
    stop: () => new Promise((done) => {
      server.close(done);
      server.closeAllConnections();
    }),
  };
}

/** A triangle as a glTF whose data is in a companion file. */
function triangleGltf(uri) {
  const json = JSON.stringify({
    asset: { version: "2.0" },
    buffers: [{ uri: encodeURIComponent(uri), byteLength: 36 }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3", min: [0, 0, 0], max: [1, 1, 0] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  });
  return { json, data: Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer) };
}

const open = { "access-control-allow-origin": "*" };

/** Opens the page with a `?model=` of another site, and checks it. */
async function asking(t, answer, path, check) {
  const other = await otherSite(answer);
  const query = `?model=${encodeURIComponent(other.url + path)}`;
  const editor = await openPage({ renderer: "webgl2", size: SMALL, query, label: t.name });
  try {
    await editor.ready();
    await check(editor, other);
  } finally {
    await editor.close();
    await other.stop();
  }
}

const alert = (editor, pattern) => editor.until(`a message that matches ${pattern}`, async () =>
  (await editor.ui()).find((node) => node.role === "alert" && pattern.test(node.name)));

editorTest("?model= opens a file of another site", once, async (_, t) => {
  const serve = (request, response) => response.writeHead(200, open).end(grid(4, 3));
  await asking(t, serve, "models/my%20sheet.obj", async (editor) => {
    await editor.until("it is open", async () => (await name(editor)) === "my sheet");
    assert.equal((await editor.state()).document.faces, 12);
    assert.equal((await editor.state()).document.dirty, false);
    editor.assertNoErrors();
  });

  // A server that doesn't allow other sites, and one without the file.
  const closed = (request, response) => response.writeHead(200).end(grid(4, 3));
  await asking(t, closed, "a.obj", async (editor) => {
    editor.expectErrors(/CORS|Failed to load resource/);
    const { name: text } = await alert(editor, /a\.obj could not be fetched/);
    assert.match(text, /doesn't allow pages of other sites.*Access-Control-Allow-Origin/);
    assert.match(text, /drop it here/);
    assert.equal((await editor.state()).document.faces, 6, "the cube stays");
    assert.deepEqual((await editor.state()).jobs, []);
    editor.assertNoErrors();
  });
  const none = (request, response) => response.writeHead(404, open).end();
  await asking(t, none, "gone.obj", async (editor) => {
    editor.expectErrors(/404/);
    await alert(editor, /gone\.obj could not be fetched: the server answered 404/);
    assert.equal((await editor.state()).document.faces, 6);
  });

  // Companion files are fetched from the address that they are relative to.
  const OBJ = TWO_COLORS_OBJ.replace(/mtllib .*/, "mtllib ../materials/my%23 colors.mtl");
  const asked = [];
  const shelf = (files) => (request, response) => {
    asked.push(request.url);
    const file = files[request.url];
    if (file === undefined) response.writeHead(404, open).end();
    else response.writeHead(200, file.closed ? {} : open).end(file.content ?? file);
  };
  const opened = async (editor, file) => editor.until(`${file} is open`, async () => (await name(editor)) === file);
  const said = async (editor) => (await editor.state()).messages.map(({ text }) => text).join("\n");
  const twoColors = { "/a/two.obj?v=1": OBJ, "/materials/my%2523%20colors.mtl": TWO_COLORS_MTL };
  await asking(t, shelf(twoColors), "a/two.obj?v=1", async (editor) => {
    await opened(editor, "two");
    assert.equal((await editor.element("face", 0)).color, "#ff0000");
    assert.doesNotMatch(await said(editor), /which belongs to/);
    assert.ok(asked.every((path) => !path.endsWith("/my%2523")), `a name with blanks is one: ${asked}`);
    assert.deepEqual((await editor.state()).jobs, []);
  });
  // A companion file that is missing or may not be read gives a note.
  await asking(t, shelf({ "/two.obj": TWO_COLORS_OBJ }), "two.obj", async (editor) => {
    editor.expectErrors(/404/);
    await opened(editor, "two");
    await alert(editor, /colors\.mtl, which belongs to two\.obj, could not be fetched: the server answered 404/);
    assert.match(await said(editor), /colors\.mtl, which belongs to two\.obj, could not be fetched/);
    editor.assertNoErrors();
  });
  const locked = { "/two.obj": TWO_COLORS_OBJ, "/colors.mtl": { content: TWO_COLORS_MTL, closed: true } };
  await asking(t, shelf(locked), "two.obj", async (editor) => {
    editor.expectErrors(/CORS|Failed to load resource/);
    await opened(editor, "two");
    await alert(editor, /colors\.mtl, which belongs to two\.obj, .*Access-Control-Allow-Origin/);
    editor.assertNoErrors();
  });
  // A model can't make the page fetch from a third site.
  const elsewhere = TWO_COLORS_OBJ.replace(/mtllib .*/, "mtllib //other.example/colors.mtl");
  await asking(t, shelf({ "/two.obj": elsewhere }), "two.obj", async (editor) => {
    await opened(editor, "two");
    await alert(editor, /other\.example\/colors\.mtl, which belongs to two\.obj, does not lie beside it/);
    editor.assertNoErrors();
  });
  // A glTF with its data, and one whose data is missing.
  const gltf = triangleGltf("my data.bin");
  await asking(t, shelf({ "/one.gltf": gltf.json, "/my%20data.bin": gltf.data }), "one.gltf", async (editor) => {
    await opened(editor, "one");
    assert.equal((await editor.state()).document.faces, 1);
    editor.assertNoErrors();
  });
  await asking(t, shelf({ "/one.gltf": gltf.json }), "one.gltf", async (editor) => {
    editor.expectErrors(/404/);
    await alert(editor, /my data\.bin, which holds its data and was not given.*the server answered 404/s);
    assert.equal((await editor.state()).document.faces, 6, "the cube stays");
    editor.assertNoErrors();
  });

  // A slow download can be cancelled.
  const slow = (request, response) => response.writeHead(200, { ...open, "content-length": 1e6 }).write("v 0 0 0\n");
  await asking(t, slow, "slow.obj", async (editor) => {
    await editor.find("Fetch slow.obj", "progressIndicator");
    await editor.click("Cancel Fetch slow.obj", "button");
    assert.deepEqual((await editor.state()).jobs, []);
    assert.equal((await editor.state()).document.faces, 6);
    editor.assertNoErrors();
  });

  // Addresses that can't be fetched.
  for (const [query, why] of [
    ["?model=http://", /"http:\/\/" after `\?model=` is not the address/],
    ["?model=file:///c:/a.obj", /can't be fetched: a page reads addresses that begin with http/],
  ]) {
    const editor = await openPage({ renderer: "webgl2", size: SMALL, query, label: t.name });
    await editor.ready();
    await alert(editor, why);
    await editor.close();
  }
});
