// The browser tests' harness. A test file reads:
//
//   import { editorTest } from "./harness.mjs";
//
//   editorTest("undo takes back a split", async (editor) => {
//     await editor.run({ op: "split-edge", edge: 3 });
//     await editor.press("Control+z");
//     assert.equal((await editor.state()).document.vertices, 8);
//   });
//
// It runs once for each renderer, in a fresh profile, and fails when the console has errors. Tests run against the page
// that `cargo xtask test --only e2e` builds; MESHWRIGHT_RENDERERS=webgl2 keeps to one renderer. A test file can also be
// run by itself, with `node --test`.

import { basename } from "node:path";
import { after, describe, it } from "node:test";

import { browserWith, closeBrowsers } from "./support/browsers.mjs";
import { Editor } from "./support/editor.mjs";
import { site } from "./support/packages.mjs";
import { serve } from "./support/server.mjs";

export { Picture } from "./support/picture.mjs";
export { Editor, browserWith, serve, site };

export const DESKTOP = { name: "desktop", width: 1280, height: 800 };
/** The wide layout in few pixels, for tests that need many frames: software draws slowly. */
export const SMALL = { name: "small", width: 880, height: 540 };
export const PHONE = { name: "phone", width: 390, height: 844, touch: true };

/** The renderers that the page can draw with. */
export const RENDERERS = ["webgpu", "webgl2"];

/** How long a test may take that doesn't say so itself, in milliseconds; a busy machine takes several times as long as an idle one. */
const TEST_LIMIT = 300_000;

/** The page lies under a sub-path, as on GitHub Pages, so that a URL from the host's root shows. */
const BASE = "/some/where/";

let server;

/** The tests to run in each renderer's browser, in order. */
const tests = new Map();

/** Adds a test without a page of its own; `renderer` names the browser that it opens pages in, "none" being one too. */
export function browserTest(renderer, name, options, body) {
  if (!tests.has(renderer)) tests.set(renderer, []);
  tests.get(renderer).push([name, { timeout: TEST_LIMIT, ...options }, body]);
}

/** Hands the tests to Node's test runner: those of one renderer after each other, the renderers side by side. */
export function registerTests() {
  if (tests.size === 0) return;
  describe("browser tests", { concurrency: tests.size }, () => {
    after(async () => {
      await closeBrowsers();
      await (await server)?.stop();
    });
    for (const [renderer, cases] of tests) {
      describe(renderer, { concurrency: 1 }, () => {
        for (const [name, options, body] of cases) it(name, options, body);
      });
    }
  });
}

// A file that is run by itself has no run.mjs to register its tests once it has been read.
if (basename(process.argv[1]) !== "run.mjs") setImmediate(registerTests);

/** Opens the page without waiting for the editor; the caller closes it. */
export async function openPage({ renderer = "webgpu", size = DESKTOP, query = "", label } = {}) {
  server ??= serve(site, BASE);
  return Editor.open((await server).url + query, { renderer, size, label });
}

/**
 * Registers a test for every renderer and size: `body(editor, t)` gets an editor that is ready.
 * Options: `renderers`, `sizes`, `query` (appended to the URL), and node:test's own, such as `skip`.
 */
export function editorTest(name, ...rest) {
  const body = rest.pop();
  const { renderers = RENDERERS, sizes = [DESKTOP], query, ...options } = rest.pop() ?? {};
  const chosen = process.env.MESHWRIGHT_RENDERERS?.split(",");
  for (const renderer of renderers.filter((renderer) => !chosen || chosen.includes(renderer))) {
    for (const size of sizes) {
      const label = `${name} (${renderer}, ${size.name})`;
      browserTest(renderer, label, options, async (t) => {
        const editor = await openPage({ renderer, size, query, label });
        try {
          await editor.ready();
          await body(editor, t);
          editor.assertNoErrors();
        } catch (error) {
          await explain(editor, t);
          throw error;
        } finally {
          await editor.close();
        }
      });
    }
  }
}

/** Leaves behind what a failed test's page showed and said. */
async function explain(editor, t) {
  for (const line of editor.log.slice(-40)) t.diagnostic(line);
  // A tab that has crashed has nothing to show.
  await editor.screenshot("failed").catch(() => {});
}
