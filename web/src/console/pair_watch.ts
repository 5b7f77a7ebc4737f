// SPDX-License-Identifier: Apache-2.0
// Compares all pairs of sensors from time to time, one pair per step so that the page stays responsive.
import type { RoomSensor } from '../room_roster';
import type { ViewFrame } from '../stream/protocol';
import { rayTable } from '../view/ray_table';
import { pairGap, type DepthPicture, type PairGap } from './pair_gap';

const copyEvery_ms = 3000; // per sensor

interface Kept {
  picture: DepthPicture;
  copiedAt_ms: number;
}

export interface Pair extends PairGap {
  a: number;
  b: number;
}

export class PairWatch {
  private readonly kept = new Map<number, Kept>();
  private readonly found = new Map<string, Pair>();
  private next = 0;

  get pairs(): Pair[] {
    return [...this.found.values()];
  }

  offer(frames: readonly ViewFrame[], now_ms: number): void {
    for (const { sensor, depth_mm } of frames) {
      const known = this.kept.get(sensor);
      if (!known || now_ms - known.copiedAt_ms < copyEvery_ms || depth_mm.length !== known.picture.depth_mm.length)
        continue;
      known.picture.depth_mm.set(depth_mm);
      known.copiedAt_ms = now_ms;
    }
  }

  /** Compares the next pair. */
  step(entries: readonly RoomSensor[]): void {
    this.follow(entries.filter((entry) => entry.online));
    const ids = [...this.kept.keys()].sort((a, b) => a - b);
    const all = ids.flatMap((a, i) => ids.slice(i + 1).map((b) => [a, b] as const));
    if (all.length === 0) return;
    const [a, b] = all[this.next++ % all.length]!;
    const gap = pairGap(this.kept.get(a)!.picture, this.kept.get(b)!.picture);
    if (gap) this.found.set(`${a} ${b}`, { a, b, ...gap });
    else this.found.delete(`${a} ${b}`);
  }

  private follow(online: readonly RoomSensor[]): void {
    const listed = new Set(online.map(({ id }) => id));
    for (const id of this.kept.keys()) if (!listed.has(id)) this.forget(id);
    for (const { id, calibration, pose } of online) {
      const { worldFromDepth } = pose;
      const lens = calibration!.depth!;
      const known = this.kept.get(id);
      if (known && known.picture.lens.width === lens.width && known.picture.lens.fx === lens.fx) {
        known.picture.worldFromDepth = worldFromDepth;
        continue;
      }
      const { rays } = rayTable(lens, lens.width, lens.height);
      const depth_mm = new Uint16Array(lens.width * lens.height);
      this.kept.set(id, { picture: { lens, rays, depth_mm, worldFromDepth }, copiedAt_ms: -Infinity });
    }
  }

  private forget(id: number): void {
    this.kept.delete(id);
    for (const [key, { a, b }] of this.found) if (a === id || b === id) this.found.delete(key);
  }
}
