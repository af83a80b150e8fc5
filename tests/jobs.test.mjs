// Jobs run in a worker, report progress and can be cancelled.

import assert from "node:assert/strict";

import { SMALL, editorTest } from "./harness.mjs";
import { grid } from "./support/meshes.mjs";

const SIDE = 708;
const TRIANGLES = 2 * SIDE * SIDE;

/** Adds a function `dropLarge` to the page, which drops a file of a million triangles. The text, of 35 MB, is made there. */
function prepare(editor) {
  return editor.page.evaluate(([grid, side]) => {
    const text = Function(`return (${grid})`)()(side, side, { triangles: true });
    window.dropLarge = (name) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], name));
      const canvas = document.getElementById("meshwright");
      canvas.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    };
    return text.length;
  }, [grid.toString(), SIDE]);
}

/** Drops the large file and cancels while it is being read. */
function dropAndCancel(editor) {
  return editor.page.evaluate(async () => {
    const { meshwright } = window;
    window.dropLarge("huge.obj");
    const dropped = performance.now();
    for (;;) {
      await new Promise(requestAnimationFrame);
      const { jobs: [job], document, messages } = meshwright.state();
      if (document.name === "huge" || performance.now() - dropped > 60_000) {
        throw new Error(`the job was not seen on its way: ${JSON.stringify({ job, document, messages })}`);
      }
      if (job?.progress > 0) {
        const start = performance.now();
        return { job, stopped: meshwright.cancel(), left: meshwright.state().jobs, took: performance.now() - start };
      }
    }
  });
}

/** Drops the large file, and records frames and progress until it is open. */
function watch(editor) {
  return editor.page.evaluate(() => new Promise((resolve, reject) => {
    window.dropLarge("huge.obj");
    const dropped = performance.now();
    const progress = [];
    const gaps = [];
    let last = performance.now();
    const frame = (now) => {
      const [job] = window.meshwright.state().jobs;
      if (job) {
        gaps.push(now - last);
        progress.push(job.progress);
      } else if (now - dropped > 120_000) {
        reject(new Error(`no job after two minutes: ${JSON.stringify(window.meshwright.state())}`));
        return;
      } else if (progress.length > 0) {
        resolve({ progress, longest: Math.max(...gaps), frames: gaps.length, last: now - last });
        return;
      }
      last = now;
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }));
}

const options = { timeout: 240_000, sizes: [SMALL] };
editorTest("a million triangles open in the worker, and opening can be cancelled", options, async (editor, t) => {
  await editor.run({ op: "split-edge", edge: 0 });
  const snapshot = async () => {
    const { document, history, selection } = await editor.state();
    return { document, history, selection };
  };
  const before = await snapshot();

  // Cancel while the file is being read.
  const bytes = await prepare(editor);
  const { job, stopped, left, took } = await dropAndCancel(editor);
  t.diagnostic(`cancelled at ${(100 * job.progress).toFixed(0)} % in ${took.toFixed(0)} ms`);
  assert.equal(job.op, "open");
  assert.ok(job.progress < 1);
  assert.equal(stopped, 1);
  assert.deepEqual(left, []);
  await editor.frames(10);
  assert.deepEqual(await snapshot(), before, "the document is as it was");

  // The promise of a cancelled job is rejected.
  const told = await editor.page.evaluate(async () => {
    const answer = window.meshwright.open("x.obj", "v 0 0 0\n").catch(String);
    return { stopped: window.meshwright.cancel(), answer: await answer };
  });
  assert.equal(told.stopped, 1);
  assert.match(told.answer, /cancelled/);
  assert.deepEqual(await snapshot(), before);

  // The next job gets a new worker.
  await editor.open("small.obj", grid(2, 2));
  assert.equal((await editor.state()).document.vertices, 9);

  // Open the file: the page goes on drawing and answering.
  const seen = await watch(editor);
  await editor.until("the file is open", async () => (await editor.state()).document.name === "huge", 120_000);
  t.diagnostic(`${(bytes / 1e6).toFixed(0)} MB, ${seen.frames} frames while the job ran, the longest ` +
    `${seen.longest.toFixed(0)} ms apart; ${seen.last.toFixed(0)} ms for taking the mesh in`);
  const { document } = await editor.state();
  assert.equal(document.faces, TRIANGLES);
  assert.equal(document.vertices, (SIDE + 1) ** 2);
  // Each value was seen in a frame of its own: the page went on drawing.
  assert.ok(new Set(seen.progress).size >= 2, `progress was ${[...new Set(seen.progress)]}`);
  assert.deepEqual(seen.progress, seen.progress.toSorted((a, b) => a - b), "progress never goes back");
  await editor.frames(3);
  await editor.screenshot("a million triangles");
});

const once = { renderers: ["webgl2"], sizes: [SMALL] };
editorTest("the status bar shows a job, which its button and Escape cancel", once, async (editor) => {
  // A worker that stops at 30 %.
  await editor.page.route("**/meshwright-worker*_loader.js", (route) => route.fulfill({
    contentType: "text/javascript",
    body: `self.onmessage = ({ data: [job] }) => self.postMessage(["progress", job, 0.3]);
      self.postMessage(["ready"]);`,
  }));
  await editor.page.reload();
  await editor.ready();
  const { document } = await editor.state();
  const stop = { Escape: () => editor.press("Escape"), button: () => editor.click("Cancel Open never.obj", "button") };
  for (const [how, cancel] of Object.entries(stop)) {
    await editor.drop({ name: "never.obj", content: grid(2, 2) });
    await editor.until("the job is on its way", async () => (await editor.state()).jobs[0]?.progress > 0.2);
    assert.deepEqual((await editor.state()).jobs.map((job) => job.op), ["open"]);
    await editor.find("Open never.obj", "progressIndicator");
    await editor.screenshot(`job before ${how}`);
    await cancel();
    await editor.until(`${how} cancels`, async () => (await editor.state()).jobs.length === 0);
    assert.deepEqual((await editor.state()).document, document);
  }
});

editorTest("excessive parameters neither block the page nor run on", once, async (editor) => {
  const most = 2 ** 32 - 1;
  for (const op of ["remesh", "smooth"]) {
    await assert.rejects(editor.run({ op, iterations: most }), /`iterations`: 4294967295 is out of range/);
  }
  for (const command of [
    { op: "remesh", iterations: 1000 },
    { op: "remesh", edge_length: 0.004 },
    { op: "smooth", iterations: 10_000 },
  ]) {
    const { jobs, answer } = await editor.page.evaluate(async (command) => {
      const { meshwright } = window;
      const answer = meshwright.run(command).then(() => "done", String);
      const { jobs } = meshwright.state();
      meshwright.cancel();
      return { jobs: jobs.map(({ op }) => op), answer: await answer };
    }, command);
    assert.deepEqual(jobs, [command.op]);
    assert.match(answer, /cancelled/);
  }
  const { warnings } = await editor.run({ op: "simplify", faces: most });
  assert.match(warnings.join(), /only 12 triangles/);
});
