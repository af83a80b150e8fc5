// Operations on whole meshes: they report progress, a click cancels them without a trace, and undo restores the mesh.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";

import { SMALL, editorTest } from "./harness.mjs";
import { readsShared, shared } from "./support/shared.mjs";

const once = { renderers: ["webgl2"], sizes: [SMALL], timeout: 280_000 };

/** Keeps a copy of the mesh in the page, to compare with later. */
const keep = (editor) => editor.page.evaluate(async () => { window.kept = await window.meshwright.export("ply"); });
const isAsKept = (editor) => editor.page.evaluate(async () => {
  const now = await window.meshwright.export("ply");
  return now.length === window.kept.length && now.every((byte, at) => byte === window.kept[at]);
});

const told = async (editor) => {
  const { document, history, selection } = await editor.state();
  return { document, history, selection };
};

/**
 * Starts a command, clicks its cancel button once it reports progress, and gives the time that cancelling took.
 * With `atOnce`, a script cancels it instead: a click would come too late for a quick command.
 */
async function startAndCancel(editor, command, label, atOnce) {
  const before = await told(editor);
  // Cancelling ends the worker of jobs; the one that keeps documents goes on.
  const closed = Promise.race(editor.page.workers().map((worker) => new Promise((end) => worker.once("close", end))));
  await editor.page.evaluate((command) => {
    window.answer = window.meshwright.run(command).then(() => "done", String);
    window.cancelled = new Promise((resolve) => {
      window.timeToEnd = () => {
        const start = performance.now();
        const look = () => {
          if (window.meshwright.state().jobs.length === 0) resolve(performance.now() - start);
          else setTimeout(look, 5);
        };
        look();
      };
      addEventListener("pointerup", window.timeToEnd, { capture: true, once: true });
    });
  }, command);
  const job = await editor.page.evaluate(async ([label, atOnce]) => {
    for (;;) {
      const [job] = window.meshwright.state().jobs;
      if (!job) return { ended: await window.answer };
      const controls = window.meshwright.ui();
      const bar = controls.find(({ role, name }) => role === "progressIndicator" && name === label);
      const button = controls.find(({ role, name }) => role === "button" && name === `Cancel ${label}`);
      // A page that was busy may hear of the end of a quick job together with its first progress.
      if (atOnce) {
        window.timeToEnd();
        window.meshwright.cancel();
        return job;
      }
      if (job.progress > 0 && bar && button) return { ...job, rect: button.rect };
      await new Promise((resolve) => setTimeout(resolve, 5));
    }
  }, [label, atOnce]);
  assert.equal(job.op, command.op, `${label} is not on its way: ${job.ended}`);
  assert.ok(job.progress < 1);
  if (!atOnce) {
    const [x, y, width, height] = job.rect;
    await editor.page.mouse.move(x + width / 2, y + height / 2);
    await editor.frames(1);
    await editor.page.mouse.click(x + width / 2, y + height / 2);
  }
  const took = await editor.page.evaluate(() => window.cancelled);
  assert.match(await editor.page.evaluate(() => window.answer), /cancelled/, label);
  await closed;
  assert.deepEqual(await told(editor), before, `${label} left a trace`);
  return { took, at: job.progress };
}

/** Runs a command and gives its outcome and the progress reported meanwhile. */
async function runAndWatch(editor, command) {
  return editor.page.evaluate(async (command) => {
    const seen = [];
    let going = true;
    const look = () => {
      const [job] = window.meshwright.state().jobs;
      if (job) seen.push(job.progress);
      if (going) setTimeout(look, 20);
    };
    const answer = window.meshwright.run(command);
    look();
    const outcome = await answer;
    going = false;
    return { outcome, seen };
  }, command);
}

/** Hides the mesh: drawing half a million faces in software takes a second, in which clicks wait. */
const hide = (editor) => editor.run({ op: "set-object-visible", object: 0, visible: false });

async function check(editor, t, { label, endless, command, faces, topology = false, quick = false, atOnce = false }) {
  const before = await told(editor);
  await keep(editor);
  // A quick command may end before the click, or before it reports progress.
  if (!quick) {
    const { took, at } = await startAndCancel(editor, endless ?? command, label, atOnce);
    t.diagnostic(`${command.op}: cancelled at ${(100 * at).toFixed(0)} %, ${took.toFixed(0)} ms after the click`);
    assert.ok(await isAsKept(editor), `${label}, cancelled, changed the mesh`);
  }

  const { seen } = await runAndWatch(editor, command);
  assert.deepEqual(seen, seen.toSorted((a, b) => a - b), `${label}: progress goes back: ${seen}`);
  assert.ok(quick || new Set(seen).size >= 2, `${label}: progress was ${seen}`);
  const { document, history } = await editor.state();
  assert.equal(history.undo.at(-1), label);
  if (typeof faces === "number") assert.equal(document.faces, faces, label);
  else assert.ok(faces(document.faces), `${label}: ${document.faces} faces`);
  if (!topology) assert.equal(document.euler, before.document.euler, `${label} keeps the Euler characteristic`);

  await editor.undo();
  const after = await told(editor);
  assert.deepEqual(after.document, before.document);
  assert.ok(await isAsKept(editor), `undo of ${label} is not where it began`);
}

const torus = (segments) => ({ op: "new", shape: "torus", segments, tube_segments: segments / 2 });
/** Segments of the torus for slow operations and for quick ones. */
const SMALLER = 320;
const LARGER = 640;
const quads = (segments) => (segments * segments) / 2;
const lessThan = (count) => (faces) => faces > 0 && faces < count;

const SUITES = {
  "a large triangle mesh": [[torus(LARGER), { op: "triangulate-faces" }], [
    {
      // With a largest error, simplifying takes ten times as long: long enough for a click.
      label: "Simplify",
      endless: { op: "simplify", max_error: 0.05 },
      command: { op: "simplify", ratio: 0.1 },
      faces: quads(LARGER) / 5,
    },
    { label: "Remesh", command: { op: "remesh", edge_length: 0.02 }, faces: lessThan(quads(LARGER)) },
  ]],
  "a triangle mesh": [[torus(SMALLER), { op: "triangulate-faces" }], [
    {
      label: "Smooth",
      endless: { op: "smooth", iterations: 10_000 },
      command: { op: "smooth", iterations: 200, method: "taubin" },
      faces: 2 * quads(SMALLER),
    },
    {
      label: "Subdivide (Loop)",
      atOnce: true,
      endless: { op: "subdivide-loop", levels: 3 },
      command: { op: "subdivide-loop", levels: 2 },
      faces: 32 * quads(SMALLER),
    },
  ]],
  "a quad mesh": [[torus(SMALLER)], [
    {
      label: "Subdivide (Catmull-Clark)",
      atOnce: true,
      endless: { op: "subdivide-catmull-clark", levels: 3 },
      command: { op: "subdivide-catmull-clark", levels: 2 },
      faces: 16 * quads(SMALLER),
    },
    {
      label: "Subdivide (linear)",
      atOnce: true,
      endless: { op: "subdivide-linear", levels: 3 },
      command: { op: "subdivide-linear", levels: 2 },
      faces: 16 * quads(SMALLER),
    },
  ]],
  "a large quad mesh": [[torus(LARGER)], [
    {
      label: "Merge by distance",
      atOnce: true,
      command: { op: "merge-by-distance", distance: 0.02 },
      faces: lessThan(quads(LARGER)),
      topology: true,
    },
  ]],
};

for (const [name, [prepare, cases]] of Object.entries(SUITES)) {
  editorTest(`operations on ${name} report progress, are cancelled and undone`, once, async (editor, t) => {
    for (const command of prepare) await editor.run(command);
    await hide(editor);
    assert.equal((await editor.state()).document.euler, 0);
    for (const what of cases) await check(editor, t, what);
  });
}

editorTest("a scanned model is simplified and remeshed", { ...once, ...readsShared }, async (editor, t) => {
  await editor.open("bunny.obj", await readFile(shared("models/common/stanford-bunny.obj")));
  await editor.run({ op: "subdivide-loop" });
  await hide(editor);
  const { document } = await editor.state();
  const quarter = Math.round(document.faces / 4);
  // Isolated vertices are removed, which changes the Euler characteristic.
  const topology = true;
  const simplify = { label: "Simplify", command: { op: "simplify", ratio: 0.25 }, faces: quarter };
  await check(editor, t, { ...simplify, topology, quick: true });
  const endless = { op: "remesh", iterations: 100 };
  const remesh = { label: "Remesh", command: { op: "remesh" }, endless, faces: lessThan(2 * document.faces) };
  await check(editor, t, { ...remesh, topology });

  // The keys of the course editors run the same operations.
  await editor.press("d");
  await editor.idle(120_000);
  assert.equal((await editor.state()).document.faces, quarter);
  await editor.run({ op: "set-object-visible", object: 0, visible: true });
  await editor.press("Equal");
  await editor.find(/^Target edge length of resampling: /, "label");
  await editor.screenshot("simplified bunny");
});
