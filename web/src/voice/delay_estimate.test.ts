// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { DelayEstimate, leastTarget_ms, mostTarget_ms } from './delay_estimate';

/** `late_ms` of every packet; the line takes 30 ms at least. */
function after(late_ms: (i: number) => number, packets = 1000): DelayEstimate {
  const delay = new DelayEstimate();
  for (let i = 0; i < packets; i++) delay.arrived(20 * i, 20 * i + 30 + late_ms(i));
  return delay;
}

test('an even line needs the least delay', () => {
  const delay = after(() => 0);
  expect(delay.shortest_ms).toBe(30);
  expect(delay.target_ms).toBe(leastTarget_ms);
});

test('the target follows what 98 % of the packets need', () => {
  expect(after((i) => (i % 10 === 0 ? 60 : 0)).target_ms).toBeGreaterThan(60);
  expect(after((i) => (i % 100 === 99 ? 60 : 0)).target_ms).toBeLessThan(60);
});

test('one late packet does not raise it all the way', () => {
  const delay = after(() => 0);
  delay.arrived(20_000, 20_130);
  expect(delay.target_ms).toBeLessThan(75);
});

test('the target is bounded, whatever times a speaker claims', () => {
  expect(after((i) => (i % 2) * 1e9).target_ms).toBe(mostTarget_ms);
});

test('a line that has become longer is the usual after a while', () => {
  const delay = after((i) => (i < 100 ? 0 : 70), 2500);
  expect(delay.shortest_ms).toBe(100);
  expect(delay.target_ms).toBe(leastTarget_ms);
});
