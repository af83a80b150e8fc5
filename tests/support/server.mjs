// A static file server that serves a site under a sub-path, as many hosts do.

import { createReadStream } from "node:fs";
import { readFile, stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, resolve, sep } from "node:path";
import { pipeline } from "node:stream";

const TYPES = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".mjs": "text/javascript; charset=utf-8",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

/** The file at a request's path, or null if that is outside the folder. */
function fileFor(root, base, url) {
  let path;
  try {
    path = decodeURIComponent(new URL(url, "http://localhost").pathname);
  } catch {
    return null;
  }
  if (!path.startsWith(base)) return null;
  const file = resolve(join(root, path.slice(base.length) || "index.html"));
  return file.startsWith(root + sep) ? file : null;
}

/**
 * Serves `folder` under `base` ("/" or "/some/path/") on a free port of 127.0.0.1. Other paths are not found.
 * Options: more `headers`; `status(file)`, 200 by default; `body(file, bytes, response)`, which may send a file itself, and
 * then returns true. Returns its URL and a function that stops it.
 */
export async function serve(folder, base = "/", { headers = {}, status = () => 200, body } = {}) {
  const root = resolve(folder);
  const server = createServer(async (request, response) => {
    const file = fileFor(root, base, request.url);
    const found = file && (await stat(file).catch(() => null));
    if (!found?.isFile()) {
      response.writeHead(404, { "content-type": "text/plain" }).end("not found");
      return;
    }
    response.writeHead(status(file), {
      "content-type": TYPES[extname(file)] ?? "application/octet-stream",
      "cache-control": "no-store",
      ...(body ? {} : { "content-length": found.size }),
      ...headers,
    });
    if (body && await body(file, await readFile(file), response)) return;
    // A page may close while it loads: no error.
    pipeline(createReadStream(file), response, () => {});
  });
  await new Promise((done, fail) => server.once("error", fail).listen(0, "127.0.0.1", done));
  return {
    url: `http://127.0.0.1:${server.address().port}${base}`,
    stop: () => new Promise((done) => {
      server.close(done);
      server.closeAllConnections();
    }),
  };
}
