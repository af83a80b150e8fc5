// Links that hold a document: made, read from the picture as a phone does, opened elsewhere, and refused.

import assert from "node:assert/strict";

import { DESKTOP, editorTest, openPage } from "./harness.mjs";
import { jsqr } from "./support/packages.mjs";

const options = { renderers: ["webgl2"], sizes: [DESKTOP] };

/** Opens the window with the link; returns the link. */
async function share(editor) {
  await editor.choose("Share");
  return (await editor.find("Link", "textInput")).value;
}

/** The text of the QR code on the page. */
async function scan(editor) {
  await editor.find("QR code of the link");
  const { data, width, height } = await editor.screenshot("QR code");
  return jsqr(new Uint8ClampedArray(data), width, height)?.data;
}

editorTest("the QR code is the link, and opens the document on another device", options, async (editor) => {
  await editor.run({ op: "extrude-faces", faces: [2], distance: 0.5 });
  await editor.run({ op: "set-face-color", faces: [0, 1], color: "#ff8800" });
  const link = await share(editor);
  assert.equal(await scan(editor), link);

  const { hash } = new URL(link);
  const other = await openPage({ renderer: "webgl2", size: DESKTOP, query: hash, label: "opened by a link" });
  try {
    await other.ready();
    await other.find(/^Opened Cube/);
    const { document } = await other.state();
    const { document: shared } = await editor.state();
    assert.equal(document.name, shared.name);
    assert.deepEqual((await other.export("ply")).equals(await editor.export("ply")), true, "the same document to the bit");
    await other.find(/Shared by a link/);

    // The first change makes it a copy, which a reload brings back, and the address no longer holds the old state.
    await other.run({ op: "poke-faces", faces: [3] });
    await other.find(/This is your own copy now/);
    assert.equal(new URL(other.page.url()).hash, "");
    assert.equal((await other.state()).document.name, `${shared.name} (copy)`);
    other.assertNoErrors();
  } finally {
    await other.close();
  }
});

editorTest("damaged links are refused in words, and the document stays", options, async (editor) => {
  await editor.run({ op: "poke-faces", faces: [0] });
  const { hash } = new URL(await share(editor));
  await editor.press("Escape");
  const before = await editor.export("ply");
  const damaged = [
    [hash.slice(0, -6), /damaged or incomplete/],
    [hash.replace("#d=1", "#d=2"), /later version/],
    ["#d=1!!!!", /damaged or incomplete/],
    [`#d=1${"A".repeat(200_000)}`, /too long/],
  ];
  for (const [fragment, reason] of damaged) {
    // As when someone pastes another link over the address of the open page.
    await editor.page.evaluate((fragment) => { location.hash = fragment; }, fragment);
    await editor.find(reason);
    assert.ok((await editor.export("ply")).equals(before), fragment.slice(0, 20));
  }
});
