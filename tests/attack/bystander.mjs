// SPDX-License-Identifier: Apache-2.0
// A hub that hostile programs may talk to during an attack, and that others still use afterwards.
import assert from 'node:assert/strict';

import { Program, scratchFolder } from '../cli/program.mjs';
import { RoomClient } from '../network/room_client.mjs';
import { startSensor } from '../network/rooms.mjs';
import { timeout } from './attacker.mjs';

export class BystandingHub {
  static async start(t) {
    const args = ['hub', '--listen', '127.0.0.1:0', '--data', scratchFolder(t)];
    const program = new Program(args, { limitMs: timeout.timeout });
    t.after(() => program.stop('SIGKILL'));
    return new BystandingHub(program, `ws://127.0.0.1:${await program.port()}`);
  }

  constructor(program, url) {
    Object.assign(this, { program, url });
  }

  /** A sensor joins, a viewer sees its frames, and the hub ends when it is asked to. */
  async assertServes(t, rig) {
    assert.equal(this.program.child.exitCode, null, `the hub is up: ${this.program.stderr}`);
    await startSensor(t, this.url, rig, 1);
    const viewer = await RoomClient.join(t, this.url, { name: 'honest' });
    await viewer.until('frames', () => viewer.sensor('s1') && viewer.seqsOf(viewer.sensor('s1').id).length > 5);
    assert.equal(await this.program.stop('SIGTERM'), 0);
  }
}
