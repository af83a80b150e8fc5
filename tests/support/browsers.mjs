// One browser per renderer and test file, started when first wanted.

import { chromium } from "./packages.mjs";

const ALWAYS = [
  "--no-sandbox",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
  "--disable-quic",
];

// These draw in software: they work on a machine with no GPU and draw the same on every other.
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

/** The browser whose pages find this renderer: "webgpu", "webgl2" or "none". */
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
