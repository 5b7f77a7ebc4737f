// SPDX-License-Identifier: Apache-2.0
// The name of this page's viewer: the address's, or the one that was given here before, which is kept in this browser.
import type { Store } from './storage';
import { asName } from './wire/name_check';

const storeKey = 'roomcast.name';

/** Empty if none was ever given. */
export function ownName(given: string, store: Store): string {
  return given || asName(store.getItem(storeKey) ?? '').trim();
}

/** The name as far as it is legal; it is kept unless nothing is left of it. */
export function takeName(text: string, store: Store): string {
  const name = asName(text.trim()).trim();
  if (name) store.setItem(storeKey, name);
  return name;
}
