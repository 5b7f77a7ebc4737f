// SPDX-License-Identifier: Apache-2.0
// What keeps a wearer comfortable: a view that narrows while a stick walks him, and eyes at a standing person's
// height for one who sits. Pure, but for what the browser keeps of the choices.
import type { Store } from '../storage';

export const standingEyes_m = 1.6;
const fade_perS = 5; // the view narrows, and widens again, in a fifth of a second
const storageKey = 'roomcast.comfort';

export interface Comfort {
  narrowsView: boolean; // while a stick walks the wearer smoothly: fewer people feel sick (Fernandes & Feiner 2016)
  isSeated: boolean; // the wearer sits, and sees the room as if standing
}

/** As chosen in earlier visits; the view narrows if nothing was chosen. */
export function keptComfort(store: Store): Comfort {
  const kept = (store.getItem(storageKey) ?? '').split(' ');
  return { narrowsView: !kept.includes('wide'), isSeated: kept.includes('seated') };
}

export function keepComfort(store: Store, { narrowsView, isSeated }: Comfort): void {
  store.setItem(storageKey, [narrowsView ? 'narrow' : 'wide', isSeated ? 'seated' : 'standing'].join(' '));
}

/** How narrow the view is, 0 to 1, after `seconds` in which the wearer was moved or not. */
export function narrowed(before: number, isMoved: boolean, seconds: number): number {
  const step = fade_perS * seconds;
  return Math.min(1, Math.max(0, before + (isMoved ? step : -step)));
}

/** By how much a seated wearer is lifted, whose eyes are at this height above his own floor; who is tall enough stays. */
export function liftOf(eyes_m: number): number {
  return Math.max(0, standingEyes_m - eyes_m);
}
