// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { linesOf } from './text_label';

const measure = (text: string) => text.length;

test('words are broken into lines, and long words, too', () => {
  expect(linesOf('mind the step here', 9, 9, measure)).toEqual(['mind the', 'step here']);
  expect(linesOf('abcdefghij', 4, 9, measure)).toEqual(['abcd', 'efgh', 'ij']);
  expect(linesOf('', 4, 9, measure)).toEqual(['']);
});

test('what does not fit is said to be more', () => {
  expect(linesOf('a b c d', 1, 2, measure)).toEqual(['a', 'b …']);
});
