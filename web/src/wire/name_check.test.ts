// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { asName, checkName } from './name_check';

test('typed text becomes a legal name', () => {
  expect(asName('  Émilie\u0000 ')).toBe('Émilie');
  expect(asName('é'.repeat(40))).toBe('é'.repeat(32));
  for (const typed of ['😀'.repeat(30), '\u0085', 'x'.repeat(1000), '']) {
    expect(() => checkName(asName(typed), 'viewer')).not.toThrow();
  }
});
