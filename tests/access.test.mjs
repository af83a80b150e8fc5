// The page for screen readers and for the keyboard alone: the mirror of the controls in the document.

import assert from "node:assert/strict";

import { PHONE, SMALL, editorTest } from "./harness.mjs";
import { axe } from "./support/packages.mjs";

/** Fails when axe finds something wrong in the document as it is. */
async function audit(editor, state) {
  await editor.frames(3);
  if (!(await editor.page.evaluate(() => "axe" in window))) await editor.page.evaluate(axe.source);
  const { violations, passes } = await editor.page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  assert.ok(passes.length > 10, `${state}: axe has rules that apply`);
  const told = violations.map(({ id, help, nodes }) => `${id}: ${help}\n  ${nodes.map((node) => node.html).slice(0, 5).join("\n  ")}`);
  assert.deepEqual(told, [], state);
}

/** What a screen reader is on, by Chromium's own accessibility tree: the element to which the focused one points. */
async function focused(editor) {
  const session = await editor.context.newCDPSession(editor.page);
  const { nodes } = await session.send("Accessibility.getFullAXTree");
  await session.detach();
  const property = (node, name) => node.properties?.find((property) => property.name === name)?.value;
  const holder = nodes.filter((node) => property(node, "focused")?.value).at(-1);
  const [target] = property(holder, "activedescendant")?.relatedNodes ?? [];
  const node = nodes.find((node) => node.backendDOMNodeId === target?.backendDOMNodeId);
  return node && { role: node.role.value, name: node.name.value, description: node.description?.value };
}

editorTest("axe finds nothing wrong in any state", { renderers: ["webgl2"], sizes: [SMALL] }, async (editor) => {
  await audit(editor, "at the start");
  await editor.select("face", [2]);
  await audit(editor, "with a face selected");
  await editor.byRole("button", "File");
  await audit(editor, "with a menu open");
  await editor.press("Escape");
  await editor.press("Control+k");
  await editor.page.keyboard.type("simplify");
  await audit(editor, "in the palette");
  await editor.press("Enter");
  await audit(editor, "with a form open");
  await editor.press("Escape");
  await editor.press("Control+s");
  await audit(editor, "in the save dialog");
  await editor.press("Escape");
  await editor.press("F1");
  await audit(editor, "in the list of keys");
  await editor.press("Escape");
  await editor.choose("Share");
  await editor.find("Link", "textInput");
  await audit(editor, "with the window that shares");
  await editor.press("Escape");
  await editor.select("face", [2]);
  await editor.press("e");
  await editor.find("Apply", "button");
  await audit(editor, "in an edit that follows the pointer");
  await editor.press("1");
  await editor.press("Enter");
  if (!(await editor.ui()).some(({ name }) => name === "Steps")) await editor.choose("History");
  await editor.find("Steps", "listBox");
  await audit(editor, "with the list of steps");
  await editor.drop({ name: "broken.obj", content: "v 0 0\n" });
  await audit(editor, "with an error");
});

editorTest("axe finds nothing wrong in the welcome view", { renderers: ["webgl2"], sizes: [SMALL, PHONE], welcome: true }, async (editor) => {
  await editor.find("Close welcome", "button");
  await audit(editor, "in the welcome view");
});

editorTest("axe finds nothing wrong on a phone", { renderers: ["webgl2"], sizes: [PHONE] }, async (editor) => {
  await audit(editor, "at the start");
  await editor.click("Menu", "button");
  await audit(editor, "with the menu open");
});

editorTest("a screen reader follows the focus and activates controls", { renderers: ["webgl2"], sizes: [SMALL] }, async (editor) => {
  const { page } = editor;
  const viewport = await editor.until("a focus", () => focused(editor));
  assert.equal(viewport.role, "application");
  assert.equal(viewport.name, "Viewport");
  assert.match(viewport.description, /^Cube: 8 vertices, 12 edges, 6 faces/);

  await editor.press("Tab");
  assert.deepEqual([(await focused(editor)).role, (await focused(editor)).name], ["button", "File"]);
  assert.equal(await page.evaluate(() => document.activeElement.id), "meshwright", "the keys stay with the canvas");

  // Activated as assistive technology does it: without the pointer.
  const mirrored = (role, name) => page.getByRole(role, { name, exact: true });
  await mirrored("tab", "Faces").dispatchEvent("click");
  await mirrored("option", "Face 3").dispatchEvent("click");
  await editor.until("the face is selected", async () => (await editor.state()).selection.ids[0] === 3);
  await editor.frames();
  assert.deepEqual((await editor.state()).selection, { kind: "face", ids: [3] });
  assert.equal(await mirrored("option", "Face 3").getAttribute("aria-selected"), "true");
  assert.match(await page.locator("#said").textContent(), /Face 3 is selected/);

  // A row follows the arrow keys.
  await mirrored("listbox", "Faces").evaluate((element) => element.focus());
  await editor.frames();
  await editor.press("ArrowUp");
  assert.deepEqual([(await focused(editor)).role, (await focused(editor)).name], ["option", "Face 2"]);

  // A number and a text are set.
  await editor.select("vertex", [7]);
  await editor.frames();
  const set = (locator, value) => locator.evaluate((element, value) => {
    element.value = value;
    element.dispatchEvent(new Event("input", { bubbles: true }));
  }, value);
  await set(mirrored("spinbutton", "Position x"), "1.5");
  await editor.until("the vertex moves", async () => (await editor.element("vertex", 7)).position[0] === 1.5);
  await set(mirrored("textbox", "Go to id"), "4");
  await editor.until("the field has the text", async () => (await editor.find("Go to id", "textInput")).value === "4");
  await editor.press("Enter");
  assert.deepEqual((await editor.state()).selection, { kind: "vertex", ids: [4] });

  // Errors interrupt.
  await editor.drop({ name: "broken.obj", content: "v 0 0\n" });
  await editor.until("the error is told", async () => /broken/.test(await page.locator("#alerted").textContent()));
});

editorTest("the mirror lets the pointer through and lies over the controls", { renderers: ["webgl2"], sizes: [SMALL] }, async (editor) => {
  const { page } = editor;
  for (const node of await editor.ui()) {
    const [x, y, width, height] = node.rect;
    const at = [x + width / 2, y + height / 2];
    assert.equal(await page.evaluate(([x, y]) => document.elementFromPoint(x, y).id, at), "meshwright", node.name);
    if (node.role !== "button") continue;
    const box = await page.getByRole("button", { name: node.name, exact: true }).first().boundingBox();
    assert.ok(Math.abs(box.x - x) <= 1.5 && Math.abs(box.y - y) <= 1.5, `${node.name}: ${JSON.stringify(box)} ${node.rect}`);
    assert.ok(Math.abs(box.width - width) <= 1.5 && Math.abs(box.height - height) <= 1.5, node.name);
  }
});
