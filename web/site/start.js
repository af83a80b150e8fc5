// The page until the editor runs, and when it can't: how it looks, loading the program, and the notices. A classic script in
// the head, so that it runs before anything is painted.
(() => {
  const root = document.documentElement;
  const parameters = new URLSearchParams(location.search);

  // No request leaves the page's origin, unless the user asked for an address.
  if (!parameters.getAll("model").some((address) => address.trim())) {
    const policy = document.createElement("meta");
    policy.httpEquiv = "Content-Security-Policy";
    policy.content = "connect-src 'self'";
    document.head.append(policy);
  }

  // The appearance that the last visit chose; see web/src/app/layout.rs and web/src/embedding.rs.
  const setting = (name) => {
    try {
      return localStorage.getItem(`meshwright.${name}`);
    } catch {
      // The browser allows the page no storage.
      return null;
    }
  };
  const theme = setting("theme");
  const isLight = theme === "light" || (theme !== "dark" && matchMedia("(prefers-color-scheme: light)").matches);
  root.dataset.theme = isLight ? "light" : "dark";
  const open = { menu: true, tools: true, lists: true, inspector: true, status: true };
  if (parameters.has("embed")) {
    const asked = (parameters.get("panels") ?? "").split(/[ ,]/);
    for (const part of Object.keys(open)) open[part] = asked.includes(part);
  }
  let layout;
  try {
    layout = JSON.parse(setting("layout"));
  } catch {
    // Not one that this version understands.
  }
  const panels = layout?.[String(layout.arrangement).toLowerCase()];
  if (panels) {
    open.lists &&= panels.left === true;
    open.inspector &&= panels.right === true;
  }
  root.dataset.parts = Object.keys(open).filter((part) => open[part]).join(" ");
  const [left, right] = layout?.widths ?? [];
  if (left > 0 && right > 0) {
    root.style.setProperty("--lists", `${left}px`);
    root.style.setProperty("--inspector", `${right}px`);
  }

  let resolveReady, rejectReady;
  const ready = new Promise((resolve, reject) => { resolveReady = resolve; rejectReady = reject; });
  ready.catch(() => {});
  window.meshwright = { ready };

  let state = "loading";
  /** Shows a notice. `buttons` are pairs of a label and what a click does, whose answer is shown. */
  const show = (title, paragraphs, details, buttons = []) => {
    const notice = document.getElementById("notice");
    const box = document.createElement("div");
    const add = (parent, tag, text) => {
      const element = document.createElement(tag);
      element.textContent = text;
      parent.append(element);
      return element;
    };
    add(box, "h2", title);
    for (const text of paragraphs) add(box, "p", text);
    const row = add(box, "p", "");
    const answer = add(box, "p", "");
    answer.setAttribute("role", "status");
    for (const [label, act] of buttons) {
      const button = add(row, "button", label);
      button.type = "button";
      button.addEventListener("click", async () => {
        button.disabled = true;
        answer.textContent = (await act()) ?? "";
        button.disabled = false;
      });
    }
    if (details) {
      const more = document.createElement("details");
      add(more, "summary", "Technical details");
      add(more, "pre", details);
      box.append(more);
    }
    notice.replaceChildren(box);
    notice.hidden = false;
    document.getElementById("frame").hidden = true;
  };
  /** The page's elements are there, and the scripts that wait for them have run. */
  const parsed = new Promise((resolve) => { document.addEventListener("DOMContentLoaded", resolve, { once: true }); });

  // Called by the editor; see web/src/page/notice.rs.
  window.meshwrightPage = {
    started(info) {
      if (state !== "loading") return;
      state = "started";
      document.getElementById("frame").hidden = true;
      resolveReady(JSON.parse(info));
    },
    noGraphics(reason) {
      if (state !== "loading") return;
      state = "failed";
      show("This browser cannot draw 3D graphics", [
        "Meshwright needs WebGPU or WebGL2, and neither is available here.",
        "Turn on hardware acceleration in the browser's settings, update the graphics driver, " +
          "or open this page in a current Chrome, Edge, Firefox or Safari.",
      ], reason);
      rejectReady(new Error("Neither WebGPU nor WebGL2 is available."));
    },
    stopped(title, text, details) {
      if (state === "failed") return;
      const starting = state === "loading";
      state = "failed";
      show(title, text.split("\n"), details, [["Reload", () => location.reload()]]);
      if (starting) rejectReady(new Error(`${title}. ${text}`));
    },
    crashed(message) {
      if (state === "failed") return;
      const starting = state === "loading";
      state = "failed";
      const rescue = window.meshwrightRescue;
      const buttons = [["Reload and go on", () => location.reload()]];
      const paragraphs = ["This is a bug in Meshwright, not something you did."];
      if (rescue?.hasDocument()) {
        paragraphs.push("The document is kept in this browser. Reload the page to go on with it, or save it as a file first.");
        buttons.push(["Save the document as a file", () => rescue.save()]);
        if (starting) {
          buttons.push(["Begin with a new document", () => {
            rescue.forget();
            location.reload();
          }]);
        }
      } else {
        paragraphs.push("Reload the page to go on.");
      }
      show("Meshwright has crashed", paragraphs, message, buttons);
      if (starting) rejectReady(new Error(message));
    },
  };

  const cannotLoad = (reason) => {
    if (state !== "loading") return;
    state = "failed";
    parsed.then(() => show("Meshwright could not be loaded", [
      "The page has loaded, but the editor's program did not load or did not start.",
      "Check the connection and reload; the browser must be one that runs WebAssembly.",
    ], reason));
    rejectReady(new Error(reason));
  };
  const failed = (error, message) => {
    // Panics are reported before they get here; a trap without a panic means a lack of memory.
    if (error instanceof WebAssembly.RuntimeError) {
      parsed.then(() => window.meshwrightPage.crashed(`The editor stopped, most likely for lack of memory: ${message}`));
      return;
    }
    cannotLoad(message);
  };
  /** Whether an error is the page's own, by an address or its stack: browser extensions run scripts here too. */
  const isOwn = (error, address) => {
    const origins = String(address || error?.stack).match(/[a-z-]+:\/\/[^/\s)]+/g) ?? [];
    // Chromium calls programs in memory wasm://wasm.
    const origin = origins.find((found) => !found.startsWith("wasm:"));
    return origin === location.origin || (origin === undefined && error instanceof WebAssembly.RuntimeError);
  };
  window.addEventListener("error", ({ error, filename, message, target }) => {
    const address = filename || target?.src || target?.href;
    if (isOwn(error, address)) failed(error, message || "A file could not be fetched.");
  }, true);
  window.addEventListener("unhandledrejection", ({ reason }) => {
    if (isOwn(reason)) failed(reason, String(reason));
  });

  // The program.
  const program = document.querySelector("meta[name=meshwright-program]");
  const address = (name) => new URL(name, document.baseURI).href;

  const MEGABYTE = 1e6;
  /** Shows how many bytes of the program have come. The size that a server states is that of the compressed program. */
  const showProgress = async (body) => {
    const all = Number(program.dataset.bytes);
    const [text, bar] = ["loading", "progress"].map((id) => document.getElementById(id));
    const megabytes = (bytes) => (bytes / MEGABYTE).toFixed(1);
    const reader = body.getReader();
    for (let done = 0; ;) {
      const part = await reader.read();
      if (part.done) break;
      done += part.value.length;
      text.textContent = `Loading the editor: ${megabytes(done)} of ${megabytes(all)} MB`;
      bar.max = all;
      bar.value = done;
    }
    text.textContent = "Starting the editor…";
    bar.removeAttribute("value");
  };

  const fetchProgram = async () => {
    const url = address(program.dataset.wasm);
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
    // Browsers keep the machine code of programs that they compile straight from the network or the cache. Reading along
    // would be in the way of that, and there is nothing to wait for where the service worker has the program.
    if (!navigator.serviceWorker?.controller) {
      const copy = response.clone().body;
      parsed.then(() => showProgress(copy)).catch(() => {});
    }
    return response;
  };
  const load = async () => {
    const [{ default: init }, response] = await Promise.all([import(address(program.content)), fetchProgram()]);
    // The editor looks for its canvas.
    await parsed;
    await init({ module_or_path: response });
  };
  load().catch((error) => failed(error, String(error)));
})();
