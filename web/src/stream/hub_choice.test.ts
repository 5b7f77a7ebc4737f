// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { HubChoice, socketOf } from './hub_choice';

const own = 'wss://a:7600/ws';
const b = 'wss://b:7600/ws';
const c = 'wss://c:7600/ws';

describe('the choice of a hub', () => {
  test('of one hub is that one, after a pause', () => {
    const choice = new HubChoice(own);
    expect(choice.hasOthers).toBe(false);
    expect(choice.failed(false)).toBe(false);
    expect(choice.toTry()).toEqual([own]);
  });

  test('is all others at once when its hub is gone, and then the one that answered', () => {
    const choice = new HubChoice(own);
    choice.learn([b, c]);
    expect(choice.failed(false)).toBe(true);
    expect(choice.toTry()).toEqual([b, c]);
    choice.answered(c);
    choice.welcomed();
    choice.learn([b]); // c does not list itself
    expect(choice.current).toBe(c);
    expect(choice.failed(false)).toBe(true);
    expect(choice.toTry()).toEqual([own, b]);
  });

  test('is all of them after a pause when none has answered', () => {
    const choice = new HubChoice(own);
    choice.learn([b]);
    choice.failed(false);
    choice.nobodyAnswered();
    expect(choice.toTry()).toEqual([own, b]);
  });

  test('of a client that every hub refuses is a pause', () => {
    const choice = new HubChoice(own);
    choice.learn([b]);
    expect(choice.failed(false)).toBe(true);
    choice.answered(b);
    expect(choice.failed(false)).toBe(false);
  });

  test('excludes hubs that refused this client, except its own', () => {
    const choice = new HubChoice(own);
    choice.learn([b]);
    choice.failed(false);
    choice.answered(b);
    choice.failed(true);
    expect(choice.toTry()).toEqual([own]);
    choice.answered(own);
    choice.failed(true);
    expect(choice.toTry()).toEqual([own]);
  });

  test('excludes unencrypted hubs for an encrypted page', () => {
    const choice = new HubChoice(own);
    choice.learn(['ws://b:7600', 'http://c:7600']);
    expect(choice.hasOthers).toBe(false);
  });
});

describe('the socket of a hub', () => {
  test('is at its address', () => {
    expect(socketOf('wss://B/ws#sha256=00')).toBe('wss://b:443/ws');
    expect(socketOf('https://b:443/')).toBe('wss://b:443/ws');
    expect(socketOf('ws://[::1]:7601/hub/ws')).toBe('ws://[::1]:7601/hub/ws');
  });
  test('is undefined for an invalid address', () => {
    for (const url of ['', 'b:7600', 'javascript:alert(1)', 'wss://b c', 'wss://user@b', 'wss://b/ws?x']) {
      expect(socketOf(url)).toBeUndefined();
    }
  });
});
