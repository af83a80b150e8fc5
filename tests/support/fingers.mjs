// Fingers on a touch screen.

/** Moves fingers, each along [from, to]. */
export async function fingers(editor, ...ways) {
  const session = await editor.context.newCDPSession(editor.page);
  const at = (part) => ways.map(([from, to], id) => ({
    id,
    x: from[0] + (to[0] - from[0]) * part,
    y: from[1] + (to[1] - from[1]) * part,
  }));
  const send = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  // A finger that rests for half a second opens the context menu, so the first move comes at once.
  await send("touchStart", at(0));
  for (let step = 1; step <= 6; step += 1) {
    await send("touchMove", at(step / 6));
    await editor.frames(1);
  }
  await send("touchEnd", []);
  await editor.frames(3);
  await session.detach();
}
