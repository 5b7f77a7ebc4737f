// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { pingDelay_ms, RoomClock } from './room_clock';

/** A ping that takes `there` ms to the hub and `back` ms back, where room time is local time + `offset`. */
function exchange(clock: RoomClock, offset: number, sent: number, there: number, back: number): void {
  clock.addExchange(sent, sent + there + back, sent + there + offset);
}

describe('the room clock', () => {
  test('knows nothing before the first exchange', () => {
    expect(new RoomClock().estimate()).toBeUndefined();
  });

  test('is exact when both ways take the same time', () => {
    const clock = new RoomClock();
    exchange(clock, -5000, 100, 8, 8);
    expect(clock.estimate()).toEqual({ offset_ms: -5000, error_ms: 8 });
  });

  test('uses the quickest exchange, and its error bound holds', () => {
    const clock = new RoomClock();
    exchange(clock, 1234, 0, 80, 2);
    exchange(clock, 1234, 500, 3, 1);
    exchange(clock, 1234, 1000, 2, 90);
    const { offset_ms, error_ms } = clock.estimate()!;
    expect(error_ms).toBe(2);
    expect(Math.abs(offset_ms - 1234)).toBeLessThanOrEqual(error_ms);
  });

  test('forgets an exchange after 32 later ones', () => {
    const clock = new RoomClock();
    exchange(clock, 0, 0, 1, 1);
    for (let i = 1; i < 32; i++) exchange(clock, 70, 1000 * i, 20, 20);
    expect(clock.estimate()!.offset_ms).toBe(0);
    exchange(clock, 70, 32_000, 20, 20);
    expect(clock.estimate()).toEqual({ offset_ms: 70, error_ms: 20 });
  });

  test('ignores an answer from before the question', () => {
    const clock = new RoomClock();
    clock.addExchange(100, 99, 5);
    clock.addExchange(100, 101, NaN);
    expect(clock.estimate()).toBeUndefined();
  });
});

describe('pings', () => {
  test('begin with five quick ones and go on about twice a second at random distances', () => {
    expect(pingDelay_ms(0, 0.5)).toBe(0);
    for (let count = 1; count < 5; count++) expect(pingDelay_ms(count, 0.99)).toBeLessThan(100);
    expect(pingDelay_ms(5, 0.5)).toBe(500);
    expect(pingDelay_ms(9, 0)).not.toBe(pingDelay_ms(9, 0.9));
  });
});
