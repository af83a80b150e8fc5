// A screenshot's pixels.

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

  /** How many pixels of a rectangle [x, y, w, h] satisfy `test([r, g, b])`. */
  count(test, rect = [0, 0, this.width, this.height]) {
    let count = 0;
    for (const [x, y] of this.points(rect)) count += test(this.at(x, y)) ? 1 : 0;
    return count;
  }

  /** How many different colours a rectangle has. */
  colors(rect = [0, 0, this.width, this.height]) {
    const colors = new Set();
    for (const [x, y] of this.points(rect)) colors.add(this.at(x, y).join());
    return colors.size;
  }

  /** How many pixels of a rectangle differ from another picture's by more than `tolerance` in a channel. */
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
