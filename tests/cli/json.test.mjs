// SPDX-License-Identifier: Apache-2.0
// With --json stdout is one JSON object, also when the command fails: `error` has a code and the sentence of stderr.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { Program, run, scratchFolder, startHub, startSensor } from './program.mjs';

const nobody = ['--hub', 'ws://127.0.0.1:1'];

/** name: [arguments, exit code, error code] */
const failures = {
  unknown_command: [['fly'], 2, 'invalid_argument'],
  unknown_option: [['info', '/tmp', '--altitude', '3'], 2, 'invalid_argument'],
  missing_argument: [['export'], 2, 'invalid_argument'],
  info: [['info', '/nowhere'], 1, 'not_found'],
  export: [['export', '/nowhere', '--out', '/tmp/never'], 1, 'not_found'],
  export_option: [['export', '/nowhere', '--out', '/tmp/never', '--up', 'z'], 2, 'invalid_argument'],
  import: [['import', '/nowhere', '/tmp/never'], 1, 'not_found'],
  measure: [['measure', '/nowhere', '--floor-plan', '/tmp/never.svg'], 1, 'not_found'],
  measure_option: [['measure', '/nowhere'], 2, 'invalid_argument'],
  align: [['align', '/nowhere'], 1, 'not_found'],
  play: [['play', '/nowhere.mcap'], 1, 'not_found'],
  record: [['record', '/tmp/never.mcap', ...nobody], 1, 'unavailable'],
  view: [['view', '--png', '/tmp/never.png', ...nobody], 1, 'unavailable'],
  sensor: [['sensor', '--source', 'sim', ...nobody], 1, 'unavailable'],
  foxglove: [['foxglove', '--port', '0', ...nobody], 1, 'unavailable'],
  ros2: [['ros2', ...nobody], 1, 'unavailable'],
  doctor: [['doctor', '--hub', 'ftp://x'], 2, 'invalid_argument'],
  bench: [['bench', 'codec', 'tum:/nowhere'], 1, 'not_found'],
};

function assertJsonError({ code, stdout, stderr }, exitCode, errorCode) {
  assert.equal(code, exitCode, stderr);
  const report = JSON.parse(stdout); // one object, and nothing else
  const lines = stderr.trimEnd().split('\n');
  assert.deepEqual(report.error, { code: errorCode, sentence: lines.at(-1).replace(/^roomcast[^:]*: /, '') });
  return report;
}

for (const [name, [args, exitCode, errorCode]] of Object.entries(failures)) {
  test(`a_failure_is_an_object: ${name}`, async () => {
    assertJsonError(await run(...args, '--json'), exitCode, errorCode);
  });
}

test('without_json_stdout_stays_empty', async () => {
  const { code, stdout } = await run('info', '/nowhere');
  assert.deepEqual([code, stdout], [1, '']);
});

test('a_failure_after_a_report_is_in_the_report', async (t) => {
  const folder = join(scratchFolder(t), 'pictures');
  mkdirSync(join(folder, 'depth'), { recursive: true });
  writeFileSync(join(folder, 'depth/0.png'), 'no picture');
  const camera = 'depth_camera = {width = 64, height = 48, fx = 60, fy = 60, cx = 31.5, cy = 23.5}';
  writeFileSync(join(folder, 'recording.toml'), `[[sensor]]\nname = "a"\ndepth = "depth"\nfps = 10\n${camera}\n`);
  const result = await run('import', folder, join(scratchFolder(t), 'rig'), '--json');
  assert.notEqual(result.code, 0);
  assert.equal(typeof JSON.parse(result.stdout).error.sentence, 'string', result.stdout);
});

test('a_recording_that_ends_badly_is_reported_with_its_error', async (t) => {
  const hub = await startHub(t);
  await startSensor(t, hub);
  const file = join(scratchFolder(t), 'a.mcap');
  const record = new Program(['record', file, '--hub', hub.url, '--json'], { through: ['/bin/sh', '-c', 'ulimit -f 64; exec "$@"', 'sh'] });
  const code = await record.ended;
  const report = JSON.parse(record.stdout);
  assert.equal(code, 1, record.stderr);
  assert.ok(report.rooms[0].file_bytes > 0);
  assert.match(report.error.sentence, /a\.mcap/);
});

test('a_played_recording_prints_nothing_but_json', async (t) => {
  const hub = await startHub(t);
  await startSensor(t, hub);
  const file = join(scratchFolder(t), 'a.mcap');
  assert.equal((await run('record', file, '--hub', hub.url, '--seconds', '1')).code, 0);
  const { code, stdout, stderr } = await run('play', file, '--port', '0', '--speed', '10', '--json');
  assert.equal(code, 0, stderr);
  assert.ok(JSON.parse(stdout).frames_sent > 0);
  assert.match(stderr, /open http:/);
});
