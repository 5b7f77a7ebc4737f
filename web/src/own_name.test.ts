// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { ownName, takeName } from './own_name';
import { keptIn } from './storage';

const blocked = () => {
  throw new DOMException('denied', 'SecurityError');
};

test('a name that was given is there again, and the address’s takes precedence', () => {
  const { store } = keptIn(blocked);
  expect(ownName('', store)).toBe('');
  expect(takeName('  Ada\u0000 ', store)).toBe('Ada');
  expect(ownName('', store)).toBe('Ada');
  expect(ownName('Grace', store)).toBe('Grace');
});

test('an empty or endless one is not taken as it is', () => {
  const { store } = keptIn(blocked);
  expect(takeName(' \u0007 ', store)).toBe('');
  expect(ownName('', store)).toBe('');
  expect(new TextEncoder().encode(takeName('ü'.repeat(200), store)).length).toBeLessThanOrEqual(64);
});
