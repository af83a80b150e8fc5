// Pictures as PNG files with few colours, much smaller than those that browsers make.

import { deflateSync } from "node:zlib";

/** Few, because anti-aliased text and gradients hide what is missing, and rows of equal pixels take little room. */
const COLORS = 64;
const SIGNATURE = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
const INDEXED = 3;

/** A picture ({width, height, data} with four bytes per pixel, opaque) as a PNG file with a palette. */
export function palettePng({ width, height, data }) {
  const counts = new Map();
  const colorAt = (pixel) => (data[4 * pixel] << 16) | (data[4 * pixel + 1] << 8) | data[4 * pixel + 2];
  for (let pixel = 0; pixel < width * height; pixel += 1) {
    const color = colorAt(pixel);
    counts.set(color, (counts.get(color) ?? 0) + 1);
  }
  const palette = choosePalette(counts);
  const index = new Map([...counts.keys()].map((color) => [color, nearest(palette, color)]));
  // Each row begins with the number of its filter: none.
  const rows = Buffer.alloc((width + 1) * height);
  for (let pixel = 0; pixel < width * height; pixel += 1) {
    rows[pixel + Math.floor(pixel / width) + 1] = index.get(colorAt(pixel));
  }
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, INDEXED, 0, 0, 0], 8);
  return Buffer.concat([
    SIGNATURE,
    chunk("IHDR", header),
    chunk("PLTE", Buffer.from(palette.flatMap(channels))),
    chunk("IDAT", deflateSync(rows, { level: 9 })),
    chunk("IEND", Buffer.alloc(0)),
  ]);
}

const channels = (color) => [color >> 16, (color >> 8) & 255, color & 255];

/** Median cut: the box of colours with the largest error is cut in two until there are enough boxes. */
function choosePalette(counts) {
  const box = (entries) => {
    const total = entries.reduce((sum, [, count]) => sum + count, 0);
    const mean = [0, 1, 2].map((at) => entries.reduce((sum, [color, count]) => sum + channels(color)[at] * count, 0) / total);
    const errors = mean.map((middle, at) => entries.reduce(
      (sum, [color, count]) => sum + count * (channels(color)[at] - middle) ** 2, 0,
    ));
    const widest = errors.indexOf(Math.max(...errors));
    return { entries, mean, widest, error: errors[widest] };
  };
  const boxes = [box([...counts])];
  while (boxes.length < COLORS) {
    const at = boxes.reduce((best, { error }, at) => (error > boxes[best].error ? at : best), 0);
    const { entries, mean, widest, error } = boxes[at];
    if (error === 0) break;
    const [low, high] = [[], []];
    for (const entry of entries) (channels(entry[0])[widest] < mean[widest] ? low : high).push(entry);
    boxes.splice(at, 1, box(low), box(high));
  }
  return boxes.map(({ mean }) => mean.reduce((color, value) => (color << 8) | Math.round(value), 0));
}

function nearest(palette, color) {
  const [red, green, blue] = channels(color);
  let best = 0;
  let least = Infinity;
  palette.forEach((other, at) => {
    const [r, g, b] = channels(other);
    const distance = (r - red) ** 2 + (g - green) ** 2 + (b - blue) ** 2;
    if (distance < least) [best, least] = [at, distance];
  });
  return best;
}

function chunk(name, content) {
  const body = Buffer.concat([Buffer.from(name, "latin1"), content]);
  const ends = Buffer.alloc(8);
  ends.writeUInt32BE(content.length, 0);
  ends.writeUInt32BE(crc32(body), 4);
  return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
}

/** The checksum of PNG; Node has one from version 22 on. */
function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit += 1) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return (crc ^ 0xffffffff) >>> 0;
}
