// What the page draws with: devices that are lost, or work by half, are replaced without a question.

import assert from "node:assert/strict";

import { SMALL, browserTest, editorTest, openPage } from "./harness.mjs";

const sizes = [SMALL];
/** Chrome says on the console that a context or a device was lost. */
const LOST = /CONTEXT_LOST|context lost|[Dd]evice (was )?(lost|destroyed)|A valid external Instance reference no longer exists/;

/** Loses the device that the page draws with. */
function lose(editor) {
  return editor.page.evaluate(async () => {
    const canvas = document.getElementById("meshwright");
    const gl = canvas.getContext("webgl2");
    if (gl) gl.getExtension("WEBGL_lose_context").loseContext();
    else window.devices.at(-1).destroy();
  });
}

/** Keeps the WebGPU devices that pages get in `window.devices`. */
function keepDevices(editor) {
  return editor.context.addInitScript(() => {
    window.devices = [];
    const request = window.GPUAdapter?.prototype.requestDevice;
    if (!request) return;
    GPUAdapter.prototype.requestDevice = async function (...args) {
      const device = await request.apply(this, args);
      window.devices.push(device);
      return device;
    };
  });
}

/** Waits until a message says this. */
function said(editor, pattern) {
  return editor.until(`a message like ${pattern}`, async () => (
    (await editor.state()).messages.some(({ text }) => pattern.test(text))));
}

/** Waits until the page draws on another canvas than this one, and the picture is complete. */
async function redrawn(editor, canvas) {
  await editor.until("there is another canvas", () => editor.page.evaluate(
    (canvas) => document.getElementById("meshwright") !== canvas, canvas));
  await said(editor, /graphics device was lost/);
  await editor.frames(10);
}

const canvasOf = (editor) => editor.page.evaluateHandle(() => document.getElementById("meshwright"));

/** The picture of the viewport's middle, which has the model. */
async function middle(editor) {
  const [x, y, width, height] = (await editor.state()).view.rect;
  const picture = await editor.screenshot();
  return picture.at(x + width / 2, y + height / 2);
}

editorTest("a lost device is replaced, and everything is drawn again", { sizes }, async (editor) => {
  await keepDevices(editor);
  await editor.page.reload();
  const { renderer } = await editor.ready();
  assert.equal(renderer, editor.renderer);
  await editor.select("face", [1]);
  await editor.run({ op: "extrude-faces", distance: 0.5 });
  await editor.select("vertex", []);
  await editor.page.mouse.move(1, 1);
  await editor.frames(5);
  const before = await editor.state();
  const drawn = await middle(editor);
  editor.expectErrors(LOST);
  // Twice: the second device is watched too.
  for (const name of ["first", "second"]) {
    const canvas = await canvasOf(editor);
    await lose(editor);
    await redrawn(editor, canvas);
    const { document, history, selection, view } = await editor.state();
    assert.deepEqual({ document, history, selection }, {
      document: before.document, history: before.history, selection: before.selection,
    });
    assert.equal(view.renderer, editor.renderer);
    assert.deepEqual(await middle(editor), drawn, `after the ${name} loss`);
    await editor.screenshot(`${name} loss`);
  }
  // The page goes on: keys, edits, undo, and the accessibility tree in the document.
  await editor.undo();
  assert.equal((await editor.state()).document.faces, 6);
  await editor.press("Control+k");
  await editor.page.keyboard.type("subdivide catmull");
  await editor.frames(3);
  await editor.press("Enter");
  await editor.until("the palette's command is carried out", async () => (await editor.state()).document.faces === 24);
  await editor.byRole("button", "Mesh");
  await editor.find(/^Separate/, "button");
});

editorTest("a device that is lost while a job runs takes nothing away", { sizes }, async (editor) => {
  await keepDevices(editor);
  await editor.page.reload();
  await editor.ready();
  editor.expectErrors(LOST);
  const canvas = await canvasOf(editor);
  const job = editor.run({ op: "new", shape: "torus", segments: 400, tube_segments: 200 });
  await lose(editor);
  await job;
  await redrawn(editor, canvas);
  const { document } = await editor.state();
  assert.equal(document.faces, 80_000);
  // Large meshes are uploaded in parts.
  await editor.frames(30);
  await editor.run({ op: "set-face-color", faces: [0], color: "#ff0000" });
});

/** Adds a test of a WebGPU that works by half, faked by a script that runs before the page's. */
function halfTest(name, fake, check = async () => {}) {
  browserTest("webgpu", `${name} falls back to WebGL2`, {}, async () => {
    const editor = await openPage({ renderer: "webgpu", size: SMALL, label: name });
    try {
      editor.expectErrors(/./);
      await editor.ready();
      await editor.context.addInitScript(fake);
      await editor.page.reload();
      const { renderer } = await editor.ready();
      assert.equal(renderer, "webgl2");
      await editor.select("face", [1]);
      await editor.run({ op: "extrude-faces", distance: 0.5 });
      assert.equal((await editor.state()).document.faces, 10);
      await editor.screenshot("drawn");
      await check(editor);
    } finally {
      await editor.close();
    }
  });
}

halfTest("an adapter without a device", () => {
  GPUAdapter.prototype.requestDevice = () => Promise.reject(new DOMException("no device today", "OperationError"));
});

halfTest("a browser without an adapter", () => {
  GPU.prototype.requestAdapter = () => Promise.resolve(null);
});

/** Lets limits of many seconds pass at once. */
const HURRY = `{
  const real = window.setTimeout;
  window.setTimeout = (body, delay, ...rest) => real(body, delay === 20_000 ? 1000 : delay, ...rest);
}`;

halfTest("an adapter that never comes", `${HURRY}
  GPU.prototype.requestAdapter = () => new Promise(() => {});`);

halfTest("a device that never comes", `${HURRY}
  GPUAdapter.prototype.requestDevice = () => new Promise(() => {});`);

halfTest("a device that never draws", `${HURRY}
  GPUQueue.prototype.onSubmittedWorkDone = () => new Promise(() => {});`, async (editor) => {
  await said(editor, /WebGPU doesn't work here/);
  // A reload doesn't wait again.
  await editor.page.reload();
  assert.equal((await editor.ready()).renderer, "webgl2");
});

halfTest("a device that refuses its first pipelines", () => {
  const create = GPUDevice.prototype.createRenderPipeline;
  GPUDevice.prototype.createRenderPipeline = function (descriptor) {
    return create.call(this, { ...descriptor, vertex: { ...descriptor.vertex, entryPoint: "missing" } });
  };
}, (editor) => said(editor, /WebGPU doesn't work here/));

editorTest("the address chooses the renderer", { renderers: ["webgpu"], sizes, query: "?renderer=webgl2" }, async (editor) => {
  assert.equal((await editor.ready()).renderer, "webgl2");
});

editorTest("a renderer that the address asks for and the browser lacks is said", { renderers: ["webgl2"], sizes }, async (editor) => {
  editor.expectErrors(/./);
  await editor.context.addInitScript(() => {
    if (window.GPU) GPU.prototype.requestAdapter = () => Promise.resolve(null);
  });
  await editor.page.goto(`${editor.url}?renderer=webgpu`);
  await assert.rejects(editor.ready(), /cannot draw with WebGPU/);
  const notice = await editor.page.locator("#notice").innerText();
  assert.match(notice, /renderer=webgpu/);
  assert.match(notice, /Remove that from the address/);
  await editor.screenshot("notice");
  await editor.page.goto(editor.url);
  assert.equal((await editor.ready()).renderer, "webgl2");
});
