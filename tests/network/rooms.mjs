// SPDX-License-Identifier: Apache-2.0
// Starts rooms of real programs, and checks what a viewer has received of a room.
import assert from 'node:assert/strict';

import { Program } from '../cli/program.mjs';

/**
 * Plays recorded sensor number `n` of the rig in folder `rig` in a loop; waits until it has joined (as "s0" for number
 * 0).
 */
export async function startSensor(t, url, rig, n, options) {
  const sensor = new Program(['sensor', '--source', `rig:${rig}#s${n}`, '--hub', url, '--wait', '--verbose'], options);
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  return sensor;
}

function assertConsecutive(numbers, what) {
  const gap = numbers.findIndex((number, i) => i > 0 && number !== numbers[i - 1] + 1);
  assert.equal(gap, -1, `${what}: ${numbers[gap]} follows ${numbers[gap - 1]}`);
}

/** Asserts that every set arrived complete and in order, and contained every frame of these sensors. */
export function assertMissedNothing(client, sensorIds) {
  assertConsecutive(client.sets.map(({ id }) => id), 'sets');
  for (const sensor of sensorIds) {
    const seqs = client.seqsOf(sensor);
    assert.ok(seqs.length > 0, `sensor ${sensor} sent something`);
    assertConsecutive(seqs, `frames of sensor ${sensor}`);
  }
  for (const { id, frames } of client.sets.slice(1, -1)) {
    assert.equal(frames.filter(({ last }) => last).length, 1, `set ${id} ends once`);
    assert.ok(frames.at(-1).last, `set ${id} ends with its last frame`);
  }
}

/** The longest time between two sets. */
export function longestPause_ms(client) {
  return Math.max(...client.sets.slice(1).map(({ at_ms }, i) => at_ms - client.sets[i].at_ms));
}
