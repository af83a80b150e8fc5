// Embeds Meshwright in a page. `docs/embedding.md` describes it; `example.html` beside this file uses it.
//
//   import { embed } from "https://example.org/meshwright/embed/meshwright-embed.js";
//
//   const editor = embed(document.getElementById("editor"), { panels: ["tools"] });
//   await editor.ready;
//   await editor.run({ op: "new", shape: "torus" });
//   editor.on("change", async () => console.log(await editor.state()));

const VERSION = 1;

/** The calls of `window.meshwright` that an embedding page can make; all return promises. */
const CALLS = [
  "open", "openFiles", "run", "export", "exportFiles", "state", "element", "select", "undo", "redo", "cancel", "project",
];

/**
 * Puts the editor into an element, whose size it takes.
 *
 * @param {HTMLElement} container
 * @param {object} [options]
 * @param {string} [options.page] The editor's address; by default the site that this module comes from.
 * @param {string[]} [options.panels] The parts to show around the viewport: "menu", "tools", "lists", "inspector", "status".
 * @param {string} [options.model] The address of a file to open.
 * @param {string} [options.link] A link made by File > Share, to open its document.
 * @param {string} [options.title] What screen readers call the frame.
 */
export function embed(container, { page, panels = [], model, link, title = "Meshwright" } = {}) {
  const address = new URL(page ?? "../", import.meta.url);
  address.searchParams.set("embed", "");
  address.searchParams.set("origins", location.origin);
  if (panels.length > 0) address.searchParams.set("panels", panels.join(","));
  if (model) address.searchParams.set("model", new URL(model, location.href).href);
  if (link) address.hash = new URL(link, location.href).hash;

  const frame = document.createElement("iframe");
  frame.title = title;
  frame.allow = "clipboard-write; fullscreen";
  frame.style.cssText = "display: block; width: 100%; height: 100%; border: 0;";

  const waiting = new Map();
  const listeners = new Map();
  let next = 0;
  let resolveReady;
  const ready = new Promise((resolve) => { resolveReady = resolve; });

  const receive = (message) => {
    if (message.source !== frame.contentWindow || message.origin !== address.origin) return;
    const { data } = message;
    if (data?.meshwright !== VERSION) return;
    if (data.event === "ready") {
      resolveReady(data.detail);
    } else if (data.event !== undefined) {
      for (const listener of [...(listeners.get(data.event) ?? [])]) listener(data.detail);
    } else if (waiting.has(data.id)) {
      const { resolve, reject } = waiting.get(data.id);
      waiting.delete(data.id);
      if ("error" in data) reject(new Error(data.error));
      else resolve(data.result);
    }
  };
  addEventListener("message", receive);

  const call = async (name, args) => {
    await ready;
    const id = next++;
    return new Promise((resolve, reject) => {
      waiting.set(id, { resolve, reject });
      frame.contentWindow.postMessage({ meshwright: VERSION, id, call: name, args }, address.origin);
    });
  };

  frame.src = address.href;
  container.append(frame);

  return {
    /** Resolves with the version and the renderer when the editor is ready. */
    ready,
    /** The frame, for styles. */
    frame,
    ...Object.fromEntries(CALLS.map((name) => [name, (...args) => call(name, args)])),
    /** Calls back at each event of a name: "change", "selection" or "job". Returns a function that ends it. */
    on(name, callback) {
      if (!listeners.has(name)) {
        listeners.set(name, new Set());
        call("on", [name]).catch((error) => reportError(error));
      }
      listeners.get(name).add(callback);
      return () => listeners.get(name).delete(callback);
    },
    /** Removes the editor from the page. */
    remove() {
      removeEventListener("message", receive);
      frame.remove();
      for (const { reject } of waiting.values()) reject(new Error("The editor was removed."));
      waiting.clear();
    },
  };
}
