// Measures the start of the page from a warm cache: the processor time until it is ready and drawn, and its longest task.
//
//   cargo xtask dist && MESHWRIGHT_SITE=dist node tests/start.mjs
//
// The graphics process draws in software; its time is not included. Processor time depends little on what else the machine
// does, but not nothing: the load is printed too.

import { loadavg } from "node:os";

import { DESKTOP, browserWith, serve, site } from "./harness.mjs";
import { closeBrowsers } from "./support/browsers.mjs";
import { busy, tasksDuring } from "./support/tasks.mjs";

const GOAL_MS = 1500;
const LONGEST_TASK_GOAL_MS = 200;
const WARM_UPS = 3;
const VISITS = 5;
const RENDERER = process.env.MESHWRIGHT_RENDERERS ?? "webgl2";

// A host's usual headers, so that the browser keeps machine code.
const server = await serve(site, "/", { headers: { "cache-control": "no-cache" } });
const browser = await browserWith(RENDERER);
const context = await browser.newContext({ viewport: DESKTOP });

/** Opens the page and waits until it is drawn; returns the tasks until then. */
async function visit() {
  const page = await context.newPage();
  const tasks = await tasksDuring(browser, page, async () => {
    await page.goto(server.url, { waitUntil: "commit" });
    await page.waitForFunction(() => window.meshwright !== undefined);
    await page.evaluate(async () => {
      await window.meshwright.ready;
      for (let frame = 0; frame < 2; frame += 1) await new Promise(requestAnimationFrame);
    });
  });
  // Everything is kept for the next visit.
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.close();
  return tasks;
}

for (let at = 0; at < WARM_UPS; at += 1) await visit();
console.log(`${RENDERER}, load ${loadavg()[0].toFixed(1)}: processor time in ms until the page is ready and drawn`);
console.log("page's thread   longest tasks            all threads");
const times = [];
for (let at = 0; at < VISITS; at += 1) {
  const { page, all } = await visit();
  const longest = page.slice(0, 3).map((task) => task.busy.toFixed(0)).join("  ");
  console.log(`${busy(page).toFixed(0).padStart(8)}        ${longest.padEnd(24)} ${busy(all).toFixed(0).padStart(6)}`);
  times.push([busy(page), page[0].busy]);
}
// Browsers don't have the machine code of every visit, so visits differ.
const median = (at) => times.map((time) => time[at]).sort((a, b) => a - b)[Math.floor(times.length / 2)];
const verdict = (value, goal) => `${value.toFixed(0)} (goal ${goal}: ${value <= goal ? "met" : "NOT met"})`;
console.log(`median: ${verdict(median(0), GOAL_MS)}, longest task ${verdict(median(1), LONGEST_TASK_GOAL_MS)}`);

await closeBrowsers();
await server.stop();
