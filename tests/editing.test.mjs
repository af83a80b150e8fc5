// Edits by hand and by script, undo and redo.

import assert from "node:assert/strict";

import { SMALL, editorTest } from "./harness.mjs";

async function whole(editor) {
  const { document } = await editor.state();
  const { dirty, ...rest } = document;
  return { ...rest, mesh: (await editor.export("json")).toString() };
}

async function labels(editor) {
  return (await editor.state()).history.undo;
}

editorTest("each edit by hand is one undo step, and undo restores the exact state", { sizes: [SMALL] }, async (editor) => {
  const steps = [await whole(editor)];
  const stepped = async (label) => {
    assert.equal((await labels(editor)).length, steps.length, `one step for ${label}`);
    steps.push(await whole(editor));
  };

  // Drag a spin box, then type into it.
  await editor.click("Vertex 7", "listBoxOption");
  const spin = async () => {
    const { rect: [x, y, width, height], value } = await editor.find("Position x", "spinButton");
    return { at: [x + width / 2, y + height / 2], value };
  };
  const first = await spin();
  await editor.drag(first.at, [first.at[0] + 40, first.at[1]]);
  const dragged = (await editor.element("vertex", 7)).position;
  assert.ok(dragged[0] > 1.01, `the vertex moved to ${dragged}`);
  assert.deepEqual(dragged.slice(1), [1, 1]);
  await stepped("a drag of the spin box");
  await editor.clickAt((await spin()).at);
  await editor.press("Control+a");
  await editor.page.keyboard.type("1.75");
  await editor.press("Enter");
  assert.deepEqual((await editor.element("vertex", 7)).position, [1.75, 1, 1]);
  assert.equal((await spin()).value, 1.75);
  await stepped("typing into the spin box");

  // Drag the vertex in the viewport.
  const at = await editor.project([1.75, 1, 1]);
  const picture = await editor.screenshot();
  await editor.drag(at, [at[0] + 30, at[1] - 40]);
  const moved = (await editor.element("vertex", 7)).position;
  assert.notDeepEqual(moved, [1.75, 1, 1]);
  const now = await editor.project(moved);
  const off = Math.hypot(now[0] - at[0] - 30, now[1] - at[1] + 40);
  assert.ok(off < 4, `dragged to ${now}, not by 30, -40 from ${at}`);
  await stepped("a drag in the viewport");
  const draggedPicture = await editor.screenshot("vertex dragged");
  assert.ok(draggedPicture.difference(picture, [now[0] - 20, now[1] - 20, 40, 40]) > 20, "it is drawn where it is");

  // By keys: split, then upsample.
  await editor.press("2");
  await editor.click("Edge 0", "listBoxOption");
  await editor.press("s");
  assert.equal((await editor.state()).document.vertices, 9);
  await stepped("a split");
  await editor.page.mouse.move(5, 5);
  await editor.press("u");
  await editor.idle();
  assert.match((await labels(editor)).at(-1), /Catmull/);
  assert.equal((await editor.state()).document.faces, 26);
  await stepped("an upsampling");
  await editor.run({ op: "triangulate-faces" });
  await stepped("a triangulation");
  await editor.press("u");
  await editor.idle();
  assert.match((await labels(editor)).at(-1), /Loop/);
  await stepped("an upsampling of triangles");
  await editor.screenshot("subdivided");

  // Undo everything, then redo everything. Keys go through changes of the selection too.
  const pressUntil = async (key, edits) => {
    for (let presses = 0; (await labels(editor)).length !== edits; presses += 1) {
      assert.ok(presses < 4, `${key} changes something`);
      await editor.press(key);
    }
  };
  for (let step = steps.length - 2; step >= 0; step -= 1) {
    await pressUntil("Control+z", step);
    assert.deepEqual(await whole(editor), steps[step], `after undo to step ${step}`);
  }
  assert.equal((await editor.state()).document.dirty, false);
  assert.equal((await editor.find("Undo", "button")).disabled, false, "vertex 7 was selected first");
  await editor.press("Control+z");
  assert.deepEqual((await editor.state()).selection.ids, []);
  assert.equal((await editor.find("Undo", "button")).disabled, true);
  for (let step = 1; step < steps.length; step += 1) {
    if (step % 2) await pressUntil("Control+Shift+z", step);
    else await editor.redo();
    assert.deepEqual(await whole(editor), steps[step], `after redo to step ${step}`);
  }
});

const once = { renderers: ["webgl2"], sizes: [SMALL] };
editorTest("scripts get outcomes and clear error messages", once, async (editor) => {
  const before = await whole(editor);
  const split = await editor.run({ op: "split-edge", edge: 3 });
  assert.equal(split.op, "split-edge");
  assert.deepEqual(split.created.ids.vertices, [8]);
  await editor.run({ op: "set-face-color", faces: [0], color: "#00ff80" });
  assert.equal((await editor.element("face", 0)).color, "#00ff80");

  // A command without elements applies to the selection.
  await editor.select("vertex", [8]);
  await editor.run({ op: "set-vertex-position", position: [0, 0, 3] });
  assert.deepEqual((await editor.element("vertex", 8)).position, [0, 0, 3]);

  // The lists on the page show the new state.
  await editor.frames(3);
  assert.match((await editor.find("Vertex 8", "listBoxOption")).value, /z 3\.0/);

  const refused = async (call, pattern) => {
    const state = JSON.stringify((await editor.state()).document);
    await assert.rejects(editor.page.evaluate(call), pattern);
    assert.equal(JSON.stringify((await editor.state()).document), state, "a refusal changes nothing");
  };
  await refused(() => window.meshwright.run({ op: "split-edge", edge: 99 }), /split-edge.*edge.*no edge 99/);
  await refused(() => window.meshwright.run({ op: "split-edge", edge: 3, edges: 4 }), /edges.*not a field/);
  await refused(() => window.meshwright.run({ op: "split-edge", edge: "x" }), /edge/);
  const nowhere = () => window.meshwright.run({ op: "set-vertex-position", vertex: 0, position: [0, NaN, 0] });
  await refused(nowhere, /position\[1\].*NaN is not a finite number/);
  await refused(() => window.meshwright.run({ op: "split-edge", edge: () => 1 }), /edge.*a function/);
  await refused(() => window.meshwright.run({ op: "split-edge", edge: Symbol("x") }), /edge.*a symbol/);
  await refused(() => window.meshwright.run({ op: "frobnicate" }), /frobnicate.*no such op/);
  await refused(() => window.meshwright.run(), /run: expected a command/);
  await refused(() => window.meshwright.run("split-edge"), /JSON object/);
  await refused(() => window.meshwright.export("docx"), /docx/);
  await refused(() => window.meshwright.open("a.obj"), /open: expected the content/);
  await refused(() => window.meshwright.open(5, "v 0 0 0"), /open: expected the file's name/);
  await refused(() => window.meshwright.element("vertex", 99), /no vertex 99/);
  await refused(() => window.meshwright.element("vertex", -1), /whole number/);
  await refused(() => window.meshwright.element("corner", 0), /corner.*not a kind/);
  await refused(() => window.meshwright.select("face", [0, 1000]), /no face 1000/);
  await refused(() => window.meshwright.select("face", "all"), /array of ids/);
  await refused(() => window.meshwright.project([0, 1]), /point \[x, y, z\]/);

  // Typed arrays work as lists.
  const moved = await editor.page.evaluate(async () => {
    const { meshwright } = window;
    const position = new Float32Array([0.25, 0.5, 3]);
    await meshwright.run({ op: "set-vertex-position", vertex: 0, position });
    meshwright.select("face", new Uint32Array([1, 3]));
    const answer = [meshwright.element("vertex", 0).position, meshwright.state().selection];
    meshwright.undo();
    return answer;
  });
  assert.deepEqual(moved, [[0.25, 0.5, 3], { kind: "face", ids: [1, 3] }]);

  // `open` takes several kinds of content.
  for (const kind of ["text", "bytes", "buffer", "part"]) {
    const opened = await editor.page.evaluate((kind) => {
      const text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
      const bytes = new TextEncoder().encode(text);
      const padded = new Uint8Array(bytes.length + 8);
      padded.set(bytes, 5);
      const part = new Uint8Array(padded.buffer, 5, bytes.length);
      return window.meshwright.open("t.obj", { text, bytes, buffer: bytes.buffer, part }[kind]);
    }, kind);
    assert.equal(opened.created.faces, 1, kind);
    assert.deepEqual(opened.warnings, [], kind);
  }

  for (let left = (await labels(editor)).length; left > 0; left -= 1) await editor.undo();
  assert.deepEqual(await whole(editor), before);
  assert.equal(await editor.undo(), null, "nothing is left to undo");

  const { view } = await editor.state();
  assert.equal(view.renderer, editor.renderer);
  assert.ok(view.frame_ms.median > 0 && view.frame_ms.worst >= view.frame_ms.median);
});
