// SPDX-License-Identifier: Apache-2.0
// Cameras from the command line: the list, refused options, the printed board, and a user's own camera.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';

import { writeSmallRig } from '../network/small_rig.mjs';
import { assertFailed, binary, Program, run, scratchFolder, startHub } from './program.mjs';

test('devices_lists_every_kind_of_camera_and_whether_it_is_built_in', async () => {
  const { code, stdout } = await run('devices', '--json');
  assert.equal(code, 0);
  const { devices, kinds } = JSON.parse(stdout);
  assert.ok(Array.isArray(devices));
  assert.deepEqual(
    kinds.map(({ kind }) => kind),
    ['freenect', 'openni2', 'realsense', 'freenect2', 'k4a'],
  );
  for (const { built_in: builtIn, problem, library } of kinds)
    if (!builtIn) assert.match(problem, new RegExp(`built without ${library}`));
});

test('devices_prints_a_readable_list', async () => {
  const { code, stdout } = await run('devices');
  assert.equal(code, 0);
  assert.match(stdout, /Kinect v1/);
});

const hub = ['--hub', 'ws://127.0.0.1:1'];
const refusals = {
  delay_without_the_secondary_role: [['--trigger-delay-us', '160'], 2, /secondary/],
  exposure_of_a_recording_of_a_camera_that_is_not_there: [['--lock-exposure'], 1, /was found|built without|USB/],
};
for (const [name, [options, expected, sentence]] of Object.entries(refusals)) {
  test(`sensor_refuses: ${name}`, async () => {
    assertFailed(await run('sensor', '--source', 'openni2:', ...hub, ...options), expected, sentence);
  });
}

test('a_board_to_calibrate_with_is_a_pdf_file', async (t) => {
  const file = join(scratchFolder(t), 'board.pdf');
  const { code, stdout } = await run('calibrate', '--print', file, '--paper', 'a4');
  assert.equal(code, 0);
  assert.match(stdout, /36 mm/);
  assert.match(readFileSync(file, 'latin1'), /^%PDF-1\.4/);
});

test('calibrate_without_a_board_in_sight_says_so', { timeout: 30_000 }, async (t) => {
  const folder = scratchFolder(t);
  const rig = writeSmallRig(folder);
  const result = await run('calibrate', '--source', `rig:${rig}#s0`, '--out', join(folder, 'out'));
  assertFailed(result, 1, /seen 0 times/);
});

const example = join(dirname(binary), 'third_party_camera');
const pixels = 320 * 240;

function pictures(count) {
  const depth = new Uint16Array(pixels).fill(1234);
  const color = new Uint8Array(3 * pixels).map((_, i) => [10, 20, 30][i % 3]);
  const frame = Buffer.concat([Buffer.from(depth.buffer), Buffer.from(color)]);
  return Buffer.concat(Array(count).fill(frame));
}

test('a_program_with_its_own_camera_is_seen', async () => {
  const program = spawn(example, { stdio: ['pipe', 'pipe', 'inherit'] });
  let said = '';
  program.stdout.setEncoding('utf8').on('data', (text) => (said += text));
  program.stdin.end(pictures(3));
  const [code] = await once(program, 'close');
  assert.equal(code, 0);
  assert.match(said, /in the middle 1234 mm, red 10 green 20 blue 30/);
});

test('a_sensor_writes_a_preview_file', async (t) => {
  const { url } = await startHub(t);
  const preview = join(scratchFolder(t), 'now.jpg');
  const sensor = new Program(['sensor', '--source', 'sim', '--hub', url, '--verbose', '--preview', preview]);
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  while (!existsSync(preview)) await new Promise((resolve) => setTimeout(resolve, 50));
  assert.equal(readFileSync(preview).readUInt16BE(0), 0xffd8, 'a JPEG file');
});

test('a_calibration_of_another_camera_is_refused', async (t) => {
  const file = join(scratchFolder(t), 'camera.json');
  writeFileSync(file, JSON.stringify({ depth: { width: 32, height: 24, fx: 30, fy: 30, cx: 15.5, cy: 11.5 } }));
  assertFailed(await run('sensor', '--source', 'sim', '--calibration', file, ...hub), 2, /32x24/);
});
