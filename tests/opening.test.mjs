// Opening files of every format as other programs write them, and messages about files that can't be opened.

import assert from "node:assert/strict";

import { DESKTOP, PHONE, SMALL, editorTest } from "./harness.mjs";

const counts = async (editor) => {
  const { vertices, edges, faces, boundary_loops: loops } = (await editor.state()).document;
  return [vertices, edges, faces, loops];
};

const alerts = async (editor) =>
  (await editor.ui()).filter((node) => node.role === "alert").map((node) => node.name);

async function drop(editor, ...files) {
  const steps = (await editor.state()).history.undo.length;
  await editor.drop(...files);
  await editor.until(`${files[0].name} is open`, async () => (await editor.state()).history.undo.length > steps);
}

/** The counts of a square of two triangles, which each file below holds. */
const CORNERS = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]];
const TRIANGLES = [[0, 1, 2], [0, 2, 3]];
const SQUARE = [4, 5, 2, 1];

function binaryStl() {
  const bytes = Buffer.alloc(84 + 50 * TRIANGLES.length);
  bytes.writeUInt32LE(TRIANGLES.length, 80);
  TRIANGLES.forEach((corners, at) => corners.forEach((corner, i) => CORNERS[corner].forEach((value, axis) =>
    bytes.writeFloatLE(value, 84 + 50 * at + 12 + 12 * i + 4 * axis))));
  return bytes;
}

function binaryPly() {
  const header = ["ply", "format binary_big_endian 1.0", `element vertex ${CORNERS.length}`,
    "property float x", "property float y", "property float z", `element face ${TRIANGLES.length}`,
    "property list uchar int vertex_indices", "end_header", ""].join("\n");
  const body = Buffer.alloc(12 * CORNERS.length + 13 * TRIANGLES.length);
  CORNERS.flat().forEach((value, at) => body.writeFloatBE(value, 4 * at));
  TRIANGLES.forEach((corners, at) => {
    const start = 12 * CORNERS.length + 13 * at;
    body.writeUInt8(3, start);
    corners.forEach((corner, i) => body.writeInt32BE(corner, start + 1 + 4 * i));
  });
  return Buffer.concat([Buffer.from(header), body]);
}

/** Positions and indices, and a glTF that describes them; `uri` is the address of the data. */
const DATA = Buffer.concat([
  Buffer.from(new Float32Array(CORNERS.flat()).buffer), Buffer.from(new Uint16Array(TRIANGLES.flat()).buffer),
]);
const gltf = (uri) => JSON.stringify({
  asset: { version: "2.0" },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [{ mesh: 0 }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
  accessors: [
    { bufferView: 0, componentType: 5126, count: 4, type: "VEC3", min: [0, 0, 0], max: [1, 1, 0] },
    { bufferView: 1, componentType: 5123, count: 6, type: "SCALAR" },
  ],
  bufferViews: [{ buffer: 0, byteLength: 48 }, { buffer: 0, byteOffset: 48, byteLength: 12 }],
  buffers: [{ byteLength: DATA.length, ...(uri ? { uri } : {}) }],
});

function glb() {
  const pad = (bytes, fill) => Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, fill)]);
  const word = (value) => { const bytes = Buffer.alloc(4); bytes.writeUInt32LE(value); return bytes; };
  const [json, data] = [pad(Buffer.from(gltf()), " "), pad(DATA, 0)];
  return Buffer.concat([Buffer.from("glTF"), word(2), word(12 + 16 + json.length + data.length),
    word(json.length), Buffer.from("JSON"), json, word(data.length), Buffer.from("BIN\0"), data]);
}

const COLLADA = `<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g" name="square"><mesh>
<source id="p"><float_array id="pa" count="12">${CORNERS.flat().join(" ")}</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/><p>${TRIANGLES.flat().join(" ")}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>`;

const facet = (corners) => ["facet normal 0 0 1", "outer loop",
  ...corners.map((corner) => `vertex ${CORNERS[corner].join(" ")}`), "endloop", "endfacet"].join("\n");

const FILES = {
  "an OBJ": [{ name: "square.obj", content: [...CORNERS.map((p) => `v ${p.join(" ")}`),
    ...TRIANGLES.map((t) => `f ${t.map((i) => i + 1).join(" ")}`)].join("\n") }],
  "a PLY as text": [{ name: "square.ply", content: ["ply", "format ascii 1.0", "element vertex 4",
    "property float x", "property float y", "property float z", "element face 2",
    "property list uchar int vertex_indices", "end_header", ...CORNERS.map((p) => p.join(" ")),
    ...TRIANGLES.map((t) => `3 ${t.join(" ")}`), ""].join("\n") }],
  "a binary PLY": [{ name: "square.ply", content: binaryPly() }],
  "an STL as text": [{ name: "square.stl", content: `solid square\n${TRIANGLES.map(facet).join("\n")}\nendsolid\n` }],
  "a binary STL": [{ name: "square.stl", content: binaryStl() }],
  "an OFF": [{ name: "square.off", content: `OFF\n4 2 0\n${CORNERS.map((p) => p.join(" ")).join("\n")}\n${
    TRIANGLES.map((t) => `3 ${t.join(" ")}`).join("\n")}\n` }],
  "a COLLADA": [{ name: "square.dae", content: COLLADA }],
  "a GLB": [{ name: "square.glb", content: glb() }],
  "a glTF with its data inside": [{
    name: "square.gltf", content: gltf(`data:application/octet-stream;base64,${DATA.toString("base64")}`),
  }],
  "a glTF with its data beside it": [
    { name: "data.bin", content: DATA }, { name: "square.gltf", content: gltf("data.bin") },
  ],
  "a file with another's extension": [{ name: "square.obj", content: binaryPly() }],
  "a file in capitals": [{ name: "SQUARE.STL", content: binaryStl() }],
};

const once = { renderers: ["webgl2"], sizes: [SMALL] };
editorTest("a dropped file of every format opens", once, async (editor) => {
  for (const [what, files] of Object.entries(FILES)) {
    await drop(editor, ...files);
    assert.deepEqual(await counts(editor), SQUARE, what);
    const { document } = await editor.state();
    assert.equal(document.name.toLowerCase(), "square", what);
    assert.equal(document.dirty, false, what);
    await editor.undo();
    assert.equal((await editor.state()).document.faces, 6, `${what} is one step`);
  }
});

editorTest("a file that can't be opened gives a message and changes nothing", once, async (editor) => {
  await editor.run({ op: "split-edge", edge: 0 });
  const told = async () => {
    const { document, history, selection } = await editor.state();
    return { document, history, selection, mesh: (await editor.export("json")).toString() };
  };
  const before = await told();
  const wrong = [
    ["photo.jpg", "\xff\xd8\xff\xe0 JFIF", /^No material names photo\.jpg/],
    ["poem.obj", "roses are red\n", /^Could not open poem\.obj/],
    ["cut.ply", "ply\nformat ascii 1.0\nelement vertex 4\n", /^Could not open cut\.ply/],
    ["broken.glb", "glTF\x02\0\0\0", /^Could not open broken\.glb/],
    ["half.dae", "<?xml version=\"1.0\"?><COLLADA><library", /^Could not open half\.dae/],
    ["many.bzc", "99\n0 0\n", /^Could not open many\.bzc/],
  ];
  for (const [name, content, pattern] of wrong) {
    await editor.drop({ name, content: Buffer.from(content, "latin1") });
    await editor.until(`${name} is refused`, async () => (await alerts(editor)).some((text) => pattern.test(text)));
    await assert.rejects(editor.open(name, Buffer.from(content, "latin1")), (error) =>
      error.message.includes(name === "photo.jpg" ? "No material names photo.jpg" : `Could not open ${name}. `));
    assert.deepEqual(await told(), before, name);
  }
});

editorTest("points without faces are drawn and can be clicked", { sizes: [DESKTOP, PHONE] }, async (editor) => {
  const points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
  await drop(editor, { name: "points.obj", content: points.map((point) => `v ${point.join(" ")}\n`).join("") });
  await editor.frames(6);
  const places = await Promise.all(points.map((point) =>
    editor.page.evaluate((point) => window.meshwright.project(point), point)));
  const picture = await editor.screenshot("points");
  for (const [id, [x, y]] of places.entries()) {
    const [dot, beside] = [picture.at(x, y), picture.at(x + 9, y + 3)];
    assert.ok(dot.some((value, channel) => Math.abs(value - beside[channel]) > 80), `vertex ${id}: ${dot} on ${beside}`);
    await editor.page.mouse.click(x, y);
    await editor.until(`vertex ${id} is selected`, async () => {
      const { kind, ids } = (await editor.state()).selection;
      return kind === "vertex" && ids.join() === String(id);
    });
  }
});
