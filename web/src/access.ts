// SPDX-License-Identifier: Apache-2.0
// By what right this page asks to come in: the hub's key, a code for one time, or a token. They come in the part of a
// link after the #, which is not sent when the page is fetched; it is taken out of the address at once, and what has to
// outlive a reload is kept for this tab alone.

export interface Access {
  room: string; // that it is for, or empty
  key: string;
  code: string;
  token: string;
}

type Store = Pick<Storage, 'getItem' | 'setItem' | 'removeItem'>;

const storeKey = 'roomcast.access';
const longest = 4096; // characters of a token

function part(given: URLSearchParams, name: string): string {
  const value = given.get(name) ?? '';
  return value.length <= longest ? value : '';
}

/** `hash` is the address's, `store` the tab's own. A link counts more than what is remembered. */
export function readAccess(hash: string, store: Store): Access {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const fresh = {
    room: part(given, 'room'),
    key: part(given, 'key'),
    code: part(given, 'code'),
    token: part(given, 'token'),
  };
  if (fresh.key || fresh.code || fresh.token) return fresh;
  const kept = remembered(store);
  return fresh.room === '' || fresh.room === kept.room ? kept : fresh;
}

/** A code is good for one time: it is not kept. */
export function rememberAccess({ room, key, token }: Access, store: Store): void {
  if (key || token) store.setItem(storeKey, JSON.stringify({ room, key, token }));
  else store.removeItem(storeKey);
}

function remembered(store: Store): Access {
  const nothing = { room: '', key: '', code: '', token: '' };
  try {
    const kept = JSON.parse(store.getItem(storeKey) ?? '{}') as Record<string, unknown>;
    const text = (name: string) => (typeof kept[name] === 'string' ? kept[name] : '');
    return { ...nothing, room: text('room'), key: text('key'), token: text('token') };
  } catch {
    return nothing;
  }
}
