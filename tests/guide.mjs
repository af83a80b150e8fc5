// Takes the pictures of docs/guide from the running page, all or those that are named:
//
//   MESHWRIGHT_SITE=<the built site> node tests/guide.mjs [selecting moving …]
//
// `cargo xtask test --only e2e` leaves a site in the target folder, under site/test. Look at the pictures before you commit them.

import { mkdir, readFile, writeFile } from "node:fs/promises";

import { Editor, Picture, serve, site } from "./harness.mjs";
import { scenes } from "./support/scenes.mjs";
import { closeBrowsers } from "./support/browsers.mjs";
import { palettePng } from "./support/palette.mjs";

const FOLDER = new URL("../docs/guide/pictures/", import.meta.url);
const MAX_BYTES = 60_000;
const MAX_BYTES_IN_ALL = 700_000;
/** Enough frames for the view's glide and for hints that fade in. */
const REST_FRAMES = 30;

const named = process.argv.slice(2);
const unknown = named.filter((name) => !scenes.some((scene) => scene.name === name));
if (unknown.length > 0) throw new Error(`There is no picture ${unknown.join(", ")}; see tests/support/scenes.mjs.`);

await mkdir(FOLDER, { recursive: true });
const server = await serve(site, "/some/where/");
let heavy = [];
try {
  for (const scene of scenes.filter(({ name }) => named.length === 0 || named.includes(name))) {
    const size = scene.size ?? { width: 1080, height: 660 };
    const editor = await Editor.open(server.url + (scene.query ?? ""), {
      renderer: "webgl2",
      size,
      colorScheme: "dark",
      label: scene.name,
      welcome: scene.welcome,
      settings: scene.settings,
    });
    await editor.ready();
    const clip = await scene.show(editor);
    await editor.frames(REST_FRAMES);
    editor.assertNoErrors();
    const picture = new Picture(await editor.page.screenshot(clip && { clip: rectangle(clip, size) }));
    const bytes = palettePng(picture);
    await writeFile(new URL(`${scene.name}.png`, FOLDER), bytes);
    console.log(`${scene.name}.png: ${picture.width} x ${picture.height}, ${Math.ceil(bytes.length / 1000)} kB`);
    if (bytes.length > MAX_BYTES) heavy.push(scene.name);
    await editor.close();
  }
} finally {
  await closeBrowsers();
  await server.stop();
}

const all = await Promise.all(scenes.map(({ name }) => readFile(new URL(`${name}.png`, FOLDER)).catch(() => Buffer.alloc(0))));
const sum = all.reduce((sum, { length }) => sum + length, 0);
console.log(`All pictures: ${Math.ceil(sum / 1000)} kB`);
if (sum > MAX_BYTES_IN_ALL) heavy.push("all of them together");
if (heavy.length > 0) {
  console.error(`Too large: ${heavy.join(", ")}. Crop them, or show less.`);
  process.exitCode = 1;
}

/** The part of the page in a rectangle [x, y, width, height], as Playwright takes it. */
function rectangle([x, y, width, height], size) {
  const [left, top] = [Math.max(Math.floor(x), 0), Math.max(Math.floor(y), 0)];
  return { x: left, y: top, width: Math.min(Math.ceil(width), size.width - left), height: Math.min(Math.ceil(height), size.height - top) };
}
