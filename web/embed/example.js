import { embed } from "./meshwright-embed.js";

const log = document.getElementById("log");
const note = (text) => {
  const line = document.createElement("li");
  line.textContent = text;
  log.prepend(line);
};

const editor = embed(document.getElementById("editor"), { panels: ["tools"] });
window.editor = editor;

const { version, renderer } = await editor.ready;
note(`Meshwright ${version} is ready and draws with ${renderer}.`);

editor.on("change", ({ name, last }) => note(`${name}: ${last ?? "opened"}`));
editor.on("selection", ({ kind, count }) => note(`Selected: ${count} × ${kind}`));

document.getElementById("torus").addEventListener("click", () => editor.run({ op: "new", shape: "torus" }));
document.getElementById("subdivide").addEventListener("click", async () => {
  try {
    const outcome = await editor.run({ op: "subdivide-catmull-clark" });
    note(outcome.message);
  } catch (error) {
    note(error.message);
  }
});
document.getElementById("undo").addEventListener("click", () => editor.undo());
for (const button of document.querySelectorAll("button")) button.disabled = false;
