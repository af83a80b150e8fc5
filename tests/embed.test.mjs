// The editor in another page: the example, calls and events by messages, and who may send them.

import assert from "node:assert/strict";

import { SMALL, browserTest, openPage } from "./harness.mjs";

/** Adds a test on the example page, whose editor is ready. */
function exampleTest(name, body) {
  browserTest("webgl2", name, {}, async () => {
    const example = await openPage({ renderer: "webgl2", size: SMALL, query: "embed/example.html", label: name });
    try {
      await example.page.waitForFunction(() => document.querySelector("#torus")?.disabled === false);
      await body(example);
      example.assertNoErrors();
    } finally {
      await example.close();
    }
  });
}

exampleTest("the example page runs commands and hears of changes", async ({ page }) => {
  await page.click("#torus");
  await page.waitForFunction(() => document.querySelector("#log").textContent.includes("Torus"));
  const state = await page.evaluate(() => window.editor.state());
  assert.equal(state.document.name, "Torus");
  await page.click("#subdivide");
  await page.waitForFunction(() => document.querySelector("#log").textContent.includes("Subdivide"));
  const before = state.document.faces;
  assert.equal((await page.evaluate(() => window.editor.state())).document.faces, before * 4);
  await page.evaluate(() => window.editor.select("face", [1, 2]));
  await page.waitForFunction(() => document.querySelector("#log").textContent.includes("Selected: 2 × face"));
  const refused = await page.evaluate(() => window.editor.run({ op: "split-edge", edge: 1e6 }).catch((e) => e.message));
  assert.match(refused, /there is no edge/);
  const bytes = await page.evaluate(async () => (await window.editor.export("ply")).length);
  assert.ok(bytes > 1000);

  // Calls that aren't offered, and messages that are none.
  const answers = await page.evaluate(async () => {
    const { frame } = window.editor;
    const heard = [];
    addEventListener("message", ({ data }) => heard.push(data));
    const send = (message) => frame.contentWindow.postMessage(message, location.origin);
    for (const message of ["text", null, {}, { meshwright: 2, id: 7, call: "undo" }]) send(message);
    send({ meshwright: 1, id: 70, call: "ui" });
    send({ meshwright: 1, id: 71, call: "constructor", args: ["x"] });
    send({ meshwright: 1, id: 72, call: "on", args: ["everything"] });
    await new Promise((resolve) => { setTimeout(resolve, 500); });
    return heard.filter(({ id }) => id !== undefined);
  });
  assert.deepEqual(answers.map(({ id, error }) => [id, error.includes("there is no such call") || error.includes("on: expected")]), [
    [70, true], [71, true], [72, true],
  ]);
});

exampleTest("origins that the address doesn't name get no answer", async ({ page }) => {
  const answered = await page.evaluate(async () => {
    await window.editor.ready;
    const address = new URL(window.editor.frame.src);
    address.searchParams.set("origins", "https://other.example,null");
    const frame = document.createElement("iframe");
    frame.src = address.href;
    document.body.append(frame);
    const heard = [];
    addEventListener("message", ({ data, source }) => { if (source === frame.contentWindow) heard.push(data); });
    await new Promise((resolve) => { frame.onload = resolve; });
    await frame.contentWindow.meshwright.ready;
    frame.contentWindow.postMessage({ meshwright: 1, id: 1, call: "state", args: [] }, location.origin);
    await new Promise((resolve) => { setTimeout(resolve, 500); });
    return heard.length;
  });
  assert.equal(answered, 0);
});

exampleTest("random messages are answered in words, and the editor goes on", async ({ page }) => {
  const { wrong, errors, results, faces } = await page.evaluate(async () => {
    const CALLS = [
      "open", "openFiles", "run", "export", "exportFiles", "state", "element", "select", "undo", "redo", "cancel", "on",
      "project", "ready", "constructor", "__proto__", "toString", "",
    ];
    const OPS = [
      "new", "open", "extrude-faces", "subdivide-catmull-clark", "simplify", "transform", "split-edge", "duplicate", "undo",
      "delete-faces", "merge-vertices", "smooth", "remesh", "set-face-color", "no-such-operation",
    ];
    const FIELDS = [
      "faces", "edges", "edge", "vertices", "vertex", "distance", "iterations", "segments", "shape", "position", "translate",
      "files", "object", "objects", "target_faces", "color", "symmetry", "__proto__",
    ];
    let seed = 12;
    const random = (below) => {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
      return Math.floor((seed / 2 ** 32) * below);
    };
    const one = (list) => list[random(list.length)];
    const value = (depth) => one([
      () => null, () => undefined, () => true, () => random(12), () => -1, () => 0.5, () => 1e300, () => NaN, () => 4294967296,
      () => "", () => "face", () => "cube", () => "x".repeat(300), () => "__proto__", () => new Uint8Array(random(99)),
      () => new Date(0), () => new Map([[1, 2]]), () => 10n,
      () => (depth > 3 ? [] : Array.from({ length: random(5) }, () => value(depth + 1))),
      () => (depth > 3 ? {} : Object.fromEntries([0, 1, 2].map(() => [one(FIELDS), value(depth + 1)]))),
      () => ({ op: one(OPS), ...Object.fromEntries([0, 1].map(() => [one(FIELDS), value(2)])) }),
      () => { let nested = []; for (let i = 0; i < 2000; i += 1) nested = [nested]; return nested; },
    ])();

    const { frame } = window.editor;
    const answers = new Map();
    const hear = ({ data, source }) => {
      if (source !== frame.contentWindow || data?.id === undefined) return;
      answers.set(data.id, [...(answers.get(data.id) ?? []), data]);
    };
    addEventListener("message", hear);
    const FIRST = 1000;
    const COUNT = 600;
    for (let i = 0; i < COUNT; i += 1) {
      const args = random(8) === 0 ? value(0) : Array.from({ length: random(4) }, () => value(0));
      const call = random(20) === 0 ? value(0) : random(2) === 0 ? "run" : one(CALLS);
      frame.contentWindow.postMessage({ meshwright: 1, id: FIRST + i, call, args }, location.origin);
      if (i % 20 === 0) await new Promise((resolve) => { setTimeout(resolve, 20); });
    }
    // Each is answered once. Jobs take a while.
    for (let waits = 0; waits < 600 && answers.size < COUNT; waits += 1) {
      await new Promise((resolve) => { setTimeout(resolve, 100); });
    }
    removeEventListener("message", hear);
    const all = [...answers.values()].flat();
    const errors = all.filter((answer) => "error" in answer);
    const wrong = [
      ...Array.from({ length: COUNT }, (_, i) => FIRST + i).filter((id) => answers.get(id)?.length !== 1),
      ...errors.filter(({ error }) => typeof error !== "string" || error.length < 8 || error.length > 2000),
    ];
    await window.editor.run({ op: "new", shape: "cube" });
    return {
      wrong: wrong.map((of) => JSON.stringify(of)?.slice(0, 300)),
      errors: errors.length,
      results: all.length - errors.length,
      faces: (await window.editor.state()).document.faces,
    };
  });
  assert.deepEqual(wrong, []);
  assert.ok(errors > 200 && results > 50, `${errors} errors, ${results} results`);
  assert.equal(faces, 6);
});
