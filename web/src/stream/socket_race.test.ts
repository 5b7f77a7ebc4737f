// SPDX-License-Identifier: Apache-2.0
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { SocketRace } from './socket_race';

class FakeSocket {
  static all: FakeSocket[] = [];
  onopen: (() => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;
  isClosed = false;
  constructor(readonly url: string) {
    FakeSocket.all.push(this);
  }
  close(): void {
    this.isClosed = true;
  }
}

let heard: string[];
const [gone, nothing] = [{ code: 1006, reason: '' }, null];

function race(...urls: string[]): FakeSocket[] {
  new SocketRace(urls, 'p', { won: (_, url) => heard.push(`won ${url}`), lost: ({ code }) => heard.push(`lost ${code}`) });
  return FakeSocket.all;
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('WebSocket', FakeSocket);
  FakeSocket.all = [];
  heard = [];
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

describe('a race of sockets', () => {
  test('is won by the first that opens, and the others are closed', () => {
    const [a, b] = race('a', 'b');
    b!.onopen!();
    expect(heard).toEqual(['won b']);
    expect(a!.isClosed).toBe(true);
    expect(a!.onopen).toBe(nothing);
    expect(b!.isClosed).toBe(false);
    vi.advanceTimersByTime(10_000);
    expect(heard).toEqual(['won b']);
  });
  test('is lost when none opens', () => {
    const [a, b] = race('a', 'b');
    a!.onclose!(gone);
    expect(heard).toEqual([]);
    b!.onclose!(gone);
    expect(heard).toEqual(['lost 1006']);
  });
  test('is lost when no hub answers', () => {
    const [a, b] = race('a', 'b');
    vi.advanceTimersByTime(5000);
    expect(heard).toEqual(['lost 1006']);
    expect([a!.isClosed, b!.isClosed]).toEqual([true, true]);
  });
});
