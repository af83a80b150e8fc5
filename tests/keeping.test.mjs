// Documents are kept in the browser: whatever ends the page, the next visit goes on where it was.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtemp, readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { SMALL, editorTest } from "./harness.mjs";
import { grid } from "./support/meshes.mjs";
import { cli } from "./support/packages.mjs";

const once = { renderers: ["webgl2"], sizes: [SMALL] };
/** Where documents are kept: the origin private file system, and what takes its place in other browsers. */
const STORES = { "private files": "", IndexedDB: "?store=indexeddb" };

/** What has to come back. The history goes back to the last checkpoint, at least over what was done after it. */
async function kept(editor) {
  const { document, selection, history, view } = await editor.state();
  const { target, yaw, pitch, distance } = view;
  const obj = createHash("sha256").update(await editor.export("obj")).digest("hex");
  return { document, selection, next: history.undo.at(-1), target, yaw, pitch, distance, obj };
}

/** Waits until what was done is on the disk: the store answers in order. */
async function settled(editor) {
  await editor.frames(5);
  await editor.page.waitForTimeout(300);
}

async function reload(editor) {
  await editor.page.reload();
  await editor.ready();
}

/** Ends the page's process, and opens the page again. */
async function crash(editor) {
  const crashed = new Promise((resolve) => editor.page.once("crash", resolve));
  editor.page.goto("chrome://crash").catch(() => {});
  await crashed;
  const other = await editor.context.newPage();
  await editor.page.close();
  editor.page = other;
  await other.goto(editor.url);
  await editor.ready();
}

for (const [store, query] of Object.entries(STORES)) {
  const options = { ...once, query };

  editorTest(`a reload goes on with the document: ${store}`, options, async (editor) => {
    await editor.select("face", [1]);
    await editor.run({ op: "extrude-faces", distance: 0.5 });
    await editor.run({ op: "poke-faces" });
    await editor.select("edge", [2, 3]);
    await settled(editor);
    const before = await kept(editor);
    await reload(editor);
    assert.deepEqual(await kept(editor), before);
    await editor.undo();
    await editor.undo();
    await settled(editor);
    const undone = await kept(editor);
    await reload(editor);
    assert.deepEqual(await kept(editor), undone);
    // Another visit, in a tab of its own, once the first tab is closed.
    const other = await editor.context.newPage();
    await editor.page.close();
    editor.page = other;
    await other.goto(editor.url);
    await editor.ready();
    assert.equal((await editor.state()).document.faces, undone.document.faces);
  });

  editorTest(`the document outlives its process: ${store}`, options, async (editor) => {
    await editor.open("grid.obj", grid(20, 20));
    await editor.run({ op: "triangulate-faces" });
    await settled(editor);
    const before = await kept(editor);
    editor.expectErrors(/crashed/);
    await crash(editor);
    assert.deepEqual(await kept(editor), before);
  });

  editorTest(`a second tab opens a copy: ${store}`, options, async (editor) => {
    await editor.open("grid.obj", grid(2, 2));
    await settled(editor);
    const first = editor.page;
    const second = await editor.context.newPage();
    await second.goto(editor.url);
    editor.page = second;
    await editor.ready();
    assert.equal((await editor.state()).document.faces, 4);
    await editor.find(/open in another tab/);
    await editor.screenshot(`copy ${store.split(" ")[0]}`);
    await editor.run({ op: "new", shape: "torus" });
    editor.page = first;
    await editor.run({ op: "subdivide-catmull-clark" });
    await settled(editor);
    const faces = (await editor.state()).document.faces;
    await reload(editor);
    assert.equal((await editor.state()).document.faces, faces);
  });
}

editorTest("a reload in the middle of a job leaves the document as it was", once, async (editor) => {
  await editor.select("face", [1]);
  await editor.run({ op: "extrude-faces", distance: 0.5 });
  await settled(editor);
  const before = await kept(editor);
  editor.page.evaluate((text) => window.meshwright.open("large.obj", text), grid(500, 500)).catch(() => {});
  await editor.frames(2);
  await reload(editor);
  assert.deepEqual(await kept(editor), before);
});

editorTest("without room the page says so and goes on", once, async (editor) => {
  const session = await editor.context.newCDPSession(editor.page);
  const origin = new URL(editor.url).origin;
  await session.send("Storage.overrideQuotaForOrigin", { origin, quotaSize: 20_000 });
  await editor.run({ op: "new", shape: "torus", segments: 200, tube_segments: 100 });
  await editor.select("vertex", [0]);
  await editor.run({ op: "transform", translate: [0.5, 0, 0] });
  await editor.find(/Changes are not kept: the storage has no more room/);
  await editor.screenshot("no room");
  await editor.run({ op: "transform", translate: [0.5, 0, 0] });
  await session.send("Storage.overrideQuotaForOrigin", { origin });
});

editorTest("a full disk leaves the last document where it is", once, async (editor) => {
  await editor.select("face", [1]);
  await editor.run({ op: "extrude-faces", distance: 0.5 });
  await settled(editor);
  const session = await editor.context.newCDPSession(editor.page);
  const origin = new URL(editor.url).origin;
  await session.send("Storage.overrideQuotaForOrigin", { origin, quotaSize: 1 });
  await reload(editor);
  assert.equal((await editor.state()).document.faces, 10);
  await session.send("Storage.overrideQuotaForOrigin", { origin });
});

editorTest("what visits leave behind is removed, but no document that a tab shows", once, async (editor) => {
  const folders = () => editor.page.evaluate(async () => {
    const root = await (await navigator.storage.getDirectory()).getDirectoryHandle("meshwright");
    const names = [];
    for await (const name of root.keys()) names.push(name);
    return names.sort();
  });
  await editor.select("face", [1]);
  await editor.run({ op: "extrude-faces", distance: 0.5 });
  await settled(editor);
  const first = editor.page;
  const [kept, ...others] = await folders();
  assert.deepEqual(others, []);
  for (let at = 0; at < 2; at += 1) {
    editor.page = await editor.context.newPage();
    await editor.page.goto(editor.url);
    await editor.ready();
    await settled(editor);
    const shown = await folders();
    assert.ok(shown.length === 2 && shown.includes(kept), `${shown}: the document and this visit's copy`);
    await editor.page.close();
  }
  editor.page = first;
  await editor.run({ op: "poke-faces" });
  await settled(editor);
  const { faces } = (await editor.state()).document;
  await reload(editor);
  assert.equal((await editor.state()).document.faces, faces);
});

editorTest("where nothing can be kept the page works and says so", once, async (editor) => {
  await editor.context.route("**/without-storage.js?*", (route) => route.fulfill({
    contentType: "text/javascript",
    body: `Object.defineProperty(self.navigator, "storage", { value: undefined });
      Object.defineProperty(self, "indexedDB", { value: undefined });
      import(decodeURIComponent(self.location.search.slice(1)));`,
  }));
  await editor.context.addInitScript(() => {
    const Real = window.Worker;
    // The store's worker finds neither kind of storage.
    window.Worker = class extends Real {
      constructor(url, options) {
        if (!options.name.startsWith("meshwright-store")) return new Real(url, options);
        const program = encodeURIComponent(String(new URL(url, document.baseURI)));
        return new Real(new URL(`without-storage.js?${program}`, document.baseURI), options);
      }
    };
  });
  await reload(editor);
  await editor.select("face", [1]);
  await editor.run({ op: "extrude-faces", distance: 0.5 });
  await editor.find(/Changes are not kept/);
});

/** Numbers that look random and are the same each time. */
function* randoms(seed) {
  for (let state = seed; ;) {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    yield state / 2 ** 32;
  }
}

editorTest("commands with reloads and crashes in between give what the command line gives", once, async (editor) => {
  const random = randoms(7);
  const pick = (count) => Math.floor(random.next().value * count);
  const amount = () => Math.round(random.next().value * 64) / 64;
  const folder = await mkdtemp(join(tmpdir(), "meshwright-soak-"));
  const [start, result] = [join(folder, "start.obj"), join(folder, "result.json")];
  const cube = await editor.export("obj");
  await writeFile(start, cube);
  await editor.open("start.obj", cube);
  const any = () => [
    { op: "extrude-faces", faces: [pick(6)], distance: amount() },
    { op: "inset-faces", faces: [pick(6)], amount: amount() / 2 },
    { op: "poke-faces", faces: [pick(6)] },
    { op: "triangulate-faces", faces: [pick(6)] },
    { op: "transform", vertices: [pick(8), pick(8)], translate: [amount(), 0, -amount()] },
    { op: "set-vertex-position", vertex: pick(8), position: [amount(), amount(), amount()] },
    { op: "smooth", iterations: 1 },
  ][pick(7)];
  const ends = [
    () => reload(editor),
    () => crash(editor),
  ];
  editor.expectErrors(/crashed/);
  const done = [];
  for (let at = 0; at < 24; at += 1) {
    const command = any();
    await editor.run(command).then(() => done.push(command), () => {});
    if (at % 6 === 5) {
      // What was done is on its way to the disk within the frame.
      await settled(editor);
      await ends[(at / 6 | 0) % ends.length]();
    }
  }
  assert.ok(done.length > 12);
  execFileSync(cli, ["apply", start, ...done.flatMap((command) => ["--do", JSON.stringify(command)]), "-o", result]);
  const [page, line] = [JSON.parse(await editor.export("json")), JSON.parse(await readFile(result))];
  assert.deepEqual({ positions: page.positions, faces: page.faces }, { positions: line.positions, faces: line.faces });
});
