// After a crash of the program: the document as a project file, which a worker of its own makes of what the browser keeps.
(() => {
  const NAME = "meshwright-rescue";
  const LIMIT_MS = 60_000;
  /** The setting with the document that a tab shows; see web/src/keeping/mod.rs. */
  const DOCUMENT = "meshwright.document";

  /** Calls `body` with the storage of the tab and that of the browser, as far as the browser allows them. */
  const withStorages = (body) => ["sessionStorage", "localStorage"].map((name) => {
    try {
      return body(window[name]);
    } catch {
      return null;
    }
  });
  const shown = () => withStorages((storage) => storage.getItem(DOCUMENT)).find(Boolean);

  /** Asks a worker for the file. Without the log, the document is as it was at its last checkpoint. */
  const ask = (id, repeatsLog) => new Promise((resolve, reject) => {
    const script = document.querySelector("meta[name=meshwright-worker]").content;
    const store = new URLSearchParams(location.search).get("store") ?? "";
    const name = `${NAME} ${store} ${Math.random()}`;
    const worker = new Worker(new URL(script, document.baseURI), { type: "module", name });
    const timer = setTimeout(() => end(reject, new Error("it took too long")), LIMIT_MS);
    const end = (settle, value) => {
      clearTimeout(timer);
      worker.terminate();
      settle(value);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      end(reject, new Error(event.message || "the worker's program did not load"));
    };
    worker.onmessage = ({ data: [kind, ...rest] }) => {
      if (kind === "ready") worker.postMessage([id, repeatsLog]);
      if (kind === "file") end(resolve, { name: rest[0], bytes: rest[1] });
      if (kind === "failed") end(reject, new Error(rest[0]));
    };
  });

  const download = ({ name, bytes }) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([bytes]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), LIMIT_MS);
  };

  window.meshwrightRescue = {
    /** Whether the browser keeps a document that this tab shows. */
    hasDocument: () => Boolean(shown()),

    /** Downloads the document, and says how that went. */
    async save() {
      try {
        const file = await ask(shown(), true);
        download(file);
        return `Saved as ${file.name}.`;
      } catch {
        // The change that crashed the program may crash the worker too.
      }
      try {
        const file = await ask(shown(), false);
        download(file);
        return `Saved as ${file.name}, without the last changes: they can't be repeated.`;
      } catch (error) {
        return `The document could not be saved: ${error.message}`;
      }
    },

    /** Lets the next visit begin with a new document. This one stays in the list. */
    forget() {
      withStorages((storage) => storage.removeItem(DOCUMENT));
    },
  };
})();
