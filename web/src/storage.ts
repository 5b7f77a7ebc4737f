// SPDX-License-Identifier: Apache-2.0
// The browser's storage, or the page's own memory where the browser blocks it ("block all cookies"): even asking for
// `localStorage` throws there.

export type Store = Pick<Storage, 'getItem' | 'setItem' | 'removeItem'>;

export interface Kept {
  store: Store;
  outlivesPage: boolean; // values are there again after a reload
}

const probe = 'roomcast.probe';

/** `ask` returns the storage, as in `() => sessionStorage`. */
export function keptIn(ask: () => Store): Kept {
  try {
    const store = ask();
    store.setItem(probe, '');
    store.removeItem(probe);
    return { store, outlivesPage: true };
  } catch {
    return { store: memory(), outlivesPage: false };
  }
}

function memory(): Store {
  const values = new Map<string, string>();
  return {
    getItem: (key) => values.get(key) ?? null,
    setItem: (key, value) => void values.set(key, value),
    removeItem: (key) => void values.delete(key),
  };
}
