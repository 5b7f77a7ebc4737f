// SPDX-License-Identifier: Apache-2.0
// A client of the hub that shares no code with roomcast: npm's `ws` carries the messages, messages.mjs parses them. It
// keeps all received messages, so that a test can check the history of a room.
import { once } from 'node:events';

import { readMessage, writeClockPing, writeFrame, writeJoin } from './messages.mjs';
import { WebSocket } from './npm.mjs';

const answerWithin_ms = 20_000;

export class RoomClient {
  sets = []; // {id, at_ms, frames: [header...]}, oldest first
  rosters = [];
  errors = [];
  heads = []; // other viewers' head poses in the last message
  places = new Map(); // last head position of each viewer, by id
  otherHubs = []; // addresses of other hubs with this room
  welcome = null;
  #changed = [];

  /** Connects, without joining. `options` are those of ws. */
  static async open(t, url, options = {}) {
    const socket = new WebSocket(`${url}/ws`, 'roomcast.v1', { perMessageDeflate: false, ...options });
    t.after(() => socket.terminate());
    const client = new RoomClient(socket);
    await once(socket, 'open');
    return client;
  }

  /** Joins as a viewer, as a sensor if `sensor` is given, or as an aligner; waits for the welcome. */
  static async join(t, url, { room, name = 'test', sensor, aligner, token, code, options } = {}) {
    const client = await RoomClient.open(t, url, options);
    client.send(writeJoin({ room, name, sensor, aligner, token, code }));
    await client.until('the welcome', () => client.welcome);
    return client;
  }

  constructor(socket) {
    this.socket = socket;
    socket.binaryType = 'nodebuffer';
    socket.on('message', (bytes, isBinary) => this.#take(bytes, isBinary));
    socket.on('error', () => {}); // the close event is handled instead
    this.closed = new Promise((resolve) => {
      socket.on('close', (code, reason) => resolve({ code, reason: reason.toString('utf8') }));
    });
    this.closed.then((end) => {
      this.end = end;
      this.#tellWaiters();
    });
  }

  send(message) {
    this.socket.send(message);
  }

  /** The sensor's entry in the newest roster. */
  sensor(name) {
    return this.rosters.at(-1)?.sensors.find((sensor) => sensor.name === name);
  }

  /** The viewer's entry in the newest roster; the viewer may be at another hub. */
  person(name) {
    return this.rosters.at(-1)?.people.find((person) => person.name === name);
  }

  /** The viewer's last head position. */
  placeOf(name) {
    return this.places.get(this.person(name)?.id);
  }

  /** Sequence numbers of a sensor's frames, in order of arrival. */
  seqsOf(sensor) {
    return this.sets.flatMap(({ frames }) => frames.filter((frame) => frame.sensor === sensor).map(({ seq }) => seq));
  }

  /** Resolves to the result of `done` once that is true; calls `done` after every message. */
  async until(what, done, within_ms = answerWithin_ms) {
    const deadline = Date.now() + within_ms;
    for (;;) {
      const answer = done();
      if (answer) return answer;
      if (this.end) throw new Error(`${what}: the hub hung up (${this.end.code}: ${this.end.reason})`);
      if (Date.now() >= deadline) throw new Error(`${what}: not within ${within_ms} ms; ${this.summary()}`);
      await this.#change(deadline - Date.now());
    }
  }

  /** Waits until `count` more sets have begun. */
  async moreSets(count) {
    const wanted = this.sets.length + count;
    await this.until(`${count} more sets`, () => this.sets.length >= wanted);
  }

  /** Room time minus this program's process.hrtime, from one ping. */
  async askTime() {
    const sentNs = process.hrtime.bigint();
    this.pong = null;
    this.send(writeClockPing(sentNs));
    await this.until('the time', () => this.pong);
    return this.pong.hubNs - (sentNs + process.hrtime.bigint()) / 2n;
  }

  summary() {
    const sensors = this.rosters.at(-1)?.sensors.map(({ name, online }) => `${name}${online ? '' : ' (offline)'}`);
    return `${this.sets.length} sets, sensors: ${sensors?.join(', ') || 'none'}`;
  }

  #take(bytes, isBinary) {
    if (!isBinary) throw new Error('the hub sent text');
    const { frame, control } = readMessage(bytes);
    if (frame) this.#takeFrame(frame);
    else if (control.case === 'welcome') this.welcome = control;
    else if (control.case === 'roster') this.rosters.push(control);
    else if (control.case === 'clockPong') this.pong = control;
    else if (control.case === 'viewerPoses') this.#takePoses(control);
    else if (control.case === 'otherHubs') this.otherHubs = control.urls;
    else if (control.case === 'error') this.errors.push(control);
    this.#tellWaiters();
  }

  #takePoses({ heads, ids }) {
    this.heads = heads;
    ids.forEach((id, i) => this.places.set(id, heads[i]));
  }

  #takeFrame(frame) {
    if (this.sets.at(-1)?.id !== frame.set) this.sets.push({ id: frame.set, at_ms: performance.now(), frames: [] });
    this.sets.at(-1).frames.push(frame);
  }

  #change(within_ms) {
    return new Promise((resolve) => {
      const timer = setTimeout(resolve, within_ms);
      this.#changed.push(() => (clearTimeout(timer), resolve()));
    });
  }

  #tellWaiters() {
    this.#changed.splice(0).forEach((tell) => tell());
  }
}

/**
 * A sensor with arbitrary frame payloads; it sends `rate` frames a second, whatever it has announced, until the test
 * ends.
 */
export class SendingSensor {
  sent = 0;

  static async start(t, url, { room, name, fps, worldFromDepth, rate = fps, payloadBytes = 2000, token, options }) {
    const client = await RoomClient.join(t, url, { room, name, sensor: { fps, worldFromDepth }, token, options });
    return new SendingSensor(t, client, { rate, payloadBytes, roomMinusHostNs: await client.askTime() });
  }

  constructor(t, client, { rate, payloadBytes, roomMinusHostNs }) {
    this.client = client;
    this.payload = Buffer.alloc(payloadBytes, 0x5a);
    this.roomMinusHostNs = roomMinusHostNs;
    const began_ms = performance.now();
    const timer = setInterval(() => {
      while (this.sent < ((performance.now() - began_ms) * rate) / 1000) this.#sendOne();
    }, 2);
    t.after(() => clearInterval(timer));
    client.closed.then(() => clearInterval(timer));
  }

  #sendOne() {
    const captureNs = process.hrtime.bigint() + this.roomMinusHostNs;
    this.client.send(
      writeFrame({ sensor: this.client.welcome.sensorId, seq: this.sent++, captureNs, payload: this.payload }),
    );
  }
}
