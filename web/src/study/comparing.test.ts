// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { drawnOrder } from './comparing';

function chances(...values: number[]) {
  let next = 0;
  return () => values[next++ % values.length]!;
}

describe('the order of pairs', () => {
  test('has every pair once, with its number in the plan', () => {
    const order = drawnOrder(['a', 'b', 'c', 'd'], chances(0.1, 0.9, 0.4, 0.6, 0.3));
    expect(order.map(({ pair }) => pair).sort()).toEqual(['a', 'b', 'c', 'd']);
    for (const { index, pair } of order) expect('abcd'[index]).toBe(pair);
  });

  test('is drawn by chance, as are the sides', () => {
    const firsts = new Map<string, number>();
    let lefts = 0;
    for (let i = 0; i < 400; i++) {
      const [first] = drawnOrder(['a', 'b', 'c', 'd'], Math.random);
      firsts.set(first!.pair, (firsts.get(first!.pair) ?? 0) + 1);
      lefts += first!.left === 'real' ? 1 : 0;
    }
    for (const count of firsts.values()) expect(count).toBeGreaterThan(60); // 100 expected, deviation 9
    expect(Math.abs(lefts - 200)).toBeLessThan(60); // deviation 10
  });
});
