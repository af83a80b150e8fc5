// Draws the icons of web/site from its icon.svg, after a change of that:
//
//   cd tests && node icons.mjs

import { readFile, writeFile } from "node:fs/promises";

import { browserWith, closeBrowsers } from "./support/browsers.mjs";

const folder = new URL("../web/site/", import.meta.url);
const svg = await readFile(new URL("icon.svg", folder), "utf8");

/** The icon in a square of this size. A maskable one fills the square, and has what matters in its middle. */
async function draw(name, size, { maskable = false } = {}) {
  const page = await (await browserWith("none")).newPage({ viewport: { width: size, height: size } });
  const part = maskable ? 0.8 : 1;
  const inset = (size * (1 - part)) / 2;
  await page.setContent(`<style>
    body { margin: 0; background: ${maskable ? "#1a1d22" : "transparent"}; }
    svg { position: absolute; inset: ${inset}px; width: ${size * part}px; height: ${size * part}px; }
  </style>${svg}`);
  await writeFile(new URL(name, folder), await page.screenshot({ omitBackground: true }));
  await page.close();
}

await draw("icon-192.png", 192);
await draw("icon-512.png", 512);
await draw("icon-maskable-512.png", 512, { maskable: true });
await closeBrowsers();
