// SPDX-License-Identifier: Apache-2.0
import { beforeEach, describe, expect, test } from 'vitest';
import { accessTo, hasCredential, readAccess, rememberAccess } from './access';

const kept = new Map<string, string>();
const store = {
  getItem: (name: string) => kept.get(name) ?? null,
  setItem: (name: string, value: string) => void kept.set(name, value),
  removeItem: (name: string) => void kept.delete(name),
};
const nothing = { room: '', code: '', token: '' };

describe('access', () => {
  beforeEach(() => kept.clear());

  test('is empty without a link', () => expect(readAccess('', store)).toEqual(nothing));

  test("comes in the address's fragment", () => {
    expect(readAccess('#room=lab&code=abc', store)).toEqual({ ...nothing, room: 'lab', code: 'abc' });
    expect(readAccess('#token=open%20sesame', store).token).toBe('open sesame');
    expect(readAccess(`#token=${'x'.repeat(5000)}`, store)).toEqual(nothing);
  });

  test('is kept for the tab except for codes, and a new link takes precedence', () => {
    rememberAccess({ room: 'lab', code: 'abc', token: 't1' }, store);
    expect(readAccess('', store)).toEqual({ ...nothing, room: 'lab', token: 't1' });
    expect(readAccess('#token=t2', store).token).toBe('t2');
    expect(readAccess('#room=hall', store)).toEqual({ ...nothing, room: 'hall' });
    expect([...kept.values()].join()).not.toContain('abc');
  });

  test('of the tab is not lost where the fragment is a shared viewpoint, and is read beside one', () => {
    rememberAccess({ room: 'lab', code: '', token: 't1' }, store);
    expect(readAccess('#at=1,1,1&look=0,0,0', store).token).toBe('t1');
    expect(readAccess('#at=1,1,1&look=0,0,0&token=t2', store).token).toBe('t2');
    expect(hasCredential('#at=1,1,1&look=0,0,0')).toBe(false);
    expect(hasCredential('#at=1,1,1&token=t2')).toBe(true);
    expect(hasCredential('#code=c')).toBe(true);
  });

  test('survives a store with invalid content', () => {
    kept.set('roomcast.access', '{"token":7');
    expect(readAccess('', store)).toEqual(nothing);
  });

  test('is not sent to another room', () => {
    const access = { ...nothing, room: 'lab', token: 't' };
    expect(accessTo('lab', access)).toEqual(access);
    expect(accessTo('', access)).toEqual(access);
    expect(accessTo('hall', access)).toEqual({ ...nothing, room: 'hall' });
    expect(accessTo('hall', { ...nothing, token: 't' }).token).toBe('t');
  });

  test('can be forgotten', () => {
    rememberAccess({ ...nothing, token: 't' }, store);
    rememberAccess(nothing, store);
    expect(readAccess('', store)).toEqual(nothing);
  });
});
