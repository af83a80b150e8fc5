// The pixels of a screenshot.

import { PNG } from "./packages.mjs";

export class Picture {
  constructor(bytes) {
    const { width, height, data } = PNG.sync.read(bytes);
    Object.assign(this, { width, height, data, bytes });
  }

  /** The colour [r, g, b] at a pixel. */
  at(x, y) {
    const start = 4 * (Math.round(y) * this.width + Math.round(x));
    return [...this.data.subarray(start, start + 3)];
  }

  /** The number of pixels in a rectangle [x, y, w, h] for which `test([r, g, b])` is true. */
  count(test, rect = [0, 0, this.width, this.height]) {
    let count = 0;
    for (const [x, y] of this.points(rect)) count += test(this.at(x, y)) ? 1 : 0;
    return count;
  }

  /** The number of different colours in a rectangle. */
  colors(rect = [0, 0, this.width, this.height]) {
    const colors = new Set();
    for (const [x, y] of this.points(rect)) colors.add(this.at(x, y).join());
    return colors.size;
  }

  /** The number of pixels in a rectangle that differ from another picture by more than `tolerance` in a channel. */
  difference(other, rect = [0, 0, this.width, this.height], tolerance = 8) {
    let count = 0;
    for (const [x, y] of this.points(rect)) {
      const theirs = other.at(x, y);
      if (this.at(x, y).some((value, channel) => Math.abs(value - theirs[channel]) > tolerance)) count += 1;
    }
    return count;
  }

  * points([left, top, width, height]) {
    const right = Math.min(Math.round(left + width), this.width);
    const bottom = Math.min(Math.round(top + height), this.height);
    for (let y = Math.max(Math.round(top), 0); y < bottom; y += 1) {
      for (let x = Math.max(Math.round(left), 0); x < right; x += 1) yield [x, y];
    }
  }
}
