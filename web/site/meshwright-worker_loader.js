// Starts the program of a worker.

import init from "./meshwright-worker.js";

await init();
