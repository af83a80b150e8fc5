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
