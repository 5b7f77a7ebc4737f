// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from 'vitest';
import { changesOf, rateOf } from './sensor_settings';

describe('settings of a sensor', () => {
  it('have a kind of target rate', () => {
    expect([rateOf(undefined), rateOf(0), rateOf(2.5), rateOf('auto')]).toEqual(['none', 'none', 'number', 'auto']);
  });

  it('are asked for where they differ', () => {
    const now = { codec: 'live', mbit: 0, fps: 15 };
    expect(changesOf(now, { codec: 'live', mbit: 'auto', fps: 15 })).toEqual({ mbit: 'auto' });
    expect(changesOf(now, now)).toEqual({});
  });
});
