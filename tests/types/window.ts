// Scripts on the page itself. `types.test.mjs` compiles this; it never runs.

import type { Command, Outcome } from "../../web/meshwright";

export async function useWindow(): Promise<number> {
  const { meshwright } = window;
  const { renderer } = await meshwright.ready;
  const name: "webgpu" | "webgl2" = renderer;
  await meshwright.open(`${name}.obj`, "v 0 0 0\n");
  await meshwright.openFiles([{ name: "a.stl", content: new Uint8Array(84) }]);

  const outcome: Outcome = await meshwright.run({ op: "extrude-faces", faces: [0], distance: 0.5 });
  const commands: Command[] = [{ op: "split-edge", edge: [0, 1] }, { op: "new", shape: "torus" }];
  for (const command of commands) await meshwright.run(command);
  // @ts-expect-error There is no such operation.
  await meshwright.run({ op: "extrude" });
  // @ts-expect-error The position is required.
  await meshwright.run({ op: "set-vertex-position", vertex: 3 });
  // @ts-expect-error An edge is a number or a pair of vertices.
  await meshwright.run({ op: "split-edge", edge: "first" });
  // @ts-expect-error The operation has no such field.
  await meshwright.run({ op: "poke-faces", distance: 1 });

  const corners: number[] = meshwright.element("face", 0).corners;
  const twin: number = meshwright.element("halfedge", 0).twin;
  // @ts-expect-error Only faces have corners.
  meshwright.element("vertex", 0).corners;
  meshwright.select("edge", corners);
  // @ts-expect-error There is no such kind of element.
  meshwright.select("corner", []);

  const end: () => void = meshwright.on("selection", ({ kind, count }) => console.log(kind, count));
  // @ts-expect-error There is no such event.
  meshwright.on("everything", () => {});
  end();
  const undone: string | null = meshwright.undo();
  const at: [number, number] | null = meshwright.project([0, 0, 0]);
  return outcome.created.faces + twin + (undone?.length ?? 0) + (at?.[0] ?? 0);
}
