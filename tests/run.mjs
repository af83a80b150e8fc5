// Runs test files together: one process, one browser for each renderer, the renderers side by side.
//
//   node tests/run.mjs tests/smoke.test.mjs tests/files.test.mjs

import { pathToFileURL } from "node:url";

import { registerTests } from "./harness.mjs";

for (const file of process.argv.slice(2)) await import(pathToFileURL(file).href);
registerTests();
