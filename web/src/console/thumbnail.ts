// SPDX-License-Identifier: Apache-2.0
// A small picture of a sensor's view: every fourth pixel of its newest frame, about once a second; depth in grey where
// there is no colour.
import { element } from '../panel/element';
import type { ViewFrame } from '../stream/protocol';

const every_px = 4;
const interval_ms = 900;
const farthest_mm = 6000;

export class Thumbnail {
  readonly root = element('canvas', { class: 'thumbnail', width: '128', height: '106' });
  private readonly paint = this.root.getContext('2d')!;
  private shownAt_ms = -Infinity;

  constructor(name: string) {
    this.root.setAttribute('role', 'img');
    this.root.setAttribute('aria-label', `What ${name} sees`);
  }

  offer(frame: ViewFrame, now_ms: number): void {
    if (now_ms - this.shownAt_ms < interval_ms) return;
    this.shownAt_ms = now_ms;
    const width = Math.floor(frame.width / every_px);
    const height = Math.floor(frame.height / every_px);
    const picture = this.paint.createImageData(width, height);
    const small = new Uint32Array(picture.data.buffer);
    const pixelAt = frame.rgba ? colorOf(frame.rgba) : greyOf(frame.depth_mm);
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) small[y * width + x] = pixelAt(y * every_px * frame.width + x * every_px);
    }
    if (this.root.width !== width || this.root.height !== height) Object.assign(this.root, { width, height });
    this.paint.putImageData(picture, 0, 0);
  }
}

function colorOf(rgba: Uint8Array<ArrayBuffer>): (pixel: number) => number {
  const pixels = new Uint32Array(rgba.buffer, rgba.byteOffset, rgba.length / 4);
  return (pixel) => (pixels[pixel]! | 0xff000000) >>> 0;
}

function greyOf(depth_mm: Uint16Array): (pixel: number) => number {
  return (pixel) => {
    const grey = depth_mm[pixel] === 0 ? 0 : Math.max(30, 255 - Math.round((225 * depth_mm[pixel]!) / farthest_mm));
    return (0xff000000 | (grey << 16) | (grey << 8) | grey) >>> 0;
  };
}
