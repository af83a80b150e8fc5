// Measures how long the page's thread is busy at a stretch with a million triangles: prints the longest tasks of each
// action, in milliseconds of processor time, with the wall time in brackets.
//
//   cargo xtask dist && MESHWRIGHT_SITE=dist node tests/frames.mjs
//
// The graphics process draws in software; its time is not included. MESHWRIGHT_TRIANGLES sets the number of triangles.

import { SMALL, browserWith, openPage } from "./harness.mjs";
import { closeBrowsers } from "./support/browsers.mjs";
import { tasksDuring } from "./support/tasks.mjs";

const TRIANGLES = Number(process.env.MESHWRIGHT_TRIANGLES ?? 1_000_000);
const RENDERER = process.env.MESHWRIGHT_RENDERERS ?? "webgl2";
const side = Math.round(Math.sqrt(TRIANGLES / 2));

const browser = await browserWith(RENDERER);
const editor = await openPage({ renderer: RENDERER, size: SMALL });
await editor.ready();

/** Runs a command without returning its outcome: transferring a million ids out of the page would be measured too. */
const run = (command) => editor.page.evaluate(async (command) => { await window.meshwright.run(command); }, command);

/** Runs an action and prints the longest tasks of the page's thread. */
async function watch(what, act) {
  const { page: tasks } = await tasksDuring(browser, editor.page, async () => {
    await act();
    // Without asking for the state: listing the selection takes longer than what is measured.
    await editor.frames(40);
  });
  const times = tasks.slice(0, 4).map(({ wall, busy }) => `${busy.toFixed(0)} (${wall.toFixed(0)})`);
  console.log(`${what.padEnd(36)} ${times.join("  ")}`);
}

const rect = async () => (await editor.state()).view.rect;
const middle = async () => {
  const [x, y, width, height] = await rect();
  return [x + width / 2, y + height / 2];
};

console.log(`${2 * side * side} triangles, ${RENDERER}: processor time (and wall time) in ms of the longest tasks`);
await run({ op: "set-object-visible", object: 0, visible: false });
await watch("a grid comes from the worker", () =>
  run({ op: "new", shape: "grid", columns: side, rows: side, size: 10 }));
await watch("cut into triangles, from the worker", () => run({ op: "triangulate-faces" }));
await watch("smoothed, from the worker", () => run({ op: "smooth" }));
await watch("undo", () => editor.undo());
await watch("redo", () => editor.redo());
await editor.frames(4);
await watch("first hover", async () => {
  await editor.page.mouse.move(...await middle());
  await editor.frames(4);
});
await watch("second hover", async () => {
  const [x, y] = await middle();
  await editor.page.mouse.move(x + 30, y + 20);
  await editor.frames(4);
});
await watch("a vertex moved", () => run({ op: "set-vertex-position", vertex: 5, position: [0, 0, 1] }));
await watch("the first colour", () => run({ op: "set-face-color", faces: [7], color: "#ff0000" }));
await watch("the second colour", () => run({ op: "set-face-color", faces: [9], color: "#00ff00" }));
for (const [key, kind] of [["1", "vertices"], ["2", "edges"], ["4", "faces"]]) {
  await editor.press(key);
  await watch(`box over all ${kind}`, async () => {
    const [x, y, width, height] = await rect();
    await editor.page.keyboard.down("Control");
    await editor.drag([x + 4, y + 40], [x + width - 4, y + height - 4], { steps: 3 });
    await editor.page.keyboard.up("Control");
  });
  await editor.press("Escape");
}
await watch("everything selected", () => editor.press("Control+a"));
await editor.press("Escape");
await watch("the save dialog", () => editor.press("Control+s"));
await editor.press("Escape");
await watch("saved as OBJ, in the worker", () => editor.page.evaluate(async () => {
  await window.meshwright.export("obj");
}));

await editor.close();
await closeBrowsers();
process.exit(0);
