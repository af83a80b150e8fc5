// The editor in a browser tab: actions of a user, and what window.meshwright offers.

import assert from "node:assert/strict";
import { mkdir, readFile } from "node:fs/promises";
import { basename, join } from "node:path";

import { browserWith } from "./browsers.mjs";
import { shots } from "./packages.mjs";
import { Picture } from "./picture.mjs";

const START_LIMIT_MS = 120_000;
const WAIT_LIMIT_MS = 30_000;
/** More than the longest time between the clicks of a double-click. */
const DOUBLE_CLICK_MS = 600;

export class Editor {
  #expected = [];

  /**
   * Opens the page at `url` in a fresh profile, with the settings of an earlier visit. Without a service worker, which would
   * keep a copy of the site in each profile, and answer requests before tests can.
   */
  static async open(url, {
    renderer, size, label = "", welcome = false, settings = {}, colorScheme, waitUntil, serviceWorkers = "block",
  }) {
    const browser = await browserWith(renderer);
    const context = await browser.newContext({
      viewport: { width: size.width, height: size.height },
      hasTouch: size.touch ?? false,
      acceptDownloads: true,
      colorScheme,
      serviceWorkers,
    });
    // Most tests are about what comes after the welcome view.
    const kept = Object.entries({ ...(welcome ? {} : { welcome: "off" }), ...settings });
    await context.addInitScript((kept) => {
      for (const [name, value] of kept) localStorage.setItem(`meshwright.${name}`, value);
      // Tests can't choose files in this dialog; without it, the page uses the one in which they can.
      delete window.showOpenFilePicker;
    }, kept);
    const editor = new Editor();
    const page = await context.newPage();
    page.setDefaultTimeout(WAIT_LIMIT_MS);
    Object.assign(editor, { url, renderer, size, label, context, page, errors: [], log: [] });
    const note = (type, text) => {
      editor.log.push(`${type}: ${text}`);
      if (type === "error") editor.errors.push(text);
    };
    page.on("console", (message) => note(message.type(), message.text()));
    page.on("pageerror", (error) => note("error", String(error)));
    page.on("crash", () => note("error", "The tab has crashed."));
    await page.goto(url, { waitUntil });
    return editor;
  }

  /** Resolves with {version, renderer} once the editor runs; rejects with the reason if it cannot start. */
  async ready() {
    const info = await this.page.evaluate(
      (limit) => Promise.race([
        window.meshwright.ready,
        new Promise((_, reject) => setTimeout(() => reject(new Error(`not ready after ${limit} ms`)), limit)),
      ]),
      START_LIMIT_MS,
    );
    await this.frames();
    return info;
  }

  // What window.meshwright offers.

  state() { return this.page.evaluate(() => window.meshwright.state()); }
  element(kind, id) { return this.page.evaluate(([kind, id]) => window.meshwright.element(kind, id), [kind, id]); }
  run(command) { return this.page.evaluate((command) => window.meshwright.run(command), command); }
  select(kind, ids) { return this.page.evaluate(([kind, ids]) => window.meshwright.select(kind, ids), [kind, ids]); }
  undo() { return this.page.evaluate(() => window.meshwright.undo()); }
  redo() { return this.page.evaluate(() => window.meshwright.redo()); }
  cancel() { return this.page.evaluate(() => window.meshwright.cancel()); }
  project(point) { return this.page.evaluate((point) => window.meshwright.project(point), point); }
  ui() { return this.page.evaluate(() => window.meshwright.ui()); }

  /** Opens a file with this content: text or bytes. */
  open(name, content) {
    return this.page.evaluate(
      ([name, base64]) => {
        const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
        return window.meshwright.open(name, bytes);
      },
      [name, Buffer.from(content).toString("base64")],
    );
  }

  /** The document in the format of this code, as a Buffer. */
  async export(format) {
    const base64 = await this.page.evaluate(async (format) => {
      const bytes = await window.meshwright.export(format);
      const url = await new Promise((resolve, reject) => {
        const reader = new FileReader();
        reader.onload = () => resolve(reader.result);
        reader.onerror = () => reject(reader.error);
        reader.readAsDataURL(new Blob([bytes]));
      });
      return url.slice(url.indexOf(",") + 1);
    }, format);
    return Buffer.from(base64, "base64");
  }

  // Waiting.

  /** Lets the page draw this many frames. */
  frames(count = 3) {
    return this.page.evaluate(async (count) => {
      for (let frame = 0; frame < count; frame += 1) await new Promise(requestAnimationFrame);
    }, count);
  }

  /** Calls `attempt` once a frame until it returns a truthy value, and returns that. */
  async until(what, attempt, limit = WAIT_LIMIT_MS) {
    const end = Date.now() + limit;
    for (;;) {
      const value = await attempt();
      if (value) return value;
      assert.ok(Date.now() < end, `${what}: not within ${limit} ms`);
      await this.frames(1);
    }
  }

  /** Waits until no job runs. */
  async idle(limit = WAIT_LIMIT_MS) {
    await this.until("no job runs", async () => (await this.state()).jobs.length === 0, limit);
    await this.frames();
  }

  // Actions of a user.

  /** The control with this accessible name (a string or a regular expression) and, if given, role. */
  find(name, role) {
    const matches = (text) => (name instanceof RegExp ? name.test(text ?? "") : text === name);
    const wanted = (control) => matches(control.name) && (!role || control.role === role);
    return this.until(`a control named ${name}`, async () => (await this.ui()).find(wanted));
  }

  /** The middle of a control found by name. */
  async middle(name, role) {
    // What a script just changed may still move the control.
    let rect;
    await this.until(`${name} stays in place`, async () => {
      const before = rect?.join();
      rect = (await this.find(name, role)).rect;
      return rect.join() === before;
    });
    const [x, y, width, height] = rect;
    return [x + width / 2, y + height / 2];
  }

  /** Clicks the middle of a control found by name. */
  async click(name, role) {
    await this.clickAt(await this.middle(name, role));
  }

  /** Clicks a control that makes the page load again, and waits until the editor is ready. */
  async clickToReload(name) {
    const at = await this.middle(name);
    await this.page.mouse.move(...at);
    await this.frames(2);
    const loaded = this.page.waitForEvent("load");
    await this.page.mouse.click(...at);
    await loaded;
    await this.ready();
  }

  /** Clicks a control that is found by its role and name as a screen reader knows them. */
  async byRole(role, name) {
    const control = this.page.getByRole(role, { name, exact: typeof name === "string" });
    await control.waitFor();
    const { x, y, width, height } = await control.boundingBox();
    await this.clickAt([x + width / 2, y + height / 2]);
  }

  /** Clicks at a point of the page, or taps on a touch screen. */
  async clickAt([x, y]) {
    if (this.size.touch) {
      await this.page.touchscreen.tap(x, y);
    } else {
      await this.page.mouse.move(x, y);
      // egui finds the hovered widget in the frame before.
      await this.frames(2);
      // A second click at the same place right after the first would make a double-click.
      const [lastX, lastY, lastTime] = this.lastClick ?? [0, 0, 0];
      const wait = lastTime + DOUBLE_CLICK_MS - Date.now();
      if (Math.hypot(x - lastX, y - lastY) < 8 && wait > 0) await new Promise((resolve) => setTimeout(resolve, wait));
      await this.page.mouse.click(x, y);
      this.lastClick = [x, y, Date.now()];
    }
    await this.frames();
  }

  async press(key) {
    await this.page.keyboard.press(key);
    await this.frames();
  }

  /** Runs a command of the palette. */
  async choose(name) {
    await this.press("Control+k");
    await this.frames(3);
    await this.page.keyboard.type(name);
    await this.frames(3);
    await this.press("Enter");
    await this.frames(4);
  }

  /** Drags from one point of the page to another. */
  async drag([fromX, fromY], [toX, toY], { steps = 8, button = "left" } = {}) {
    const { mouse } = this.page;
    await mouse.move(fromX, fromY);
    await this.frames(2);
    await mouse.down({ button });
    for (let step = 1; step <= steps; step += 1) {
      await mouse.move(fromX + ((toX - fromX) * step) / steps, fromY + ((toY - fromY) * step) / steps);
      await this.frames(1);
    }
    await mouse.up({ button });
    await this.frames();
  }

  /** Drops files on the page, given as paths or {name, content}. */
  async drop(...files) {
    const contents = await Promise.all(files.map(async (file) => {
      const { name, content } = typeof file === "string"
        ? { name: basename(file), content: await readFile(file) }
        : file;
      return { name, base64: Buffer.from(content).toString("base64") };
    }));
    await this.page.evaluate((contents) => {
      const dataTransfer = new DataTransfer();
      for (const { name, base64 } of contents) {
        const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
        dataTransfer.items.add(new File([bytes], name));
      }
      const canvas = document.getElementById("meshwright");
      const { left, top, width, height } = canvas.getBoundingClientRect();
      const place = { clientX: left + width / 2, clientY: top + height / 2 };
      for (const type of ["dragenter", "dragover", "drop"]) {
        canvas.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true, ...place }));
      }
    }, contents);
    await this.frames();
  }

  // Pictures.

  /** A screenshot; saved to a file when it has a name. */
  async screenshot(name) {
    const path = name && join(shots, `${fileName(`${this.label} ${name}`)}.png`);
    if (path) await mkdir(shots, { recursive: true });
    return new Picture(await this.page.screenshot({ path }));
  }

  // Errors.

  /** Allows errors on the console that match, from here on. */
  expectErrors(pattern) {
    this.#expected.push(pattern);
  }

  /** Fails when the console has errors that are not allowed. */
  assertNoErrors() {
    const unexpected = this.errors.filter((text) => !this.#expected.some((pattern) => pattern.test(text)));
    assert.deepEqual(unexpected, [], "errors on the console");
  }

  close() {
    return this.context.close();
  }
}

function fileName(text) {
  return text.trim().replaceAll(/[^\w.-]+/g, "-").toLowerCase();
}
