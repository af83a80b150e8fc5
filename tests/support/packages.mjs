// The npm packages that set-up puts into the tools folder; an `import` would look for them beside this file.

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

/** The built page: `cargo xtask test --only e2e` names it. */
export const site = resolve(project, process.env.MESHWRIGHT_SITE ?? "dist");

/** Where screenshots go. */
export const shots = resolve(project, process.env.MESHWRIGHT_SHOTS ?? "target/screenshots");
