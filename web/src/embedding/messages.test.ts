// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from 'vitest';
import { toRoom } from './messages';

describe('what a page around a room asks', () => {
  it('is understood', () => {
    expect(toRoom({ kind: 'mute', muted: true })).toEqual({ kind: 'mute', muted: true });
    expect(toRoom({ kind: 'place', name: 'Door' })).toEqual({ kind: 'place', name: 'Door' });
    expect(toRoom({ kind: 'mode', mode: 'points', more: 1 })).toEqual({ kind: 'mode', mode: 'points' });
    expect(toRoom({ kind: 'look', at: [0, 1, 2], look: [0, 0, 0] })).toEqual({ kind: 'look', at: [0, 1, 2], look: [0, 0, 0] });
  });

  it('is nothing where it is anything else', () => {
    const wrong = [null, 3, 'mute', {}, { kind: 'mute' }, { kind: 'mute', muted: 1 }, { kind: 'place', name: ['Door'] }];
    const nowhere = [{ kind: 'look', at: [0, 1], look: [0, 0, 0] }, { kind: 'look', at: [0, NaN, 1], look: [0, 0, 0] }];
    for (const data of [...wrong, ...nowhere, { kind: 'look', at: ['0', 1, 2], look: [0, 0, 0] }, { kind: 'token' }])
      expect(toRoom(data)).toBeUndefined();
  });
});
