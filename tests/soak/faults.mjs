// SPDX-License-Identifier: Apache-2.0
// The faults of a soak. Each is run alone, in a room that is well, and the room has to be well again soon after.
import { mkdirSync, rmSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { spawnSync } from 'node:child_process';
import { setTimeout as delay } from 'node:timers/promises';

import { ask, recordingReaches } from '../network/admin.mjs';
import { run } from '../cli/program.mjs';
import { noWallClocks } from '../network/wall_clock.mjs';

const longestSuspension_ms = 6_000;
const badNetworkFor_ms = 5_000;
const slowBytesPerSecond = 20_000;
const damagedShare = 0.02;
const fullDiskBytes = 400_000;
const fullDiskWithin_ms = 60_000;
const recordedFor_ms = 3_000;
const stateWithin_ms = 10_000;
const jumps_s = [3_600, -3_600, 0]; // of the clocks of hub and sensor
const betweenJumps_ms = 2_000;
const tokensPerJump = 10; // few: a growing database fills SQLite's cache, which looks like a leak for a while

/**
 * [{name, run(soak), early}]; `early` faults happen in the first half only, so that memory can be compared over the
 * second half.
 */
export const faults = [
  { name: 'hub killed', early: true, run: ({ hub, pledges }) => pledges.outlive(() => hub.end('SIGKILL')) },
  { name: 'first sensor killed', early: true, run: ({ sensors }) => sensors[0].end('SIGKILL') },
  { name: 'second sensor killed', run: ({ sensors }) => sensors[1].end('SIGKILL') },
  { name: 'viewer killed', run: ({ viewer }) => viewer.end('SIGKILL') },
  { name: 'recorder killed', run: (soak) => endRecorder(soak, 'SIGKILL') },
  { name: 'recording ended', run: (soak) => endRecorder(soak, 'SIGINT') },
  { name: 'hub suspended', run: ({ hub, random }) => suspend(hub, random) },
  { name: 'sensor suspended', run: ({ sensors, random }) => suspend(sensors[1], random) },
  { name: 'recorder suspended', run: ({ recorder, random }) => suspend(recorder, random) },
  { name: "hub's log reader gone", run: ({ hub }) => hub.closeStderr() },
  { name: "sensor's log reader gone", run: ({ sensors }) => sensors[1].closeStderr() },
  { name: 'network slow', run: (soak) => worsen(soak, { bytesPerSecond: slowBytesPerSecond }) },
  { name: 'network damages', run: damage },
  { name: 'network cut', run: ({ network }) => network.cut() },
  { name: 'hub records', run: recordByHub },
  { name: 'clocks set', run: setClocks, isPossible: () => noWallClocks === false },
  { name: 'disk full', run: fillDisk, isPossible: canMount },
];

async function endRecorder({ recorder, recordings, witness, recorderFile }, signal) {
  const file = recorderFile();
  const lastFrameAt_ms = witness.lastFrameAt_ms;
  await recorder.end(signal);
  await recordings.check(file, { wasKilled: signal === 'SIGKILL', lastFrameAt_ms });
}

async function suspend(program, random) {
  program.signal('SIGSTOP');
  await delay(random() * longestSuspension_ms);
  program.signal('SIGCONT');
}

async function worsen({ network }, how) {
  const before = { bytesPerSecond: network.bytesPerSecond, damagedShare: network.damagedShare };
  Object.assign(network, how);
  await delay(badNetworkFor_ms);
  Object.assign(network, before);
}

/** What the hub reads then may be anything, also a refusal's reason, so the sensor behind the network may end. */
async function damage(soak) {
  soak.sensors[1].mayEnd(true);
  await worsen(soak, { damagedShare });
  soak.network.cut();
}

async function recordByHub({ port, admin, recordings, witness, onFinding }) {
  const reaches = (wanted) =>
    recordingReaches(port, admin, 'room', ({ state }) => state === wanted, stateWithin_ms).catch((error) =>
      onFinding(`not ${wanted}: ${error.message}`),
    );
  await ask(port, admin, 'POST', '/rooms/room/recording');
  if (!(await reaches('on'))) return;
  await delay(recordedFor_ms);
  const lastFrameAt_ms = witness.lastFrameAt_ms;
  await ask(port, admin, 'DELETE', '/rooms/room/recording');
  const ended = await reaches('off');
  if (ended) await recordings.check(ended.file, { wasKilled: false, lastFrameAt_ms });
}

/**
 * The clocks of hub and first sensor are set forwards, backwards, and right again. The viewer who watches all this is not
 * disconnected, frames go on, and tokens that were made meanwhile are in the hub's list.
 */
async function setClocks({ clocks, witness, pledges, onFinding }) {
  const { disconnections } = witness;
  for (const jump_s of jumps_s) {
    await pledges.outlive(async () => {
      clocks.forEach((clock) => clock.set(jump_s));
      await delay(betweenJumps_ms);
    }, { most: tokensPerJump, staysThere: true });
    if (Date.now() - witness.lastFrameAt_ms > betweenJumps_ms) onFinding(`no frame after clocks were set ${jump_s} s ahead`);
  }
  if (witness.disconnections > disconnections) onFinding('the witness was disconnected when clocks were set');
}

function canMount() {
  return process.getuid() === 0 && spawnSync('mount', ['--version']).status === 0;
}

/** A second recorder fills a small disk: it ends with 1 and a sentence, and its file can be read. */
async function fillDisk({ url, folder, onFinding }) {
  const disk = join(folder, 'disk');
  mkdirSync(disk, { recursive: true });
  if (spawnSync('mount', ['-t', 'tmpfs', '-o', `size=${fullDiskBytes}`, 'tmpfs', disk]).status !== 0) return 'skipped';
  try {
    const file = join(disk, 'full.mcap');
    const { code, stderr } = await run('record', file, '--hub', url, { limitMs: fullDiskWithin_ms });
    if (code !== 1 || stderr.trim().split('\n').length !== 1) onFinding(`record on a full disk: ${code}, ${stderr.trim()}`);
    if (statSync(file).size === 0) onFinding('record on a full disk left an empty file');
    const info = await run('info', file, '--json');
    if (info.code !== 0) onFinding(`info of a full disk's recording: ${info.code}, ${info.stderr.trim()}`);
  } finally {
    spawnSync('umount', [disk]);
    rmSync(disk, { recursive: true, force: true });
  }
}
