// The page starts and draws with every renderer, and shows a message when there is none.

import assert from "node:assert/strict";

import { DESKTOP, PHONE, browserTest, editorTest, openPage } from "./harness.mjs";

editorTest("the page starts and draws", { sizes: [DESKTOP, PHONE] }, async (editor) => {
  const info = await editor.page.evaluate(() => window.meshwright.ready);
  assert.equal(info.renderer, editor.renderer);
  assert.match(info.version, /^\d+\.\d+\.\d+/);

  const picture = await editor.screenshot("started");
  assert.equal(picture.width, editor.size.width);
  assert.ok(picture.colors() > 8, "the canvas shows more than one background");
  assert.equal(await editor.page.locator("#notice").isVisible(), false);
});

browserTest("none", "without WebGPU and WebGL2 a message says what is missing", {}, async () => {
  const editor = await openPage({ renderer: "none", label: "no renderer" });
  try {
    await assert.rejects(editor.ready(), /WebGPU nor WebGL2/);
    await editor.screenshot("message");
    const notice = await editor.page.locator("#notice").innerText();
    assert.match(notice, /cannot draw 3D graphics/);
    assert.match(notice, /WebGPU or WebGL2/);
  } finally {
    await editor.close();
  }
});
