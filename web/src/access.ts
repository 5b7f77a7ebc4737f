// SPDX-License-Identifier: Apache-2.0
// This page's credential: a one-time code or a token. Both arrive in the part of a link after the #, which is not sent
// when the page is fetched. The page removes that part from the address at once, and stores only what must survive a
// reload, for this tab alone.
import type { Store } from './storage';

export interface Access {
  room: string; // room of the credential, or empty
  code: string;
  token: string;
}

const storeKey = 'roomcast.access';
const longest = 4096; // characters of a token

function part(given: URLSearchParams, name: string): string {
  const value = given.get(name) ?? '';
  return value.length <= longest ? value : '';
}

/** `hash` is the address's, `store` the tab's own. A link takes precedence over the stored credential. */
export function readAccess(hash: string, store: Store): Access {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const fresh = {
    room: part(given, 'room'),
    code: part(given, 'code'),
    token: part(given, 'token'),
  };
  if (fresh.code || fresh.token) return fresh;
  const kept = remembered(store);
  return fresh.room === '' || fresh.room === kept.room ? kept : fresh;
}

/** True for the fragment of a link with a code or a token. */
export function hasCredential(hash: string): boolean {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  return part(given, 'code') !== '' || part(given, 'token') !== '';
}

/** Never presents a credential for another room. */
export function accessTo(room: string, access: Access): Access {
  const isForAnother = room !== '' && access.room !== '' && access.room !== room;
  return isForAnother ? { room, code: '', token: '' } : access;
}

/** A code is valid once, so it is not stored. */
export function rememberAccess({ room, token }: Access, store: Store): void {
  if (token) store.setItem(storeKey, JSON.stringify({ room, token }));
  else store.removeItem(storeKey);
}

function remembered(store: Store): Access {
  const nothing = { room: '', code: '', token: '' };
  try {
    const kept = JSON.parse(store.getItem(storeKey) ?? '{}') as Record<string, unknown>;
    const text = (name: string) => (typeof kept[name] === 'string' ? kept[name] : '');
    return { ...nothing, room: text('room'), token: text('token') };
  } catch {
    return nothing;
  }
}
