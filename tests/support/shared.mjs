// Files in ../shared, outside the repository, whose licences don't allow copies. They are required, unless
// MESHWRIGHT_NO_SHARED=1 leaves out the tests that read them; the run lists those at its end.

import { resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../../../shared/", import.meta.url));

/** The path of a file in ../shared. */
export const shared = (path) => resolve(root, path);

/** The options of a test that reads files in ../shared. */
export const readsShared = { skip: process.env.MESHWRIGHT_NO_SHARED === "1" ? "MESHWRIGHT_NO_SHARED is set" : false };
