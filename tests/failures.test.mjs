// Failures of parts of the page: the document is kept, and a message says what happened.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";

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

/** What lets the program panic: eframe counts on the clock. */
const panic = (page) => page.evaluate(() => Object.defineProperty(window, "performance", { value: undefined }));

for (const [store, query] of Object.entries({ "private files": "", IndexedDB: "?store=indexeddb" })) {
  editorTest(`a panic offers the document as a file and a reload: ${store}`, { ...once, query }, async (editor) => {
    await editor.select("face", [1]);
    await editor.run({ op: "extrude-faces", distance: 0.5 });
    await editor.frames(5);
    await editor.page.waitForTimeout(300);
    editor.expectErrors(/panicked|unreachable/);
    await panic(editor.page);
    await editor.page.mouse.move(300, 300);
    const notice = editor.page.locator("#notice");
    await notice.waitFor();
    assert.match(await notice.innerText(), /has crashed/);
    assert.match(await notice.innerText(), /kept in this browser/);
    await editor.screenshot("notice");
    const download = editor.page.waitForEvent("download");
    await editor.page.getByRole("button", { name: "Save the document as a file" }).click();
    const file = await download;
    assert.equal(file.suggestedFilename(), "Cube.meshwright");
    const content = await readFile(await file.path());
    await editor.page.getByText("Saved as Cube.meshwright.").waitFor();
    const loaded = editor.page.waitForEvent("load");
    await editor.page.getByRole("button", { name: "Reload and go on" }).click();
    await loaded;
    await editor.ready();
    const { document, history } = await editor.state();
    assert.equal(document.faces, 10);
    assert.deepEqual(history.undo, ["Extrude faces"]);
    // The file holds the same, with its history.
    await editor.run({ op: "new", shape: "torus" });
    await editor.open("Saved.meshwright", content);
    assert.equal((await editor.state()).document.faces, 10);
    await editor.undo();
    assert.equal((await editor.state()).document.faces, 6);
  });

  editorTest(`the store's worker is replaced when it ends: ${store}`, { ...once, query }, async (editor) => {
    const end = async () => {
      for (const worker of editor.page.workers()) {
        if ((await worker.evaluate(() => self.name)).startsWith("meshwright-store")) {
          await worker.evaluate(() => self.close());
        }
      }
    };
    await editor.select("face", [1]);
    await editor.run({ op: "extrude-faces", distance: 0.5 });
    // Its answer shows that the worker has started: one that ends before that is another case.
    await editor.choose("Recent documents");
    await editor.find("Name of Cube");
    await editor.press("Escape");
    await end();
    const restarted = /keeps documents ended and was started again/;
    await editor.until("the page notices", async () => (
      (await editor.state()).messages.some(({ text }) => restarted.test(text))));
    await editor.run({ op: "poke-faces", faces: [0] });
    await editor.frames(5);
    // The new worker loads its program first.
    await editor.until("the document is listed", async () => {
      await editor.page.waitForTimeout(500);
      const workers = await Promise.all(editor.page.workers().map((worker) => worker.evaluate(() => self.name)));
      return workers.some((name) => name.startsWith("meshwright-store"));
    });
    await editor.page.waitForTimeout(3000);
    await editor.page.reload();
    await editor.ready();
    assert.equal((await editor.state()).document.faces, 13);
  });
}

editorTest("a worker that the browser ends without a word fails its job", once, async (editor) => {
  await withWorker(editor, (route) => route.fulfill({
    contentType: "text/javascript",
    body: `
      navigator.locks.request("meshwright-alive " + self.name, () => {
        self.postMessage(["ready"]);
        return new Promise(() => {});
      });
      self.onmessage = () => self.close();`,
  }));
  await assert.rejects(editor.open("grid.obj", grid(2, 2)), /most likely because the browser gave it no more memory.*unchanged/);
  await editor.page.unroute(LOADER);
  await editor.open("grid.obj", grid(3, 3)).catch(() => editor.open("grid.obj", grid(3, 3)));
  assert.equal((await editor.state()).document.vertices, 16);
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

editorTest("a document that ends the program while it is opened can be left for a new one", once, async (editor) => {
  await editor.select("face", [1]);
  await editor.run({ op: "extrude-faces", distance: 0.5 });
  await editor.frames(5);
  await editor.page.waitForTimeout(300);
  // As a document that is too large for the memory.
  await editor.page.addInitScript(() => {
    const instantiate = WebAssembly.instantiateStreaming;
    WebAssembly.instantiateStreaming = (...given) => {
      if (sessionStorage.getItem("meshwright.document") === null) return instantiate.apply(WebAssembly, given);
      return Promise.reject(new WebAssembly.RuntimeError("unreachable"));
    };
  });
  await editor.page.reload();
  const notice = editor.page.locator("#notice");
  await notice.waitFor();
  assert.match(await notice.innerText(), /has crashed[^]*The document is kept in this browser/);
  await editor.page.getByRole("button", { name: "Begin with a new document" }).click();
  await editor.page.waitForFunction(() => document.querySelector("#notice")?.hidden !== false);
  await editor.ready();
  assert.equal((await editor.state()).document.faces, 6);
});

editorTest("errors of other programs' scripts do not end the start", once, async (editor) => {
  await editor.page.addInitScript(() => {
    document.addEventListener("DOMContentLoaded", () => {
      const filename = "chrome-extension://someone/script.js";
      const error = new Error("not the page's");
      error.stack = `Error: not the page's\n    at ${filename}:1:1`;
      window.dispatchEvent(new ErrorEvent("error", { filename, error, message: error.message }));
      const promise = Promise.resolve();
      window.dispatchEvent(new PromiseRejectionEvent("unhandledrejection", { promise, reason: error }));
    });
  });
  await editor.page.reload();
  await editor.ready();
  assert.equal(await editor.page.locator("#notice").isVisible(), false);
});
