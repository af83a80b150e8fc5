// The browser tests' harness. A test file reads:
//
//   import { editorTest } from "./harness.mjs";
//
//   editorTest("undo reverts a split", async (editor) => {
//     await editor.run({ op: "split-edge", edge: 3 });
//     await editor.press("Control+z");
//     assert.equal((await editor.state()).document.vertices, 8);
//   });
//
// The test runs once for each renderer, each time in a fresh profile, and fails when the console has errors. Tests run
// on the page that `cargo xtask test --only e2e` builds; MESHWRIGHT_RENDERERS=webgl2 limits them to one renderer. A
// single test file also runs with `node --test`.

import { basename } from "node:path";
import { after, describe, it } from "node:test";

import { browserWith, closeBrowsers } from "./support/browsers.mjs";
import { Editor } from "./support/editor.mjs";
import { site } from "./support/packages.mjs";
import { serve } from "./support/server.mjs";

export { Picture } from "./support/picture.mjs";
export { Editor, browserWith, serve, site };

export const DESKTOP = { name: "desktop", width: 1280, height: 800 };
/** The wide layout in few pixels, because drawing in software is slow. */
export const SMALL = { name: "small", width: 880, height: 540 };
export const PHONE = { name: "phone", width: 390, height: 844, touch: true };

/** The renderers that the page can draw with. */
export const RENDERERS = ["webgpu", "webgl2"];

/** The default time limit of a test: a busy machine takes several times as long as an idle one. */
const TEST_LIMIT_MS = 300_000;

/** The page lies under a sub-path, as on GitHub Pages, so that URLs from the host's root fail. */
const BASE = "/some/where/";

let server;

/** The tests of each renderer, in order. */
const tests = new Map();

/** Adds a test that opens its pages itself, in the browser of a renderer or of "none". */
export function browserTest(renderer, name, options, body) {
  if (!tests.has(renderer)) tests.set(renderer, []);
  tests.get(renderer).push([name, { timeout: TEST_LIMIT_MS, ...options }, body]);
}

/** Registers the tests with Node's test runner: one after another for each renderer, both renderers in parallel. */
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

// A test file that runs by itself has no run.mjs that registers its tests.
if (basename(process.argv[1]) !== "run.mjs") setImmediate(registerTests);

/** Opens the page without waiting for the editor; the caller closes it. */
export async function openPage({ renderer = "webgpu", size = DESKTOP, query = "", label, welcome } = {}) {
  server ??= serve(site, BASE);
  return Editor.open((await server).url + query, { renderer, size, label, welcome });
}

/**
 * Adds a test for each renderer and size: `body(editor, t)` gets an editor that is ready.
 * Options: `renderers`, `sizes`, `query` (appended to the URL), `welcome` (a first visit, with the welcome view), and those of node:test, such as `skip`.
 */
export function editorTest(name, ...rest) {
  const body = rest.pop();
  const { renderers = RENDERERS, sizes = [DESKTOP], query, welcome, ...options } = rest.pop() ?? {};
  const chosen = process.env.MESHWRIGHT_RENDERERS?.split(",");
  for (const renderer of renderers.filter((renderer) => !chosen || chosen.includes(renderer))) {
    for (const size of sizes) {
      const label = `${name} (${renderer}, ${size.name})`;
      browserTest(renderer, label, options, async (t) => {
        const editor = await openPage({ renderer, size, query, label, welcome });
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

/** Saves a screenshot and the console of a failed test. */
async function explain(editor, t) {
  for (const line of editor.log.slice(-40)) t.diagnostic(line);
  // A crashed tab has no picture.
  await editor.screenshot("failed").catch(() => {});
}
