// Registers the service worker, which keeps the site for offline use, and tells the editor of new versions.
(() => {
  const script = document.querySelector("meta[name=meshwright-offline]")?.content;
  const { serviceWorker } = navigator;
  // Embedded pages leave it to the pages that embed them.
  const isUsed = script && serviceWorker && !new URLSearchParams(location.search).has("embed");

  const HOUR_MS = 3_600_000;
  let registration;
  let isReady = false;
  let onUpdate = () => {};

  const announce = () => {
    // Without a controller, what was installed is what this page shows.
    if (!registration?.waiting || !serviceWorker.controller) return;
    isReady = true;
    onUpdate();
  };

  // Called by the editor; see web/src/platform/browser/offline.rs.
  Object.assign(window.meshwrightPage, {
    /** Calls `callback` once there is a newer version. */
    onUpdate(callback) {
      onUpdate = callback;
      if (isReady) callback();
    },
    /** Reloads the page with the newer version. */
    update() {
      // Another tab may have brought the new version into use already.
      if (!registration?.waiting) return location.reload();
      serviceWorker.addEventListener("controllerchange", () => location.reload(), { once: true });
      registration.waiting.postMessage("take over");
    },
  });

  const register = async () => {
    registration = await serviceWorker.register(script);
    registration.active?.postMessage("tidy");
    announce();
    registration.addEventListener("updatefound", () => {
      registration.installing?.addEventListener("statechange", announce);
    });
    let looked = Date.now();
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState !== "visible" || Date.now() - looked < HOUR_MS) return;
      looked = Date.now();
      registration.update().catch(() => {});
    });
  };
  // After the start, with which it would compete. Browsers refuse service workers in private windows and without https: the
  // page then needs the network.
  if (isUsed) window.meshwright.ready.then(register).catch(() => {});
})();
