// Runs test files together: in one process, with one browser for each renderer, both renderers in parallel.
//
//   node tests/run.mjs tests/smoke.test.mjs tests/files.test.mjs

import { pathToFileURL } from "node:url";

import { registerTests } from "./harness.mjs";

for (const file of process.argv.slice(2)) await import(pathToFileURL(file).href);
registerTests();
