// The npm packages that set-up installs into the tools folder, where an `import` would not find them.

import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const project = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
const tools = resolve(project, process.env.MESHWRIGHT_TOOLS ?? ".tools");
const require = createRequire(join(tools, "node", "package.json"));

function load(name) {
  try {
    return require(name);
  } catch (error) {
    throw new Error(`The npm package ${name} is not in ${tools}: run \`cargo xtask setup\`.`, { cause: error });
  }
}

export const { chromium } = load("playwright-core");
export const { PNG } = load("pngjs");
export const axe = load("axe-core");
export const jsqr = load("jsqr");
export const typescript = load("typescript");

/** The folder of the built page, which `cargo xtask test --only e2e` sets. */
export const site = resolve(project, process.env.MESHWRIGHT_SITE ?? "dist");

/** The folder of the screenshots. */
export const shots = resolve(project, process.env.MESHWRIGHT_SHOTS ?? "target/screenshots");

/** The program `meshwright`, which `cargo xtask test --only e2e` builds. */
export const cli = resolve(project, process.env.MESHWRIGHT_CLI ?? "target/debug/meshwright");
