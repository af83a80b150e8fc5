// A narrow touch screen: everything can be reached, is large enough for a finger, and fits.

import assert from "node:assert/strict";

import { PHONE, editorTest } from "./harness.mjs";
import { grid } from "./support/meshes.mjs";

editorTest("the editor is usable on a phone", { sizes: [PHONE] }, async (editor) => {
  const { width, height } = editor.size;
  const inside = async (what) => {
    for (const node of await editor.ui()) {
      const [x, y, w, h] = node.rect;
      assert.ok(x >= -1 && y >= -1 && x + w <= width + 1 && y + h <= height + 1, `${what}: ${JSON.stringify(node)}`);
    }
  };
  const buttons = (await editor.ui()).filter((node) => ["button", "tab", "listBoxOption"].includes(node.role));
  // Edges cut the last row of the list and the last of the tools, which scroll.
  const cut = [
    buttons.findLast((node) => node.role === "listBoxOption"),
    buttons.findLast((node) => node.name.startsWith("Tool: ")),
  ];
  for (const { name, rect } of buttons.filter((node) => !cut.includes(node))) {
    assert.ok(rect[3] >= 43.5, `${name} is ${rect[3]} high, too small for a finger`);
  }
  await inside("at the start");

  // Select in the list, edit in the inspector.
  await editor.byRole("option", "Vertex 3");
  assert.deepEqual((await editor.state()).selection, { kind: "vertex", ids: [3] });
  await editor.byRole("tab", "Inspector");
  await editor.find("Position x", "spinButton");
  await inside("the inspector");
  await editor.screenshot("inspector");

  // Run an operation and undo it.
  await editor.byRole("tab", "Operations");
  await inside("the operations");
  await editor.byRole("button", "Upsample (subdivide)");
  await editor.idle();
  assert.equal((await editor.state()).document.faces, 24);
  await editor.byRole("button", "Undo");
  assert.equal((await editor.state()).document.faces, 6);

  // With the sheet closed, the viewport fills the screen, and a tap in it selects.
  const [, , , before] = (await editor.state()).view.rect;
  await editor.byRole("tab", "Operations");
  const [, , wide, tall] = (await editor.state()).view.rect;
  assert.ok(wide >= width - 2 && tall > before + 200, `the viewport is ${wide} × ${tall}`);
  await editor.select("face", [0]);
  await editor.frames(2);
  const corners = await Promise.all((await editor.element("face", 0)).corners.map(async (id) =>
    (await editor.element("vertex", id)).position));
  const at = await editor.project([0, 1, 2].map((axis) => corners.reduce((sum, p) => sum + p[axis] / 4, 0)));
  await editor.clickAt(at);
  const { selection } = await editor.state();
  assert.equal(selection.kind, "face");
  assert.equal(selection.ids.length, 1);
  await editor.screenshot("viewport");

  // Open a file and the menu.
  await editor.drop({ name: "sheet.obj", content: grid(10, 10) });
  await editor.until("the file is open", async () => (await editor.state()).document.faces === 100);
  await editor.byRole("button", "Menu");
  await editor.find("File", "button");
  const all = (await editor.ui()).filter((node) => node.role === "button");
  const lastTool = all.findLast((node) => node.name.startsWith("Tool: "));
  for (const { name, rect } of all.filter((node) => node !== lastTool)) {
    assert.ok(rect[3] >= 43.5 && !/Ctrl\+/.test(name), `${name} is ${rect[3]} high`);
  }
  await inside("the menu");
  await editor.screenshot("menu");
});
