// Keeps the site in the browser, so that it works offline after the first visit. Each build has a worker of its own, which
// takes over when no tab shows an older build, or when the user asks for it (offline.js).

/** The files of this build, each with the hash of its content; filled in by the build, as is the hash of the list. */
const FILES = [];
const VERSION = "";

const SCOPE = self.registration.scope;
const CACHE_OF_ANY_BUILD = `meshwright of ${SCOPE} `;
const CACHE = CACHE_OF_ANY_BUILD + VERSION;
/** Files that another program shared, until the page takes them (files.js). */
const SHARED_CACHE = `meshwright shared with ${SCOPE}`;

/** Some hosts redirect the name of the page itself. */
const PAGE = "index.html";
const address = (file) => new URL(file === PAGE ? "./" : file, SCOPE).href;

const names = new Set(FILES.map(([file]) => file));

/** Such names stand for the same content in every build. */
const isNamedByContent = (file) => /-[0-9a-f]{16}[._]/.test(file);

self.addEventListener("install", (event) => event.waitUntil(keepAll()));

async function keepAll() {
  const cache = await caches.open(CACHE);
  for (const [file, integrity] of FILES) {
    const url = address(file);
    // What an earlier attempt has fetched.
    if (await cache.match(url)) continue;
    const known = isNamedByContent(file) ? await caches.match(url) : undefined;
    // A host that is being updated may have files of two builds: then this fails, and is tried again at the next visit.
    const response = known ?? await fetch(url, { integrity, cache: "no-cache" });
    if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
    await cache.put(url, response);
  }
}

self.addEventListener("activate", (event) => event.waitUntil(Promise.all([self.clients.claim(), tidy()])));

/** Forgets what older builds kept, once no other tab may need it. */
async function tidy() {
  const { waiting, installing } = self.registration;
  if (waiting || installing || (await self.clients.matchAll({ type: "window" })).length > 1) return;
  const old = (await caches.keys()).filter((name) => name.startsWith(CACHE_OF_ANY_BUILD) && name !== CACHE);
  await Promise.all(old.map((name) => caches.delete(name)));
}

self.addEventListener("message", ({ data }) => {
  if (data === "take over") self.skipWaiting();
  if (data === "tidy") tidy();
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  const [url] = request.url.split(/[?#]/);
  if (!url.startsWith(SCOPE)) return;
  const file = url.slice(SCOPE.length) || PAGE;
  if (request.method === "POST" && file === "share") event.respondWith(takeShared(request));
  else if (request.method === "GET" && (names.has(file) || isNamedByContent(file))) event.respondWith(kept(file, request));
});

async function kept(file, request) {
  const url = address(file);
  const cache = await caches.open(CACHE);
  // A tab of an older build starts workers of that build.
  return await cache.match(url) ?? await caches.match(url) ?? fetch(request);
}

/** Keeps shared files for the page, and shows it. */
async function takeShared(request) {
  try {
    const files = (await request.formData()).getAll("files").filter((file) => file instanceof File);
    const cache = await caches.open(SHARED_CACHE);
    for (const [at, file] of files.entries()) {
      const url = new URL(`shared/${at}/${encodeURIComponent(file.name)}`, SCOPE);
      await cache.put(url, new Response(file));
    }
  } catch {
    // Too little room, or a form that is none: the page says that nothing came.
  }
  return Response.redirect(`${SCOPE}?shared`, 303);
}
