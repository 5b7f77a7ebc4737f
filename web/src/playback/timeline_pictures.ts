// SPDX-License-Identifier: Apache-2.0
// Small pictures along the timeline, each of the middle of its share of the recording: what one sensor saw. They come one
// after the other, when nothing else is waited for, within limits of number and bytes. They repeat what the timeline says,
// so screen readers pass them over.
import { element } from '../panel/element';
import { framePayload, parseFrameHeader } from '../wire/frame_header';
import type { Part } from './part';
import { colorIn } from './payload_color';

const pictureWidth_px = 72;
const fewest = 4;
const most = 16;
const mostBytes = 6_000_000; // of all pictures; a key frame of a sensor has about 50 kB
const mostSensors = 4; // that are asked until one has a picture
const pause_ms = 30;

export interface PictureSource {
  keyFrame(sensor: string, position_s: number): Promise<Part>;
  readonly received_bytes: number;
}

export interface Painter {
  paint(vp9: Uint8Array, canvas: HTMLCanvasElement): Promise<boolean>;
  close(): void;
}

export interface PictureEvents {
  /** Names of sensors. */
  sensors(): readonly string[];
  /** Another moment is on its way, which goes first. */
  isBusy(): boolean;
  seek(position_s: number): void;
}

/** The moments of pictures on a line that is so wide. */
export function momentsOf(length_s: number, width_px: number): number[] {
  const count = Math.min(most, Math.max(fewest, Math.floor(width_px / pictureWidth_px)));
  return Array.from({ length: count }, (_, i) => ((i + 0.5) * length_s) / count);
}

/** The VP9 frame that the answer has, if any. Throws WireError. */
export function pictureIn({ records }: Part): Uint8Array | undefined {
  const [first] = records;
  if (!first) return undefined;
  const { message } = first;
  const header = parseFrameHeader(new DataView(message.buffer, message.byteOffset, message.byteLength));
  return header.key ? colorIn(framePayload(message, header)) : undefined;
}

export class TimelinePictures {
  readonly root = element('div', { class: 'pictures', 'aria-hidden': 'true', hidden: '' });
  private length_s = 0;
  private isBegun = false;

  constructor(
    private readonly source: PictureSource,
    private readonly painter: Painter,
    private readonly events: PictureEvents,
  ) {
    this.root.addEventListener('click', (event) => this.clicked(event));
  }

  /** Once; `width_px` is that of the line. Ends with all pictures there, or as many as there can be. */
  async load(length_s: number, width_px: number): Promise<void> {
    if (this.isBegun || length_s <= 0) return;
    this.isBegun = true;
    this.length_s = length_s;
    const slots = momentsOf(length_s, width_px).map((at_s) => ({ at_s, canvas: element('canvas') }));
    this.root.append(...slots.map(({ canvas }) => canvas));
    let sensors: readonly string[] = this.events.sensors();
    try {
      for (const { at_s, canvas } of slots) {
        if (this.source.received_bytes > mostBytes) break;
        const sensor = await this.paint(at_s, canvas, sensors);
        if (sensor === undefined) continue;
        sensors = [sensor, ...sensors.filter((name) => name !== sensor)];
        this.root.hidden = false;
      }
    } catch {
      // A hub of an earlier version, or a recording that is gone, which is said elsewhere: no more pictures.
    }
    this.painter.close();
  }

  /** Returns the sensor that has a picture. */
  private async paint(at_s: number, canvas: HTMLCanvasElement, sensors: readonly string[]): Promise<string | undefined> {
    for (const sensor of sensors.slice(0, mostSensors)) {
      do await new Promise((resolve) => setTimeout(resolve, pause_ms));
      while (this.events.isBusy());
      const vp9 = pictureIn(await this.source.keyFrame(sensor, at_s));
      if (vp9 && (await this.painter.paint(vp9, canvas))) return sensor;
    }
    return undefined;
  }

  private clicked({ clientX }: MouseEvent): void {
    const { left, width } = this.root.getBoundingClientRect();
    this.events.seek(Math.min(1, Math.max(0, (clientX - left) / width)) * this.length_s);
  }
}
