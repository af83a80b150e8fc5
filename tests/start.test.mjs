// The page before its program is there: the frame of the editor, the progress, and what is said when loading fails.

import assert from "node:assert/strict";
import { readdir } from "node:fs/promises";

import { DESKTOP, Editor, PHONE, SMALL, browserTest, serve, site } from "./harness.mjs";

const PROGRAM = /meshwright-web-.*\.wasm$/;

/** A server that keeps the program back after `part` of it, until `release` is called. */
async function slowServer(part) {
  let release;
  const released = new Promise((resolve) => { release = resolve; });
  const server = await serve(site, "/some/where/", {
    async body(file, bytes, response) {
      if (!PROGRAM.test(file)) return false;
      const there = Math.floor(bytes.length * part);
      response.write(bytes.subarray(0, there));
      await released;
      response.end(bytes.subarray(there));
      return true;
    },
  });
  return { ...server, release };
}

/** Adds a test on a page whose program comes in part. */
function loadingTest(name, { size = DESKTOP, query = "", part = 0.5, settings = {}, colorScheme = "dark" }, body) {
  browserTest("webgl2", name, {}, async () => {
    const server = await slowServer(part);
    const editor = await Editor.open(server.url + query, {
      renderer: "webgl2", size, label: name, settings, colorScheme, waitUntil: "domcontentloaded",
    });
    try {
      await body(editor, server);
      editor.assertNoErrors();
    } finally {
      server.release();
      await editor.close();
      await server.stop();
    }
  });
}

/** The colour of an element's background. */
const background = (editor, selector) =>
  editor.page.locator(selector).evaluate((element) => getComputedStyle(element).backgroundColor);

const DARK_BAR = "rgb(26, 29, 34)";
const LIGHT_BAR = "rgb(238, 240, 243)";

for (const colorScheme of ["dark", "light"]) {
  for (const size of [DESKTOP, PHONE]) {
    const name = `the editor's frame and the progress are there before the program (${colorScheme}, ${size.name})`;
    loadingTest(name, { size, colorScheme }, async (editor, server) => {
      const text = editor.page.locator("#loading");
      await editor.until("half of the program has come", async () => {
        const [, done, all] = /: ([\d.]+) of ([\d.]+) MB/.exec(await text.innerText()) ?? [];
        return done / all > 0.4 && done / all < 0.6;
      });
      const bar = editor.page.locator("#progress");
      const { value, max } = await bar.evaluate(({ value, max }) => ({ value, max }));
      assert.ok(value / max > 0.4 && value / max < 0.6, `${value} of ${max}`);
      assert.equal(await background(editor, ".menu-bar"), colorScheme === "dark" ? DARK_BAR : LIGHT_BAR);
      assert.equal(await editor.page.locator(".lists").isVisible(), size !== PHONE);
      assert.equal(await editor.page.locator(".sheet").isVisible(), size === PHONE);
      await editor.screenshot("loading");

      // The frame has the sizes of the editor's.
      const places = (await Promise.all([".menu-bar", ".status-bar"].map((part) => editor.page.locator(part).boundingBox())));
      server.release();
      await editor.ready();
      assert.equal(await editor.page.locator("#frame").isVisible(), false);
      await editor.screenshot("started");
      const canvas = await editor.screenshot();
      for (const { x, y, width, height } of places) {
        const inside = [x + 2, y + height / 2];
        const [r, g, b] = canvas.at(...inside);
        assert.equal(`rgb(${r}, ${g}, ${b})`, colorScheme === "dark" ? DARK_BAR : LIGHT_BAR, `the bar at ${y}, ${width} wide`);
      }
    });
  }
}

loadingTest("the first paint has the theme and the panels of the last visit", {
  part: 0,
  settings: {
    theme: "light",
    layout: JSON.stringify({ arrangement: "Model", model: { left: false, right: true }, widths: [332, 260] }),
  },
}, async (editor) => {
  assert.equal(await background(editor, ".menu-bar"), LIGHT_BAR);
  assert.equal(await editor.page.locator(".lists").isVisible(), false);
  assert.equal((await editor.page.locator(".inspector").boundingBox()).width, 260);
});

loadingTest("the first paint of an embedded page has the parts that its address names", {
  part: 0, query: "?embed&panels=tools,status",
}, async (editor) => {
  const visible = async (part) => editor.page.locator(part).isVisible();
  const parts = [".menu-bar", ".lists", ".inspector", ".tools", ".status-bar"];
  assert.deepEqual(await Promise.all(parts.map(visible)), [false, false, false, true, true]);
});

browserTest("webgl2", "a program that is missing is said to be", {}, async () => {
  const missing = (await readdir(site)).find((name) => PROGRAM.test(name));
  const server = await serve(site, "/", {
    async body(file, _bytes, response) {
      if (!file.endsWith(missing)) return false;
      response.end("not a program");
      return true;
    },
    status: (file) => (file.endsWith(missing) ? 404 : 200),
  });
  const editor = await Editor.open(server.url, { renderer: "webgl2", size: SMALL, label: "missing program" });
  try {
    await assert.rejects(editor.ready(), /404/);
    const notice = editor.page.locator("#notice");
    await notice.waitFor();
    assert.match(await notice.innerText(), /could not be loaded/);
    assert.match(await notice.innerText(), /reload/);
    assert.equal(await editor.page.locator("#frame").isVisible(), false);
  } finally {
    await editor.close();
    await server.stop();
  }
});
