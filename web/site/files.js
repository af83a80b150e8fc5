// Files with the handles that the File System Access API gives out, by which a document is saved where it was opened; files
// that the system opens with the installed page, and files that other programs share with it.
(() => {
  /** For files that came together, their handles by name. The editor knows them by their number here, the source. */
  const sources = [];
  /** What the user answered, or will answer, when asked whether the page may write the files of a source. */
  const permissions = new Map();

  const noteSource = (handles) => {
    const files = handles.filter((handle) => handle?.kind === "file" && handle.createWritable);
    if (files.length === 0) return undefined;
    return sources.push(new Map(files.map((handle) => [handle.name, handle]))) - 1;
  };
  /** What is being written: one after the other, so that the newest contents are the last. */
  let writing = Promise.resolve();
  const writeNow = async (source, names, contents) => {
    const answers = await permissions.get(source) ?? [];
    if (answers.some((answer) => answer !== "granted")) throw new Error("the browser was not allowed to write it");
    for (const [at, name] of names.entries()) {
      // What was there stays until everything is written.
      const writable = await sources[source].get(name).createWritable();
      await writable.write(contents[at]);
      await writable.close();
    }
  };
  // The files that kept documents are saved to, by the documents' ids. Only IndexedDB can store handles.
  const MAX_REMEMBERED = 200;
  const finished = (request) => new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
  let database;
  const remembered = async (mode) => {
    if (!database) {
      const opening = indexedDB.open("meshwright-files", 1);
      opening.onupgradeneeded = () => opening.result.createObjectStore("files").createIndex("date", "date");
      database = finished(opening);
      database.catch(() => { database = undefined; });
    }
    return (await database).transaction("files", mode).objectStore("files");
  };
  const forgetOldest = async (files) => {
    const keys = await finished(files.index("date").getAllKeys());
    for (const key of keys.slice(0, -MAX_REMEMBERED)) files.delete(key);
  };
  // One change after the other. Where none can be made, as in some private windows, saving asks where after a reload.
  let remembering = Promise.resolve();
  const changeRemembered = (change) => {
    remembering = remembering.then(async () => change(await remembered("readwrite"))).catch(() => {});
  };

  /** The files of handles, with their source. The editor reads them. */
  const open = async (handles) => [noteSource(handles), await Promise.all(handles.map((handle) => handle.getFile()))];

  /** The handles of what was dropped last. They can only be asked for within the event. */
  let dropped = [];
  window.addEventListener("drop", ({ dataTransfer }) => {
    const items = [...(dataTransfer?.items ?? [])].filter(({ kind }) => kind === "file");
    dropped = items.map((item) => item.getAsFileSystemHandle?.());
  }, true);

  const SHARED_CACHE = `meshwright shared with ${new URL("./", location.href).href}`;
  const SHARED = "shared";

  // Called by the editor; see web/src/platform/browser/handles.rs.
  Object.assign(window.meshwrightPage, {
    /** Shows the browser's dialog, if it gives out handles. Resolves with nothing if the user picks nothing. */
    pickFiles() {
      if (!window.showOpenFilePicker) return undefined;
      const picking = window.showOpenFilePicker({ multiple: true });
      return picking.then(open, (error) => {
        if (error.name === "AbortError") return undefined;
        throw error;
      });
    },
    /** The source of the files that were dropped last. */
    async sourceOfDropped() {
      return noteSource(await Promise.all(dropped.map((handle) => handle?.catch(() => null))));
    },
    /** Calls `deliver` with the files that the system opens with the page. */
    onLaunched(deliver) {
      window.launchQueue?.setConsumer(({ files }) => {
        if (files?.length > 0) deliver(open(files));
      });
    },
    /** The files that another program shared with the page; see service-worker.js. */
    async takeShared() {
      const parameters = new URLSearchParams(location.search);
      if (!parameters.has(SHARED)) return undefined;
      parameters.delete(SHARED);
      const search = parameters.size > 0 ? `?${parameters}` : "";
      history.replaceState(null, "", location.pathname + search + location.hash);
      const cache = await caches.open(SHARED_CACHE);
      const files = [];
      for (const request of await cache.keys()) {
        const name = decodeURIComponent(request.url.split("/").at(-1));
        files.push(new File([await (await cache.match(request)).blob()], name));
      }
      await caches.delete(SHARED_CACHE);
      return [undefined, files];
    },
    /** Whether a source has a file of this name. */
    hasFile(source, name) {
      return sources[source]?.has(name) ?? false;
    },
    /** Asks the user whether the page may write the files of a source. Browsers allow it shortly after a key or a click. */
    askToWrite(source) {
      const asked = [...(sources[source]?.values() ?? [])].map((handle) => handle.requestPermission({ mode: "readwrite" }));
      permissions.set(source, Promise.all(asked));
      permissions.get(source).catch(() => {});
    },
    /** Remembers that a kept document is saved to a file of a source, and in which format. */
    rememberFile(document, source, name, format) {
      const handles = [...(sources[source]?.values() ?? [])];
      changeRemembered(async (files) => {
        await finished(files.put({ date: Date.now(), name, format, handles }, document));
        await forgetOldest(files);
      });
    },
    /** Forgets the file of a kept document. */
    forgetFile(document) {
      changeRemembered((files) => finished(files.delete(document)));
    },
    /** The file of a kept document: source, name and format; nothing if none is remembered. */
    async recallFile(document) {
      await remembering;
      const file = await finished((await remembered("readonly")).get(document));
      const source = file && noteSource(file.handles);
      return source === undefined ? undefined : [source, file.name, file.format];
    },
    /** Writes files of a source. */
    write(source, names, contents) {
      const written = writing.then(() => writeNow(source, names, contents));
      writing = written.catch(() => {});
      return written;
    },
  });
})();
