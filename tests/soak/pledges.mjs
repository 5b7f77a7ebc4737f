// SPDX-License-Identifier: Apache-2.0
// Writes that the hub has acknowledged: after it was killed they are all there.
import { setTimeout as delay } from 'node:timers/promises';

import { ask } from '../network/admin.mjs';

const mostTokens = 100; // of one kill
const longestWriting_ms = 200;

export class Pledges {
  acknowledged = 0;
  lost = 0;
  #ids = [];

  constructor(port, admin, { random, onFinding }) {
    Object.assign(this, { port, admin, random, onFinding });
  }

  /**
   * Admins write up to `most` tokens while `kill` is run; what was acknowledged is looked for when the hub is back.
   * `staysThere`: nothing kills the hub, so each request is answered.
   */
  async outlive(kill, { most = mostTokens, staysThere = false } = {}) {
    const writing = this.#writeUntilRefused(most, staysThere);
    await delay(this.random() * longestWriting_ms);
    await kill();
    await writing;
    this.isOpen = true;
  }

  /** Each token can be revoked, so the hub knows it; the list has only the newest ones by the hub's clock. */
  async check() {
    if (!this.isOpen) return;
    this.isOpen = false;
    const ids = this.#ids.splice(0);
    let lost = 0;
    for (const id of ids) {
      const { status } = await ask(this.port, this.admin, 'DELETE', `/tokens/${id}`);
      if (status !== 204) ++lost;
    }
    this.lost += lost;
    if (lost > 0) this.onFinding(`${lost} of ${ids.length} acknowledged tokens are lost`);
  }

  async #writeUntilRefused(most, staysThere) {
    for (let i = 0; i < most; ++i) {
      try {
        const wanted = { room: 'room', role: 'viewer', ttl_s: 60 };
        const { status, body } = await ask(this.port, this.admin, 'POST', '/tokens', wanted);
        if (status !== 201) return this.onFinding(`a token was refused: HTTP ${status}`);
        this.#ids.push(body.id);
        ++this.acknowledged;
      } catch (error) {
        if (staysThere) this.onFinding(`a token's request was not answered: ${error.message}`);
        return; // the hub is gone
      }
    }
  }
}
