// SPDX-License-Identifier: Apache-2.0
// Where a room was put in the wearer's own room, as the browser keeps it.
import type { Store } from '../storage';

export interface PlacedRoom {
  handle: string; // of the headset's anchor on the wearer's own floor or table
  x: number; // the point of the room that is there, metres, on the room's floor
  z: number;
  heading: number; // the anchor's in the room, radians
}

const keyOf = (room: string) => `roomcast.placed.${room}`;

export function keepPlaced(store: Store, room: string, placed: PlacedRoom): void {
  store.setItem(keyOf(room), JSON.stringify(placed));
}

export function keptPlaced(store: Store, room: string): PlacedRoom | undefined {
  try {
    const { handle, x, z, heading } = JSON.parse(store.getItem(keyOf(room)) ?? '') as Partial<PlacedRoom>;
    if (typeof handle !== 'string' || ![x, z, heading].every(Number.isFinite)) return undefined;
    return { handle, x: x!, z: z!, heading: heading! };
  } catch {
    return undefined; // nothing, or something else, is kept there
  }
}
