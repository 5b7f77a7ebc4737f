// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { DoubleTap } from './double_tap';

function tap(taps: DoubleTap, x: number, y: number, at_ms: number, { dx = 0, held_ms = 60 } = {}): boolean {
  taps.down(x, y, at_ms);
  return taps.up(x + dx, y, at_ms + held_ms);
}

test('two taps of a place are a double tap, a third one begins anew', () => {
  const taps = new DoubleTap();
  expect([0, 200, 400, 600].map((ms) => tap(taps, 100, 100, ms))).toEqual([false, true, false, true]);
});

test('slow, distant, long and dragged taps are not', () => {
  const pairs: [number, object][] = [
    [800, {}],
    [200, { dx: 30 }],
    [200, { held_ms: 400 }],
  ];
  for (const [ms, how] of pairs) {
    const taps = new DoubleTap();
    tap(taps, 100, 100, 0);
    expect(tap(taps, 100, 100, ms, how)).toBe(false);
  }
  const far = new DoubleTap();
  tap(far, 100, 100, 0);
  expect(tap(far, 200, 100, 200)).toBe(false);
});

test('a second finger breaks it', () => {
  const taps = new DoubleTap();
  tap(taps, 100, 100, 0);
  taps.down(100, 100, 150);
  taps.cancel();
  expect(taps.up(100, 100, 200)).toBe(false);
  expect(tap(taps, 100, 100, 260)).toBe(false);
});
