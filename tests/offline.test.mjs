// The service worker: the page works offline after the first visit, newer versions are offered and not forced, and files that
// other programs share arrive.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { cp, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { Editor, SMALL, browserTest, serve, site } from "./harness.mjs";
import { grid } from "./support/meshes.mjs";

/** Adds a test on a copy of the site, which may change. */
function offlineTest(name, body) {
  browserTest("webgl2", name, {}, async () => {
    const folder = await mkdtemp(join(tmpdir(), "meshwright-offline-"));
    await cp(site, folder, { recursive: true });
    const server = await serve(folder, "/some/where/");
    const editor = await Editor.open(server.url, {
      renderer: "webgl2", size: SMALL, label: name, serviceWorkers: "allow",
    });
    try {
      await editor.ready();
      // The first visit ends once everything is kept.
      await editor.page.evaluate(() => navigator.serviceWorker.ready);
      await body(editor, { folder, server });
      editor.assertNoErrors();
    } finally {
      await editor.close();
      await server.stop();
      await rm(folder, { recursive: true });
    }
  });
}

/** Changes a file of the site, as a newer build does. */
async function release(folder, name, change) {
  const path = join(folder, name);
  await writeFile(path, change(await readFile(path, "utf8")));
  const hash = createHash("sha256").update(await readFile(path)).digest("base64");
  const script = join(folder, "service-worker.js");
  const text = await readFile(script, "utf8");
  const line = new RegExp(`\\["${name}", "sha256-[^"]*"\\]`);
  assert.match(text, line);
  const updated = text.replace(line, `["${name}", "sha256-${hash}"]`);
  const version = createHash("sha256").update(updated).digest("hex").slice(0, 16);
  await writeFile(script, updated.replace(/VERSION = "[^"]*"/, `VERSION = "${version}"`));
}

const offer = async (editor) =>
  (await editor.ui()).some(({ role, name }) => role === "alert" && name?.includes("new version"));

offlineTest("the page works without the network after the first visit", async (editor, { server }) => {
  await server.stop();
  await editor.page.reload();
  await editor.ready();
  // A job needs the worker's program.
  await editor.open("grid.obj", grid(3, 3));
  await editor.run({ op: "subdivide-catmull-clark" });
  assert.equal((await editor.state()).document.faces, 36);
  // Another address of the page, and the page itself by its name.
  for (const query of ["?keys=blender", "index.html"]) {
    await editor.page.goto(editor.url + query);
    await editor.ready();
  }
  await editor.screenshot("offline");
});

offlineTest("a newer version is offered, and comes when the user asks for it", async (editor, { folder }) => {
  await editor.page.reload();
  await editor.ready();
  assert.equal(await offer(editor), false);
  await editor.run({ op: "poke-faces", faces: [0] });
  await release(folder, "index.html", (html) => html.replace("<title>", '<meta name="release" content="newer"><title>'));
  await editor.page.evaluate(async () => (await navigator.serviceWorker.ready).update());
  await editor.until("the newer version is offered", () => offer(editor));
  await editor.screenshot("offer");

  // Nothing has happened to the page, and a reload shows the version that is in use.
  assert.equal((await editor.state()).document.faces, 9);
  await editor.page.reload();
  await editor.ready();
  assert.equal(await editor.page.locator("meta[name=release]").count(), 0);
  await editor.until("the newer version is offered again", () => offer(editor));

  await editor.clickToReload("Reload with the new version");
  assert.equal(await editor.page.locator("meta[name=release]").count(), 1);
  assert.equal((await editor.state()).document.faces, 9, "the document is kept");
  assert.equal(await offer(editor), false);
  const caches = await editor.page.evaluate(() => window.caches.keys());
  assert.equal(caches.length, 1, `what older versions kept is forgotten: ${caches.join()}`);
});

offlineTest("a version that arrives in part is not kept", async (editor, { folder }) => {
  await editor.page.reload();
  await editor.ready();
  // The list is of a build whose page is not there yet.
  const html = await readFile(join(folder, "index.html"), "utf8");
  await release(folder, "index.html", (text) => text.replace("<title>", "<title>Newer "));
  await writeFile(join(folder, "index.html"), html);
  editor.expectErrors(/integrity/);
  await editor.page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    const ended = new Promise((resolve) => {
      registration.addEventListener("updatefound", () => {
        const { installing } = registration;
        installing.addEventListener("statechange", () => { if (installing.state === "redundant") resolve(); });
      });
    });
    await registration.update().catch(() => {});
    await ended;
  });
  assert.equal(await offer(editor), false);
  await editor.page.reload();
  await editor.ready();
});

offlineTest("files that another program shares are opened", async (editor) => {
  await editor.page.reload();
  await editor.ready();
  // The system posts a form like this one; the page's own policy allows it no forms.
  await editor.page.evaluate(async (text) => {
    const data = new FormData();
    data.append("files", new File([text], "shared & more.obj"));
    const answer = await fetch("./share", { method: "POST", body: data, redirect: "manual" });
    if (answer.type !== "opaqueredirect") throw new Error(answer.type);
  }, grid(2, 2));
  await editor.page.goto(`${editor.url}?shared`);
  await editor.ready();
  await editor.until("the file is open", async () => (await editor.state()).document.name === "shared & more");
  assert.equal((await editor.state()).document.faces, 4);
  assert.equal(new URL(editor.page.url()).search, "");
  await editor.page.reload();
  await editor.ready();
  const { document, history } = await editor.state();
  assert.equal(document.name, "shared & more", "the document of the last visit");
  assert.ok(history.undo.length <= 1, "the file is opened once");
});
