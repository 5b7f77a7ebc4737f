// SPDX-License-Identifier: Apache-2.0
// A TCP proxy that is slow, damages bytes, or cuts connections when it is told to.
import { once } from 'node:events';
import { connect, createServer } from 'node:net';
import { setTimeout as delay } from 'node:timers/promises';

export class BadNetwork {
  bytesPerSecond = Infinity;
  damagedShare = 0; // of the chunks that arrive
  #pairs = new Set();

  static async start(targetPort, random) {
    const network = new BadNetwork(targetPort, random);
    network.server.listen(0, '127.0.0.1');
    await once(network.server, 'listening');
    return network;
  }

  constructor(targetPort, random) {
    this.random = random;
    this.server = createServer((near) => this.#join(near, connect(targetPort, '127.0.0.1')));
  }

  get port() {
    return this.server.address().port;
  }

  /** All open connections end with a reset. */
  cut() {
    for (const sockets of this.#pairs) sockets.forEach((socket) => socket.resetAndDestroy());
  }

  close() {
    this.cut();
    this.server.close();
  }

  #join(near, far) {
    const pair = [near, far];
    this.#pairs.add(pair);
    const end = () => {
      this.#pairs.delete(pair);
      pair.forEach((socket) => socket.destroy());
    };
    pair.forEach((socket) => socket.setNoDelay(true).on('error', end).on('close', end));
    this.#forward(near, far).catch(end);
    this.#forward(far, near).catch(end);
  }

  async #forward(from, to) {
    for await (const bytes of from) {
      if (this.random() < this.damagedShare) bytes[Math.floor(this.random() * bytes.length)] ^= 0x55;
      if (this.bytesPerSecond < Infinity) await delay((1000 * bytes.length) / this.bytesPerSecond);
      if (!to.write(bytes)) await once(to, 'drain');
    }
    to.end();
  }
}
