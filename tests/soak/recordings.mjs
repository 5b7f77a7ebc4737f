// SPDX-License-Identifier: Apache-2.0
// Reads what a recorder has left, with the MCAP format's own library and with `roomcast info`.
import { rmSync } from 'node:fs';

import { isFrame, readFromStart } from '../cli/mcap.mjs';
import { run } from '../cli/program.mjs';

const infoWithin_ms = 120_000;

/** Checks recordings and counts them. */
export class Recordings {
  finished = 0;
  killed = 0;
  worstLoss_s = 0;

  constructor(onFinding, mostLoss_s) {
    this.onFinding = onFinding;
    this.mostLoss_s = mostLoss_s;
  }

  /**
   * The recorder of this file ended; the room's last frame before its end came at `lastFrameAt_ms` (Date.now()). A file
   * that is whole is deleted; one with a finding is kept.
   */
  async check(file, { wasKilled, lastFrameAt_ms }) {
    wasKilled ? ++this.killed : ++this.finished;
    const findings = [];
    try {
      const { messages, whole } = await readFromStart(file);
      if (!wasKilled && !whole) findings.push('has no end');
      const last = messages.filter(isFrame).at(-1);
      const loss_s = last ? (lastFrameAt_ms - Number(last.logTime / 1_000_000n)) / 1000 : Infinity;
      this.worstLoss_s = Math.max(this.worstLoss_s, loss_s);
      if (loss_s > this.mostLoss_s) findings.push(`lacks its last ${loss_s.toFixed(2)} s`);
    } catch (error) {
      findings.push(`cannot be read: ${error.message}`);
    }
    const info = await run('info', file, '--json', { limitMs: infoWithin_ms });
    if (info.code !== 0) findings.push(`is refused by info (${info.code}): ${info.stderr.trim()}`);
    if (findings.length === 0) return rmSync(file, { force: true });
    this.onFinding(`recording ${file} (${wasKilled ? 'killed' : 'finished'}) ${findings.join('; ')}`);
  }
}
