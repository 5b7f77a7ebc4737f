// SPDX-License-Identifier: Apache-2.0
import { create, toBinary } from '@bufbuild/protobuf';
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { ControlSchema, ErrorCode, type Control } from '../gen/control_pb';
import { audioPayload, encodeAudio, parseAudioHeader } from '../wire/audio_header';
import { decodeControl, type ControlMessage } from '../wire/control';
import { HubConnection } from './hub_connection';
import type { ConnectionState } from './protocol';

/** The hub's end of the browser's WebSocket. */
class FakeSocket {
  static readonly OPEN = 1;
  static all: FakeSocket[] = [];
  readyState = 0;
  sent: Control[] = [];
  audio: Uint8Array[] = [];
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;
  closedWith: number | undefined;

  constructor(
    readonly url: string,
    readonly protocol: string,
  ) {
    FakeSocket.all.push(this);
  }
  send(bytes: Uint8Array): void {
    if (bytes[3] === 3) this.audio.push(bytes);
    else this.sent.push(decodeControl(bytes));
  }
  close(code?: number): void {
    this.closedWith = code;
    this.readyState = 3;
  }
  open(): void {
    this.readyState = FakeSocket.OPEN;
    this.onopen!();
  }
  end(code: number, reason = ''): void {
    this.readyState = 3;
    this.onclose!({ code, reason });
  }
  say(message: ControlMessage): void {
    const body = toBinary(ControlSchema, create(ControlSchema, { message }));
    this.sayBytes(Uint8Array.from([0x52, 0x43, 1, 2, ...body]));
  }
  sayBytes(bytes: Uint8Array): void {
    this.onmessage!({ data: bytes.slice().buffer });
  }
}

let states: ConnectionState[];
let seen: string[];

function start(): HubConnection {
  const connection = new HubConnection(
    { socketUrl: 'ws://hub:7600/ws', room: 'lab', name: 'Ada', access, hears: true, authorKey: new Uint8Array([1, 2]) },
    {
      connection: (state) => states.push(state),
      welcome: (welcome) => seen.push(`welcome ${welcome.viewerId}`),
      roster: () => seen.push('roster'),
      poses: () => seen.push('poses'),
      marks: ({ marks }) => seen.push(`${marks.length} marks`),
      guide: (viewer) => seen.push(`guide ${viewer}`),
      unseen: ({ paused }) => seen.push(`unseen ${paused.join()}`),
      setEnded: (setId) => seen.push(`end of ${setId}`),
      frame: (header) => seen.push(`frame ${header.seq}`),
      voices: ({ speaking }) => seen.push(`voices ${speaking.join()}`),
      audio: ({ speaker }, payload) => seen.push(`audio ${speaker}: ${payload.join()}`),
      disconnected: () => seen.push('disconnected'),
    },
  );
  connection.connect();
  return connection;
}

const socket = () => FakeSocket.all.at(-1)!;
const sentence = () => states.at(-1)!.sentence;

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('WebSocket', FakeSocket);
  FakeSocket.all = [];
  states = [];
  seen = [];
});
afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

const access = { room: '', code: 'once', token: '' };

/** The socket of a hub that has welcomed the page and announced another hub. */
function welcomedBesideAnother() {
  start();
  socket().open();
  const first = socket();
  first.say({ case: 'welcome', value: {} });
  first.say({ case: 'otherHubs', value: { urls: ['ws://b:7600'] } });
  return first;
}

describe('a hub connection', () => {
  test('speaks roomcast.v1 and joins as a viewer', () => {
    start();
    socket().open();
    expect(socket().protocol).toBe('roomcast.v1');
    expect(socket().sent[0]!.message).toMatchObject({
      case: 'join',
      value: { room: 'lab', name: 'Ada', role: { case: 'viewer' }, code: 'once' },
    });
    socket().say({ case: 'welcome', value: { viewerId: 9 } });
    expect(seen).toEqual(['welcome 9']);
    expect(states.map((state) => state.phase)).toEqual(['connecting', 'joined']);
  });

  test('asks for audio, and passes it and who speaks on', () => {
    start();
    socket().open();
    expect(socket().sent[0]!.message.value).toMatchObject({ role: { value: { hears: true } } });
    socket().say({ case: 'voices', value: { speaking: [7] } });
    const packet = encodeAudio({ ends: false, seq: 1, capture_ns: 5n }, Uint8Array.of(8, 9));
    packet[8] = 7; // as the hub does
    socket().sayBytes(packet);
    expect(seen).toEqual(['voices 7', 'audio 7: 8,9']);
  });

  test('tells which sensors are left out, and where a set ends without its last frame', () => {
    start();
    socket().open();
    socket().say({ case: 'unseenSensors', value: { baseOnly: [1], paused: [2, 3] } });
    socket().say({ case: 'setEnd', value: { setId: 9n } });
    expect(seen).toEqual(['unseen 2,3', 'end of 9']);
  });

  test('sends audio in room time, numbered from 0, where the room lets it speak', () => {
    const connection = start();
    socket().open();
    const say = (page_ms: number) => connection.sendAudio(page_ms, false, Uint8Array.of(1));
    say(0);
    socket().say({ case: 'welcome', value: { maySpeak: true } });
    say(0);
    expect(socket().audio).toEqual([]); // room time is not known yet
    const now_ns = BigInt(Math.round(performance.now() * 1e6));
    socket().say({ case: 'clockPong', value: { clientNs: now_ns, hubNs: now_ns + 5_000_000_000n } });
    const page_ms = performance.timeOrigin + performance.now();
    say(page_ms);
    say(page_ms + 20);
    const headers = socket().audio.map((bytes) => parseAudioHeader(new DataView(bytes.buffer)));
    expect(headers.map(({ seq, speaker }) => [seq, speaker])).toEqual([
      [0, 0],
      [1, 0],
    ]);
    expect(headers[1]!.capture_ns - headers[0]!.capture_ns).toBe(20_000_000n);
    expect(Math.abs(Number(headers[0]!.capture_ns - now_ns) / 1e6 - 5000)).toBeLessThan(1);
    expect(audioPayload(socket().audio[0]!, headers[0]!)).toEqual(Uint8Array.of(1));
    connection.rename('Bob');
    socket().open();
    say(page_ms + 40);
    expect(socket().audio).toEqual([]); // until it is welcome again
  });

  test('stops where the hub refuses it for good, and says so', () => {
    start();
    socket().open();
    socket().say({ case: 'error', value: { code: ErrorCode.ERROR_TOKEN_EXPIRED, sentence: '' } });
    socket().end(1008);
    expect(states.at(-1)).toMatchObject({ phase: 'waiting', ended: true, needsToken: true, retryAt_ms: undefined });
    vi.advanceTimersByTime(600_000);
    expect(FakeSocket.all.length).toBe(1);
  });

  test('goes on while a hub that may still accept it does not answer', () => {
    const first = welcomedBesideAnother();
    first.end(1006);
    vi.advanceTimersByTime(0);
    const other = FakeSocket.all.find(({ url }) => url === 'ws://b:7600/ws')!;
    other.open();
    other.say({ case: 'error', value: { code: ErrorCode.ERROR_TOKEN_INVALID, sentence: '' } });
    other.end(1008);
    expect(states.at(-1)!.ended).toBe(false);
    const before = FakeSocket.all.length;
    vi.advanceTimersByTime(61_000);
    expect(FakeSocket.all.length).toBeGreaterThan(before);
  });

  test('reconnects with the token that it got for its code', () => {
    start();
    socket().open();
    socket().say({ case: 'welcome', value: { token: 'signed' } });
    socket().end(1006);
    vi.advanceTimersByTime(1000);
    socket().open();
    expect(FakeSocket.all.length).toBe(2);
    expect(socket().sent[0]!.message).toMatchObject({ case: 'join', value: { token: 'signed', code: '' } });
  });

  test('joins again under another name, with the token that it got, and without a word of trouble', () => {
    const connection = start();
    socket().open();
    const first = socket();
    first.say({ case: 'welcome', value: { viewerId: 9, token: 'mine' } });
    connection.rename('Grace\u0000');
    expect(first.closedWith).toBe(1000);
    expect(first.onclose).toBe(null);
    socket().open();
    expect(FakeSocket.all.length).toBe(2);
    expect(socket().sent[0]!.message.value).toMatchObject({ name: 'Grace', token: 'mine', code: '' });
    expect(seen).toEqual(['welcome 9', 'disconnected']);
    expect(states.map((state) => state.phase)).toEqual(['connecting', 'joined', 'connecting']);
    expect(states.every((state) => state.sentence === '')).toBe(true);
  });

  test('gives a name that was chosen while it has no hub at its next try', () => {
    const connection = start();
    socket().end(1006);
    connection.rename('Grace');
    vi.advanceTimersByTime(6000);
    socket().open();
    expect(socket().sent[0]!.message.value).toMatchObject({ name: 'Grace' });
  });

  test('pings after the welcome and learns room time from the answer', () => {
    const connection = start();
    socket().open();
    socket().say({ case: 'welcome', value: {} });
    vi.advanceTimersByTime(2000);
    const pings = socket().sent.flatMap(({ message }) => (message.case === 'clockPing' ? [message.value] : []));
    expect(pings.length).toBeGreaterThanOrEqual(6);
    const hubNs = pings.at(-1)!.clientNs + 5_000_000_000n;
    socket().say({ case: 'clockPong', value: { clientNs: pings.at(-1)!.clientNs, hubNs } });
    const { offset_ms, error_ms } = connection.clock.estimate()!;
    expect(Math.abs(offset_ms - 5000)).toBeLessThanOrEqual(error_ms + 1e-3);
  });

  test('without an answer tries again, and reports that', () => {
    start();
    socket().end(1006);
    expect(sentence()).toBe('The hub at hub:7600 does not answer.');
    expect(states.at(-1)!.phase).toBe('waiting');
    vi.advanceTimersByTime(300);
    expect(FakeSocket.all.length).toBe(2);
    expect(states.at(-1)!.phase).toBe('connecting');
  });

  test('that breaks continues at the first other hub of the room that answers', () => {
    start();
    socket().open();
    socket().say({ case: 'welcome', value: { token: 'signed' } });
    socket().say({ case: 'otherHubs', value: { urls: ['ws://b:7600/ws', 'ws://c:7600'] } });
    socket().end(1006);
    expect(sentence()).toMatch(/hub:7600 is gone\. Continuing at another hub\.$/);
    vi.advanceTimersByTime(0);
    expect(FakeSocket.all.slice(1).map(({ url }) => url)).toEqual(['ws://b:7600/ws', 'ws://c:7600/ws']);
    FakeSocket.all[1]!.open();
    expect(FakeSocket.all[2]!.readyState).toBe(3);
    expect(FakeSocket.all[1]!.sent[0]!.message).toMatchObject({ case: 'join', value: { room: 'lab', token: 'signed' } });
    FakeSocket.all[1]!.say({ case: 'welcome', value: { viewerId: 2 } });
    expect(states.at(-1)!.phase).toBe('joined');
    FakeSocket.all[1]!.end(1006);
    vi.advanceTimersByTime(0);
    expect(FakeSocket.all.slice(3).map(({ url }) => url)).toEqual(['ws://hub:7600/ws', 'ws://c:7600/ws']);
  });

  test('follows the redirect of a busy hub, and says so in its Join', () => {
    start();
    socket().open();
    expect(socket().sent[0]!.message).toMatchObject({ case: 'join', value: { redirected: false } });
    socket().say({ case: 'otherHubs', value: { urls: ['ws://b:7600'] } });
    socket().say({ case: 'error', value: { code: ErrorCode.ERROR_BUSY, sentence: 'busy' } });
    socket().end(1013, 'busy');
    expect(sentence()).toBe('This hub is busy. Continuing at another hub.');
    vi.advanceTimersByTime(0);
    expect(FakeSocket.all[1]!.url).toBe('ws://b:7600/ws');
    FakeSocket.all[1]!.open();
    expect(FakeSocket.all[1]!.sent[0]!.message).toMatchObject({ case: 'join', value: { redirected: true } });
  });

  test('that breaks is made again', () => {
    start();
    socket().open();
    socket().say({ case: 'welcome', value: {} });
    socket().end(1006);
    expect(seen.at(-1)).toBe('disconnected');
    expect(sentence()).toMatch(/is gone/);
    vi.advanceTimersByTime(300);
    socket().open();
    socket().say({ case: 'welcome', value: { viewerId: 2 } });
    expect(seen.at(-1)).toBe('welcome 2');
  });

  test("passes the hub's last word on", () => {
    start();
    socket().open();
    socket().say({ case: 'error', value: { code: ErrorCode.ERROR_ROOM_FULL, sentence: 'full' } });
    socket().end(1008, 'full');
    expect(sentence()).toBe('The room is full.');
  });

  test('ends on bytes that are not roomcast, with the reason', () => {
    start();
    socket().open();
    const first = socket();
    first.sayBytes(Uint8Array.from([1, 2, 3, 4]));
    expect(first.closedWith).toBe(4000);
    expect(sentence()).toMatch(/cannot read: this is not a roomcast message/);
  });

  test('to another version asks for a reload', () => {
    start();
    socket().open();
    socket().sayBytes(Uint8Array.from([0x52, 0x43, 2, 2]));
    expect(states.at(-1)).toMatchObject({ phase: 'waiting', reload: true });
  });

  test('ends on text', () => {
    start();
    socket().open();
    socket().onmessage!({ data: 'hello' });
    expect(sentence()).toMatch(/sent text/);
  });

  test('that falls silent is given up after eight seconds', () => {
    start();
    socket().open();
    const first = socket();
    vi.advanceTimersByTime(7900);
    expect(first.closedWith).toBeUndefined();
    vi.advanceTimersByTime(2000);
    expect(first.closedWith).toBe(4000);
    expect(states.some((state) => state.sentence === 'The hub has gone silent.')).toBe(true);
  });

  test('that falls silent is left within a second where the room is at another hub, too', () => {
    const first = welcomedBesideAnother();
    vi.advanceTimersByTime(690);
    expect(first.closedWith).toBeUndefined();
    vi.advanceTimersByTime(210);
    expect(first.closedWith).toBe(4000);
    expect(socket().url).toBe('ws://b:7600/ws');
  });

  test('that is idle is pinged, and is not left while it answers', () => {
    vi.spyOn(Math, 'random').mockReturnValue(0.999); // the longest possible delay between pings
    const first = welcomedBesideAnother();
    const pings = () => first.sent.filter(({ message }) => message.case === 'clockPing').length;
    for (let answered = 0, step = 0; step < 100; ++step) {
      const asked = pings();
      vi.advanceTimersByTime(200); // time on the network
      for (; answered < asked; ++answered) first.say({ case: 'clockPong', value: {} });
    }
    expect(first.closedWith).toBeUndefined();
  });

  test('waits longer for answers from far away', () => {
    const first = welcomedBesideAnother();
    vi.advanceTimersByTime(600);
    first.say({ case: 'clockPong', value: { clientNs: BigInt(Math.round((performance.now() - 600) * 1e6)) } });
    vi.advanceTimersByTime(1290);
    expect(first.closedWith).toBeUndefined();
    vi.advanceTimersByTime(210);
    expect(first.closedWith).toBe(4000);
  });

  test('is not left by a page that was paused', () => {
    const first = welcomedBesideAnother();
    const woken_ms = performance.now() + 5000; // after a sleep: no timer ran, and no message was processed
    vi.spyOn(performance, 'now').mockReturnValue(woken_ms);
    vi.advanceTimersByTime(100);
    expect(first.closedWith).toBeUndefined();
  });
});
