// SPDX-License-Identifier: Apache-2.0
// The secret by which the hub recognises the marks of this browser's user (docs/spec/wire.md, Marks). It is made once,
// and kept in this browser.
import { hexText } from './hex_text';
import type { Store } from './storage';

const storeKey = 'roomcast.author';
const bytes = 16;
const form = new RegExp(`^[0-9a-f]{${2 * bytes}}$`);

export function authorKey(store: Store): Uint8Array<ArrayBuffer> {
  const kept = store.getItem(storeKey) ?? '';
  if (form.test(kept)) return Uint8Array.from({ length: bytes }, (_, i) => parseInt(kept.slice(2 * i, 2 * i + 2), 16));
  const made = crypto.getRandomValues(new Uint8Array(bytes));
  store.setItem(storeKey, hexText(made));
  return made;
}
