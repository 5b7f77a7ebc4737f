// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { RateMeter } from './rate_meter';

describe('a rate meter', () => {
  test('needs two readings', () => {
    const meter = new RateMeter();
    expect(meter.perSecond()).toBe(0);
    meter.count(0, 5);
    expect(meter.perSecond()).toBe(0);
  });
  test('gives the rate over the last two seconds', () => {
    const meter = new RateMeter();
    for (let t = 0; t <= 10; t++) meter.count(250 * t, t < 5 ? 0 : (t - 4) * 10);
    expect(meter.perSecond()).toBeCloseTo(60 / 2);
  });
  test('falls to nothing when the counter is no longer read', () => {
    const meter = new RateMeter();
    meter.count(0, 0);
    meter.count(1000, 30);
    expect(meter.perSecond(1000)).toBeCloseTo(30);
    expect(meter.perSecond(2000)).toBeCloseTo(15);
    expect(meter.perSecond(4000)).toBe(0);
  });
  test('begins anew when the counter does', () => {
    const meter = new RateMeter();
    meter.count(0, 1000);
    meter.count(1000, 10);
    expect(meter.perSecond()).toBe(0);
    meter.count(2000, 20);
    expect(meter.perSecond()).toBe(10);
  });
});
