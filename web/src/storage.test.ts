// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { keptIn } from './storage';

const blocked = () => {
  throw new DOMException('Access is denied for this document.', 'SecurityError');
};

test('where the browser blocks storage, values are kept by the page alone', () => {
  const { store, outlivesPage } = keptIn(blocked);
  expect(outlivesPage).toBe(false);
  expect(store.getItem('a')).toBe(null);
  store.setItem('a', '1');
  expect(store.getItem('a')).toBe('1');
  store.removeItem('a');
  expect(store.getItem('a')).toBe(null);
});

test('a storage that takes nothing, or is not there, does not break the page', () => {
  const full = { getItem: () => null, setItem: blocked, removeItem: blocked };
  const { store, outlivesPage } = keptIn(() => full);
  store.setItem('a', '1');
  expect(store.getItem('a')).toBe('1');
  expect(outlivesPage).toBe(false);
  expect(keptIn(() => undefined as unknown as Storage).outlivesPage).toBe(false);
});

test('a storage that works is used', () => {
  const values = new Map<string, string>();
  const working = {
    getItem: (key: string) => values.get(key) ?? null,
    setItem: (key: string, value: string) => void values.set(key, value),
    removeItem: (key: string) => void values.delete(key),
  };
  const { store, outlivesPage } = keptIn(() => working);
  store.setItem('a', '1');
  expect(outlivesPage).toBe(true);
  expect([...values]).toEqual([['a', '1']]);
});
