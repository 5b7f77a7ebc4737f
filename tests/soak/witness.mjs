// SPDX-License-Identifier: Apache-2.0
// A viewer that shares no code with roomcast and joins again whenever it is disconnected. It knows when each sensor's
// last frame came.
import { setTimeout as delay } from 'node:timers/promises';

import { RoomClient } from '../network/room_client.mjs';

const triesAgainAfter_ms = 100;
const keptSets = 100;
const fresh_ms = 1500;

export class Witness {
  lastFrameAt_ms = 0; // Date.now() of the newest frame of any sensor
  framesSeen = 0;
  disconnections = 0;
  #lastOf = new Map(); // sensor's name -> Date.now()
  #ended = false;

  constructor(url) {
    this.url = url;
    this.done = this.#watch();
  }

  /** Whether frames of all these sensors have come within the last moments. */
  sees(names) {
    return names.every((name) => Date.now() - (this.#lastOf.get(name) ?? 0) < fresh_ms);
  }

  /** Forgets what it saw, so that sees() is about frames from now on. */
  forget() {
    this.#lastOf.clear();
  }

  /** The names of the people in the room, at this moment. */
  people() {
    return this.client?.rosters.at(-1)?.people.map(({ name }) => name) ?? [];
  }

  async end() {
    this.#ended = true;
    this.client?.socket.terminate();
    await this.done;
  }

  async #watch() {
    while (!this.#ended) {
      const cleanups = [];
      try {
        this.client = await RoomClient.join({ after: (cleanup) => cleanups.push(cleanup) }, this.url, { name: 'witness' });
        this.client.socket.on('message', () => this.#look());
        await this.client.closed;
        ++this.disconnections;
      } catch {
        // no hub just now
      }
      this.client = undefined;
      cleanups.forEach((cleanup) => cleanup());
      await delay(triesAgainAfter_ms);
    }
  }

  #look() {
    const { client } = this;
    const set = client?.sets.at(-1);
    const frame = set?.frames.at(-1);
    if (!frame || frame === this.newest) return;
    this.newest = frame;
    ++this.framesSeen;
    this.lastFrameAt_ms = Date.now();
    const sensor = client.rosters.at(-1)?.sensors.find(({ id }) => id === frame.sensor);
    if (sensor) this.#lastOf.set(sensor.name, this.lastFrameAt_ms);
    if (client.sets.length > keptSets) client.sets.splice(0, keptSets / 2);
    if (client.rosters.length > keptSets) client.rosters.splice(0, keptSets / 2);
  }
}
