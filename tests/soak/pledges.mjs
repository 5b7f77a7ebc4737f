// SPDX-License-Identifier: Apache-2.0
// Writes that the hub has acknowledged: after it was killed they are all there.
import { setTimeout as delay } from 'node:timers/promises';

import { ask } from '../network/admin.mjs';

const keptTokens = 100; // the hub lists at most 1000
const longestWriting_ms = 200;

export class Pledges {
  acknowledged = 0;
  lost = 0;
  #ids = [];

  constructor(port, admin, { random, onFinding }) {
    Object.assign(this, { port, admin, random, onFinding });
  }

  /** Admins write while `kill` is run; what was acknowledged is looked for as soon as the hub is back. */
  async outlive(kill) {
    const writing = this.#writeUntilRefused();
    await delay(this.random() * longestWriting_ms);
    await kill();
    await writing;
    this.isOpen = true;
  }

  async check() {
    if (!this.isOpen) return;
    this.isOpen = false;
    const { status, body } = await ask(this.port, this.admin, 'GET', '/tokens');
    if (status !== 200) return this.onFinding(`the list of tokens: HTTP ${status}`);
    const there = new Set(body.tokens.map(({ id }) => id));
    const lost = this.#ids.filter((id) => !there.has(id));
    this.lost += lost.length;
    if (lost.length > 0) this.onFinding(`${lost.length} acknowledged tokens are lost`);
    this.#ids = this.#ids.slice(-keptTokens);
  }

  async #writeUntilRefused() {
    for (let i = 0; i < keptTokens; ++i) {
      try {
        const wanted = { room: 'room', role: 'viewer', ttl_s: 60 };
        const { status, body } = await ask(this.port, this.admin, 'POST', '/tokens', wanted);
        if (status !== 201) return this.onFinding(`a token was refused: HTTP ${status}`);
        this.#ids.push(body.id);
        ++this.acknowledged;
      } catch {
        return; // the hub is gone
      }
    }
  }
}
