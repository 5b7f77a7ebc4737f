// SPDX-License-Identifier: Apache-2.0
// The time of day as a program sees it, which jumps when it is told to, as on a machine whose clock is set. Debian's
// libfaketime provides it; the monotonic clock and the times of files stay as they are.
import { existsSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const sharedMemory = '/dev/shm';
const library = '/usr/lib/x86_64-linux-gnu/faketime/libfaketimeMT.so.1';

/** Why clocks cannot be set here, or false. */
export const noWallClocks = existsSync(library) ? false : 'the package faketime is not installed';

/** What the library leaves behind of programs that were killed. */
function removeLeftovers() {
  for (const name of readdirSync(sharedMemory)) {
    const [, pid] = /^(?:sem\.)?faketime_(?:shm|sem)_(\d+)$/.exec(name) ?? [];
    if (pid && !existsSync(`/proc/${pid}`)) rmSync(join(sharedMemory, name), { force: true });
  }
}
if (!noWallClocks) process.on('exit', removeLeftovers);

export class WallClock {
  /** Keeps its state in `folder`. */
  constructor(folder) {
    this.file = join(folder, `wall_clock_${Math.random().toString(36).slice(2)}`);
    this.set(0);
    /** For the programs that have this clock. */
    this.environment = {
      LD_PRELOAD: library,
      FAKETIME_TIMESTAMP_FILE: this.file,
      FAKETIME_NO_CACHE: '1',
      FAKETIME_DONT_FAKE_MONOTONIC: '1',
      NO_FAKE_STAT: '1',
    };
  }

  /** From now on it is `ahead_s` ahead of the true time, or behind it. In one step: a program reads the whole file. */
  set(ahead_s) {
    const next = `${this.file}.next`;
    writeFileSync(next, `${ahead_s < 0 ? '' : '+'}${ahead_s}\n`);
    renameSync(next, this.file);
  }
}
