// The page's security policy: nothing that the editor does violates it, and no request leaves the page's origin unless the
// user asked for the address.

import assert from "node:assert/strict";

import { SMALL, browserTest, openPage, serve, site } from "./harness.mjs";
import { grid } from "./support/meshes.mjs";

/** Notes violations of the policy in every frame, from the start; returns a function that gives them. */
async function watchViolations(editor) {
  await editor.context.exposeFunction("noteViolation", (text) => { editor.violations.push(text); });
  editor.violations = [];
  await editor.context.addInitScript(() => {
    document.addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI }) => {
      window.noteViolation(`${effectiveDirective}: ${blockedURI}`);
    });
  });
  editor.requests = [];
  editor.context.on("request", (request) => editor.requests.push(request.url()));
  await editor.page.reload();
}

function policyTest(name, query, body) {
  browserTest("webgl2", name, {}, async () => {
    const editor = await openPage({ renderer: "webgl2", size: SMALL, label: name, query });
    try {
      await watchViolations(editor);
      await body(editor);
    } finally {
      await editor.close();
    }
  });
}

policyTest("opening, editing and saving violate no policy and send no requests elsewhere", "", async (editor) => {
  await editor.ready();
  await editor.open("grid.obj", grid(3, 3));
  await editor.drop({ name: "dropped.obj", content: grid(2, 2) });
  await editor.until("the file is open", async () => (await editor.state()).document.vertices === 9);
  await editor.select("face", [0]);
  await editor.run({ op: "subdivide-catmull-clark" });
  await editor.undo();
  const [download] = await Promise.all([
    editor.page.waitForEvent("download"),
    (async () => {
      await editor.press("Control+s");
      await editor.click("Save", "button");
    })(),
  ]);
  assert.match(download.suggestedFilename(), /^dropped\./);
  await editor.page.reload();
  await editor.ready();

  editor.assertNoErrors();
  assert.deepEqual(editor.violations, []);
  const { origin } = new URL(editor.url);
  // Blobs are of the page itself.
  const elsewhere = editor.requests.filter((url) => !url.startsWith(`${origin}/`) && !url.startsWith(`blob:${origin}/`));
  assert.deepEqual(elsewhere, []);
  assert.ok(editor.requests.length > 3, "requests are seen");
});

policyTest("embedding violates no policy", "embed/example.html", async (editor) => {
  await editor.page.waitForFunction(() => document.querySelector("#torus")?.disabled === false);
  await editor.page.click("#torus");
  await editor.page.waitForFunction(() => document.querySelector("#log").textContent.includes("Torus"));
  editor.assertNoErrors();
  assert.deepEqual(editor.violations, []);
});

policyTest("scripts of the page can neither evaluate text nor add inline scripts and styles", "", async (editor) => {
  await editor.ready();
  editor.expectErrors(/Content Security Policy/);
  // From a script of the page's own, as a fault in the editor would have it.
  await editor.page.evaluate(() => {
    const script = document.createElement("script");
    script.textContent = "window.injected = true;";
    document.body.append(script);
    document.body.insertAdjacentHTML("beforeend", "<p style='color: red' id='styled'>styled</p>");
  });
  assert.equal(await editor.page.evaluate(() => window.injected), undefined);
  assert.equal(await editor.page.locator("#styled").evaluate((element) => element.style.color), "");
  const directives = editor.violations.map((text) => text.split(":")[0]);
  assert.deepEqual(directives.sort(), ["script-src-elem", "style-src-attr"]);
});

policyTest("other origins are reached only if the address asks for a file", "", async (editor) => {
  await editor.ready();
  const other = await serve(site, "/", { headers: { "access-control-allow-origin": "*" } });
  try {
    const reach = () => editor.page.evaluate(
      (url) => fetch(url).then((response) => response.status, () => "refused"), `${other.url}icon.svg`,
    );
    editor.expectErrors(/Content Security Policy|Failed to fetch/);
    assert.equal(await reach(), "refused");
    await editor.page.goto(`${editor.url}?model=${encodeURIComponent("data:,v 0 0 0%0Av 1 0 0%0Av 0 1 0%0Af 1 2 3")}`);
    await editor.ready();
    assert.equal(await reach(), 200);
  } finally {
    await other.stop();
  }
});
