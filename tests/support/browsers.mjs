// One browser for each renderer, started when first needed.

import { chromium } from "./packages.mjs";

const ALWAYS = [
  "--no-sandbox",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
  "--disable-quic",
];

// Flags for drawing in software, which works without a GPU and gives the same picture everywhere.
const RENDERER = {
  webgpu: [
    "--enable-unsafe-webgpu",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--use-webgpu-adapter=swiftshader",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
  ],
  webgl2: ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  none: ["--disable-gpu", "--disable-3d-apis"],
};

const running = new Map();

/** The browser in which pages can use only this renderer: "webgpu", "webgl2" or "none". */
export function browserWith(renderer) {
  if (!running.has(renderer)) {
    running.set(renderer, chromium.launch({
      executablePath: process.env.MESHWRIGHT_CHROMIUM ?? "/usr/bin/chromium",
      args: [...ALWAYS, ...RENDERER[renderer]],
    }));
  }
  return running.get(renderer);
}

export async function closeBrowsers() {
  const browsers = await Promise.allSettled(running.values());
  running.clear();
  await Promise.all(browsers.map((browser) => browser.value?.close()));
}
