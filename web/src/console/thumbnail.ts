// SPDX-License-Identifier: Apache-2.0
// A small picture of a sensor's view: every fourth pixel of its newest frame, about once a second; depth in grey where
// there is no colour. A press makes it large: every pixel, several times a second.
import { consoleTexts } from '../console_texts';
import { element } from '../panel/element';
import type { ViewFrame } from '../stream/protocol';

const texts = consoleTexts.thumbnail;
const farthest_mm = 6000;
const small = { every_px: 4, interval_ms: 900 };
const large = { every_px: 1, interval_ms: 180 };

export class Thumbnail {
  private readonly canvas = element('canvas', { class: 'thumbnail', width: '128', height: '106', role: 'img' });
  readonly root = element('button', { type: 'button', class: 'picture', title: texts.larger }, this.canvas);
  private readonly paint = this.canvas.getContext('2d')!;
  private shownAt_ms = -Infinity;
  private size = small;

  constructor(
    name: string,
    private readonly sized: (isLarge: boolean) => void,
  ) {
    this.canvas.setAttribute('aria-label', texts.seenBy(name));
    this.root.setAttribute('aria-pressed', 'false');
    this.root.addEventListener('click', () => this.setLarge(this.size === small));
  }

  private setLarge(isLarge: boolean): void {
    this.size = isLarge ? large : small;
    this.shownAt_ms = -Infinity;
    this.root.setAttribute('aria-pressed', String(isLarge));
    this.root.title = isLarge ? texts.smaller : texts.larger;
    this.sized(isLarge);
  }

  offer(frame: ViewFrame, now_ms: number): void {
    const { every_px, interval_ms } = this.size;
    if (now_ms - this.shownAt_ms < interval_ms) return;
    this.shownAt_ms = now_ms;
    const width = Math.floor(frame.width / every_px);
    const height = Math.floor(frame.height / every_px);
    const picture = this.paint.createImageData(width, height);
    const pixels = new Uint32Array(picture.data.buffer);
    const pixelAt = frame.rgba ? colorOf(frame.rgba) : greyOf(frame.depth_mm);
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) pixels[y * width + x] = pixelAt(y * every_px * frame.width + x * every_px);
    }
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
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
