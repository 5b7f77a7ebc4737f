// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { sendingText } from './sending';

test('a card says why a sensor sends nothing, or which share of the uplink it has', () => {
  expect(sendingText({ unseen: true, share_mbit: 0 })).toMatch(/nobody looks at it/);
  expect(sendingText({ unseen: false, share_mbit: 1.234 })).toMatch(/^1\.23 Mbit\/s of the room/);
  expect(sendingText({ unseen: false, share_mbit: 0 })).toBe('');
  expect(sendingText({}), 'an earlier hub says nothing of it').toBe('');
});
