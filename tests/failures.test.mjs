// Failures of parts of the page: the document is kept, and a message says what happened.

import assert from "node:assert/strict";

import { SMALL, editorTest } from "./harness.mjs";
import { grid } from "./support/meshes.mjs";

const LOADER = "**/meshwright-worker*_loader.js";
const once = { renderers: ["webgl2"], sizes: [SMALL] };

/** Reloads the page with another script in place of its worker, until the route is removed. */
async function withWorker(editor, handler) {
  await editor.page.route(LOADER, handler);
  await editor.page.reload();
  await editor.ready();
}

editorTest("a failing worker ends its job and changes nothing else", once, async (editor) => {
  const cube = JSON.stringify((await editor.state()).document);
  const fails = async (pattern) => {
    await assert.rejects(editor.open("grid.obj", grid(2, 2)), pattern);
    await editor.page.unroute(LOADER);
    const { document, jobs } = await editor.state();
    assert.equal(JSON.stringify(document), cube);
    assert.deepEqual(jobs, []);
    // A later job gets a new worker, unless one that also fails was started before the route was removed.
    await editor.open("grid.obj", grid(3, 3)).catch(() => editor.open("grid.obj", grid(3, 3)));
    assert.equal((await editor.state()).document.vertices, 16);
  };

  editor.expectErrors(/ERR_FAILED/);
  await withWorker(editor, (route) => route.abort());
  await fails(/could not be started/);

  const script = (body) => (route) => route.fulfill({ contentType: "text/javascript", body });
  editor.expectErrors(/out of breath/);
  await withWorker(editor, script(`
    self.onmessage = () => { throw new RangeError("out of breath"); };
    self.postMessage(["ready"]);`));
  await fails(/memory.*out of breath/);

  await withWorker(editor, script(`
    self.onmessage = () => { self.postMessage(["crashed", "index out of bounds"]); };
    self.postMessage(["ready"]);`));
  await fails(/crashed.*index out of bounds/);

  await withWorker(editor, script(`
    self.onmessage = ({ data: [job] }) => {
      self.postMessage("nonsense");
      self.postMessage(["done", job, new Uint8Array([1, 2, 3]), 0]);
    };
    self.postMessage(["ready"]);`));
  await assert.rejects(editor.open("grid.obj", grid(2, 2)), /not a job/);
  assert.equal(JSON.stringify((await editor.state()).document), cube);
});

editorTest("a crash shows a message that asks to reload", once, async (editor) => {
  const notice = editor.page.locator("#notice");
  assert.equal(await notice.isVisible(), false);
  // An error in another script is not a crash of the editor.
  editor.expectErrors(/somebody else/);
  await editor.page.evaluate(() => setTimeout(() => { throw new Error("somebody else's"); }));
  await editor.frames(3);
  assert.equal(await notice.isVisible(), false);
  // A trap in WebAssembly is one, even without a panic message.
  editor.expectErrors(/unreachable/);
  await editor.page.evaluate(() => setTimeout(() => { throw new WebAssembly.RuntimeError("unreachable"); }));
  await notice.waitFor();
  assert.match(await notice.innerText(), /has crashed/);
  assert.match(await notice.innerText(), /[Rr]eload/);
  await editor.screenshot("crash");
});

editorTest("settings are kept across visits", once, async (editor) => {
  const theme = async () => (await editor.state()).view.theme;
  const first = await theme();
  const other = first === "dark" ? "Light theme" : "Dark theme";
  await editor.click("Edit", "button");
  await editor.click("Theme", "button");
  await editor.click(other);
  await editor.until("the theme changes", async () => (await theme()) !== first);
  await editor.page.reload();
  await editor.ready();
  assert.notEqual(await theme(), first);
  await editor.screenshot("other theme");
});
