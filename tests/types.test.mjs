// The types that the site offers to scripts and embedding pages, by the TypeScript compiler: right calls compile, and wrong
// ones (marked `@ts-expect-error`) don't.

import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { browserTest } from "./harness.mjs";
import { typescript as ts } from "./support/packages.mjs";

const OPTIONS = {
  lib: ["lib.es2022.d.ts", "lib.dom.d.ts"],
  module: ts.ModuleKind.ES2022,
  moduleResolution: ts.ModuleResolutionKind.Bundler,
  noEmit: true,
  strict: true,
  target: ts.ScriptTarget.ES2022,
  types: [],
};

browserTest("none", "the types fit what scripts and embedding pages do, and refuse what is wrong", {}, () => {
  const folder = fileURLToPath(new URL("types/", import.meta.url));
  const files = readdirSync(folder).map((name) => join(folder, name));
  assert.ok(files.length >= 2);
  const problems = ts.getPreEmitDiagnostics(ts.createProgram(files, OPTIONS));
  assert.equal(ts.formatDiagnostics(problems, {
    getCanonicalFileName: (name) => name,
    getCurrentDirectory: () => folder,
    getNewLine: () => "\n",
  }), "");
});
