// Times each job in WebAssembly under Node, as src/main.rs does natively.
// Arguments: the module that wasm-bindgen made for Node, and the number of runs.

import { createRequire } from "node:module";
import { performance } from "node:perf_hooks";
import { argv } from "node:process";

const [, , module, runs = "5"] = argv;
const { Job, names } = createRequire(import.meta.url)(module);
names().forEach((name, number) => {
  const job = Job.prepare(number);
  let best = Infinity;
  for (let run = 0; run < Number(runs); run += 1) {
    const start = performance.now();
    job.run();
    best = Math.min(best, performance.now() - start);
  }
  job.free();
  console.log(`${name}\t${best.toFixed(1)}`);
});
