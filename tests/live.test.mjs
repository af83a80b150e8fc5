// Previews, edits that follow the pointer, adjusting the last operation, and the context menu.

import assert from "node:assert/strict";

import { SMALL, editorTest } from "./harness.mjs";

/** The whole document, with history and selection. */
async function whole(editor) {
  const { document, history, selection } = await editor.state();
  return { document, undo: history.undo, redo: history.redo, selection, mesh: (await editor.export("json")).toString() };
}

const undoable = async (editor) => (await editor.state()).history.undo;

/** A free place in the viewport, where pointer movements start. */
async function corner(editor) {
  const [x, y] = (await editor.state()).view.rect;
  return [x + 60, y + 320];
}

/** Starts a live edit with its key and moves the pointer by [x, y]. */
async function start(editor, { key, kind, ids, by: [x, y] }) {
  await editor.select(kind, ids);
  const [left, top] = await corner(editor);
  await editor.page.mouse.move(left, top);
  await editor.frames(2);
  await editor.press(key);
  await editor.frames(2);
  for (let step = 1; step <= 4; step += 1) {
    await editor.page.mouse.move(left + (x * step) / 4, top + (y * step) / 4);
    await editor.frames(1);
  }
  await editor.frames(1);
}

/** High enough for the list of operations below the fields of the last one. */
const HIGH = { ...SMALL, name: "high", height: 1000 };

editorTest("an operation in a form is previewed until it is applied or dismissed", { sizes: [HIGH] }, async (editor) => {
  await editor.run({ op: "new", shape: "ico-sphere", subdivisions: 2 });
  await editor.page.mouse.move(5, 5);
  const before = await whole(editor);
  const vertex = async () => (await editor.element("vertex", 0)).position;
  const choose = async (operation) => {
    if ((await editor.ui()).some(({ name }) => name === "All operations")) await editor.click("All operations");
    await editor.click("Filter operations", "textInput");
    await editor.press("Control+a");
    await editor.page.keyboard.type(operation);
    await editor.press("Enter");
  };
  const at = await vertex();
  const plain = await editor.screenshot();
  await choose("Smooth");
  await editor.find(/^This is a preview/, "label");
  assert.notDeepEqual(await vertex(), at, "the mesh is smoothed");
  assert.ok((await editor.screenshot("preview of smoothing")).difference(plain) > 0, "and drawn so");
  assert.deepEqual(await undoable(editor), before.undo);
  await editor.press("Escape");
  assert.deepEqual(await whole(editor), before, "Escape leaves no trace");

  await choose("Simplify");
  await editor.until("it is simplified", async () => (await editor.state()).document.faces === 160);
  await editor.find("Result: 160 of 320 triangles", "label");
  await editor.click("Live preview", "checkBox");
  assert.deepEqual(await whole(editor), before, "nor does switching it off");
  await editor.click("Live preview", "checkBox");
  await editor.until("it is simplified again", async () => (await editor.state()).document.faces === 160);
  await editor.click("Simplify", "button");
  assert.equal((await editor.state()).document.faces, 160);
  assert.deepEqual(await undoable(editor), [...before.undo, "Simplify"]);
  await editor.undo();
  assert.equal((await whole(editor)).mesh, before.mesh);
});

/** Edits of the cube: the numbers of faces and vertices after each, and the label of the undo step. */
const CUBE = [
  { key: "e", kind: "face", ids: [0], by: [40, 0], faces: 10, vertices: 12, label: "Extrude faces" },
  { key: "Shift+I", kind: "face", ids: [0, 1], by: [16, 0], faces: 14, label: "Inset faces" },
  { key: "b", kind: "edge", ids: [0], by: [14, 0], faces: 7, vertices: 10, label: "Bevel edges" },
  { key: "b", kind: "vertex", ids: [0], by: [14, 0], faces: 7, vertices: 10, label: "Bevel vertices" },
  { key: "g", kind: "vertex", ids: [7], by: [30, -30], faces: 6, vertices: 8, label: "Move" },
  { key: "Shift+S", kind: "edge", ids: [0], by: [30, 0], vertices: 9, label: "Split edge" },
];

editorTest("live edits follow the pointer, and are one undo step or leave no trace", { sizes: [SMALL] }, async (editor) => {
  for (const edit of CUBE) {
    const before = await whole(editor);
    const says = `${edit.key} on ${edit.kind}`;

    // Cancel with Escape.
    await start(editor, edit);
    const during = (await editor.state()).document;
    if (edit.vertices) assert.equal(during.vertices, edit.vertices, says);
    if (edit.faces) assert.equal(during.faces, edit.faces, says);
    await editor.find("Apply", "button");
    await editor.press("Escape");
    const selected = (await editor.state()).selection;
    assert.deepEqual(selected, { kind: edit.kind, ids: edit.ids }, `${says}: the selection stays`);
    assert.deepEqual({ ...(await whole(editor)), selection: before.selection }, before, `${says}: no trace`);

    // Commit with Enter, after a longer movement whose preview has to be replaced.
    await start(editor, edit);
    const preview = (await editor.export("json")).toString();
    assert.notEqual(preview, before.mesh, `${says}: a preview`);
    const [left, top] = await corner(editor);
    await editor.page.mouse.move(left + edit.by[0] / 2, top + edit.by[1] / 2);
    await editor.frames(2);
    const nearer = (await editor.export("json")).toString();
    assert.notEqual(nearer, preview, `${says}: the preview follows`);
    assert.equal((await undoable(editor)).length, before.undo.length, `${says}: no step yet`);
    await editor.press("Enter");
    assert.deepEqual(await undoable(editor), [...before.undo, edit.label]);
    assert.equal((await editor.export("json")).toString(), nearer, `${says}: what was shown is what is kept`);
    await editor.press("Control+z");
    assert.equal((await whole(editor)).mesh, before.mesh, `${says}: undone`);
  }

  // A click in the viewport commits too, and keeps the selection.
  await start(editor, CUBE[0]);
  await editor.screenshot("extruding");
  const [left, top] = await corner(editor);
  await editor.clickAt([left + 40, top]);
  assert.equal((await undoable(editor)).at(-1), "Extrude faces");
  assert.equal((await editor.state()).document.faces, 10);
  await editor.undo();

  // A typed number is the amount, wherever the pointer is.
  await start(editor, CUBE[0]);
  await editor.page.keyboard.type("0.75");
  await editor.frames(2);
  await editor.page.mouse.move(left + 90, top + 50);
  await editor.frames(2);
  await editor.press("Enter");
  const positions = JSON.parse(await editor.export("json")).positions;
  assert.equal(Math.max(...positions.flat().map(Math.abs)), 1.75);
});

const once = { renderers: ["webgl2"], sizes: [SMALL] };
editorTest("adjusting the last operation replaces its undo step", once, async (editor) => {
  const before = (await editor.export("json")).toString();
  await editor.run({ op: "bevel-edges", edges: [0], width: 0.2 });
  const far = async () => JSON.parse(await editor.export("json"));
  const first = await far();
  const field = async () => {
    const { rect: [x, y, width, height] } = await editor.find("Segments", "spinButton");
    await editor.clickAt([x + width / 2, y + height / 2]);
    await editor.press("Control+a");
  };
  await field();
  await editor.page.keyboard.type("3");
  await editor.press("Enter");
  const second = await far();
  assert.equal(second.faces.length, first.faces.length + 2, "three segments in place of one");
  assert.deepEqual(await undoable(editor), ["Bevel edges"]);
  await editor.screenshot("bevel adjusted");
  await editor.press("Control+z");
  assert.equal((await editor.export("json")).toString(), before);
  assert.equal((await editor.ui()).some((node) => /Adjust last/.test(node.name)), false);

  // A whole-mesh operation runs again as a job.
  await editor.run({ op: "subdivide-catmull-clark" });
  const levels = await editor.find("Levels", "spinButton");
  await editor.clickAt([levels.rect[0] + 10, levels.rect[1] + 8]);
  await editor.press("Control+a");
  await editor.page.keyboard.type("3");
  await editor.press("Enter");
  await editor.idle();
  await editor.until("three levels", async () => (await editor.state()).document.faces === 6 * 4 ** 3);
  assert.equal((await undoable(editor)).length, 1);
  await editor.undo();
  assert.equal((await editor.export("json")).toString(), before);
});

editorTest("the context menu offers what applies, and says why the rest does not", once, async (editor) => {
  // The open list decides what a click picks. Try edges until one is in front.
  await editor.press("2");
  let at;
  for (let id = 0; id < 12 && !(await editor.state()).selection.ids.length; id += 1) {
    const { vertices } = await editor.element("edge", id);
    const [a, b] = await Promise.all(vertices.map(async (id) => (await editor.element("vertex", id)).position));
    at = await editor.project([0, 1, 2].map((axis) => (a[axis] + b[axis]) / 2));
    await editor.clickAt(at);
  }
  await editor.page.mouse.click(...at, { button: "right" });
  await editor.frames(4);
  const entries = (await editor.ui()).filter((node) => node.role === "button");
  // The panel lists the same operations; the menu belongs to the viewport, which is read before it.
  const named = (part) => entries.find((node) => node.name.startsWith(part));
  await editor.screenshot("context menu");
  assert.equal((await editor.state()).selection.kind, "edge");
  assert.equal(named("Flip edge").disabled, false);
  assert.equal(named("Split edge").disabled, false);
  const weld = named("Weld edges");
  assert.equal(weld.disabled, true);
  assert.match(weld.description, /boundary|two/i);
  const flip = named("Flip edge");
  await editor.clickAt([flip.rect[0] + 20, flip.rect[1] + 8]);
  assert.deepEqual(await undoable(editor), ["Flip edge"]);
});
