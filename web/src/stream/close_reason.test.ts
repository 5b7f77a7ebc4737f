// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { ErrorCode } from '../gen/control_pb';
import { explain, isHopeless, reconnectDelay_ms, type Ending } from './close_reason';

const plain: Ending = { opened: true, closeCode: 1006, closeReason: '', error: undefined, ownFault: undefined };
const sentenceFor = (change: Partial<Ending>) => explain({ ...plain, ...change }, 'lab:7600', 'lab').sentence;

describe('the end of a connection is explained', () => {
  test('when no hub answered', () => {
    expect(sentenceFor({ opened: false })).toBe('The hub at lab:7600 does not answer.');
  });
  test('when it broke', () => {
    expect(sentenceFor({})).toBe('The connection to the hub at lab:7600 is gone.');
  });
  test('when the hub stops, by close code or by message', () => {
    const error = { code: ErrorCode.ERROR_SHUTTING_DOWN, sentence: 'bye' };
    expect(sentenceFor({ closeCode: 1001 })).toBe('The hub has stopped.');
    expect(sentenceFor({ error })).toBe('The hub has stopped.');
  });
  test("in the hub's own words where it gave some", () => {
    expect(sentenceFor({ error: { code: ErrorCode.ERROR_MALFORMED, sentence: 'that was garbage' } })).toMatch(
      /garbage/,
    );
    expect(sentenceFor({ closeReason: 'limits' })).toMatch(/limits/);
  });
  test('by a wrong version, which only a reload can fix', () => {
    const error = { code: ErrorCode.ERROR_UNSUPPORTED, sentence: '' };
    expect(explain({ ...plain, error }, 'h', 'lab')).toMatchObject({ reload: true });
    expect(explain({ ...plain, ownFault: { sentence: 'x', unsupported: true } }, 'h', 'lab')).toMatchObject({ reload: true });
    expect(explain(plain, 'h', 'lab').reload).toBe(false);
  });
  test('by a choice of rooms where none was requested', () => {
    const error = { code: ErrorCode.ERROR_NO_SUCH_ROOM, sentence: '' };
    expect(explain({ ...plain, error }, 'h', 'lab').sentence).toMatch(/no room of that name/);
    expect(explain({ ...plain, error }, 'h', '').sentence).toMatch(/several rooms/);
  });
  test('by a fault that this side found', () => {
    expect(sentenceFor({ ownFault: { sentence: 'The hub has gone silent.', unsupported: false } })).toBe(
      'The hub has gone silent.',
    );
  });
});

test('the wait before the next try doubles up to five seconds and is spread', () => {
  expect([1, 2, 3, 4, 5, 6, 60].map((n) => reconnectDelay_ms(n, 1 - Number.EPSILON)).map(Math.round)).toEqual([
    250, 500, 1000, 2000, 4000, 5000, 5000,
  ]);
  expect(reconnectDelay_ms(6, 0)).toBe(3750);
});

test('what a hub refuses for good is hopeless, and what may pass is not', () => {
  const refusal = (code: ErrorCode) => isHopeless({ ...plain, error: { code, sentence: '' } });
  const forGood = [
    ErrorCode.ERROR_UNAUTHENTICATED,
    ErrorCode.ERROR_TOKEN_EXPIRED,
    ErrorCode.ERROR_TOKEN_REVOKED,
    ErrorCode.ERROR_TOKEN_INVALID,
    ErrorCode.ERROR_CODE_USED,
    ErrorCode.ERROR_WRONG_ROOM,
    ErrorCode.ERROR_WRONG_ROLE,
    ErrorCode.ERROR_NO_SUCH_ROOM,
  ];
  expect(forGood.filter((code) => !refusal(code))).toEqual([]);
  expect(isHopeless(plain)).toBe(false);
  const passing = [ErrorCode.ERROR_BUSY, ErrorCode.ERROR_ROOM_FULL, ErrorCode.ERROR_SHUTTING_DOWN, ErrorCode.ERROR_TOO_SLOW];
  expect(passing.filter(refusal)).toEqual([]);
  expect(reconnectDelay_ms(1, 0, true)).toBe(45_000);
});

test('another token helps where the token is at fault, not where the room is', () => {
  const needs = (code: ErrorCode) => explain({ ...plain, error: { code, sentence: '' } }, 'h', 'lab').needsToken;
  expect(needs(ErrorCode.ERROR_UNAUTHENTICATED)).toBe(true);
  expect(needs(ErrorCode.ERROR_TOKEN_EXPIRED)).toBe(true);
  expect(needs(ErrorCode.ERROR_NO_SUCH_ROOM)).toBe(false);
  expect(needs(ErrorCode.ERROR_BUSY)).toBe(false);
});
