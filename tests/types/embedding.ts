// A page that embeds the editor. `types.test.mjs` compiles this; it never runs.

import { embed, type Embedded } from "../../web/embed/meshwright-embed.js";

export async function useEmbedded(container: HTMLElement): Promise<void> {
  const editor: Embedded = embed(container, { panels: ["tools", "status"], model: "bunny.obj" });
  await editor.ready;
  const state = await editor.state();
  const faces: number = state.document.faces;
  const outcome = await editor.run({ op: "subdivide-catmull-clark" });
  const bytes: Uint8Array = await editor.export("ply");

  const position: number[] = (await editor.element("vertex", 0)).position;
  const corners: number[] = (await editor.element("face", 0)).corners;
  // @ts-expect-error A call's result is a promise.
  editor.element("edge", 0).id;
  // @ts-expect-error Only faces have corners.
  (await editor.element("vertex", 0)).corners;

  const end = editor.on("change", ({ name, last }) => console.log(name, last ?? "", outcome.message));
  end();
  // @ts-expect-error There is no such panel.
  embed(container, { panels: ["toolbar"] });
  // @ts-expect-error Embedding pages can't read the widgets.
  await editor.ui();
  editor.frame.title = `${faces} ${bytes.length} ${position.length} ${corners.length}`;
  editor.remove();
}
