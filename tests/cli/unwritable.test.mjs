// SPDX-License-Identifier: Apache-2.0
// Programs whose stdout or stderr cannot be written: closed, a full disk (/dev/full), a pipe whose reader has gone. They
// go on or end with their usual code; none is ended by a signal.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { openSync, closeSync, readFileSync } from 'node:fs';
import { request } from 'node:http';
import { join } from 'node:path';
import { test } from 'node:test';

import { env } from '../state_folder.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { Program, binary, run, scratchFolder, startHub } from './program.mjs';

/** Runs a program to its end with these redirections of a shell; returns its exit code, or its signal. */
async function runIn(shell, ...args) {
  const program = spawn('sh', ['-c', `exec "$0" "$@" ${shell}`, binary, ...args], { env, stdio: ['ignore', 'pipe', 'ignore'] });
  program.stdout.resume();
  const limit = setTimeout(() => program.kill('SIGKILL'), 30_000);
  const [code, signal] = await once(program, 'close');
  clearTimeout(limit);
  return code ?? signal;
}

const failing = {
  info: [['info', '/nowhere.mcap'], 1],
  token: [['token', '--list', '--data', '/nowhere'], 1],
  view: [['view', '--hub', 'ws://127.0.0.1:1', '--png', '/tmp/no.png'], 1],
  sensor: [['sensor', '--source', 'crystal:ball', '--hub', 'ws://127.0.0.1:1'], 2],
  record: [['record', '/nowhere/x.mcap', '--hub', 'ws://127.0.0.1:1'], 1],
  play: [['play', '/nowhere.mcap'], 1],
  hub: [['hub', '--check', '--config', '/nowhere.toml'], 1],
  unknown_command: [['fly'], 2],
};
for (const [name, [args, code]] of Object.entries(failing)) {
  for (const shell of ['2>&-', '2>/dev/full']) {
    test(`a_failure_that_nobody_can_read_keeps_its_exit_code: ${name} ${shell}`, async () => {
      assert.equal(await runIn(shell, ...args), code);
    });
  }
}

for (const shell of ['>&-', '>/dev/full']) {
  test(`results_that_cannot_be_written_are_a_failure: ${shell}`, async (t) => {
    assert.equal(await runIn(shell, 'info', writeSmallRig(scratchFolder(t)), '--json'), 1);
  });
}

/** A program whose stderr is `stderr`; stdout is read as usual. */
function startWith(t, stderr, ...args) {
  const program = spawn(binary, args, { env, stdio: ['ignore', 'pipe', stderr] });
  program.stdout.setEncoding('utf8');
  const ended = once(program, 'close').then(([code, signal]) => code ?? signal);
  t.after(() => program.kill('SIGKILL'));
  return { program, ended };
}

async function portOf(program) {
  for (let said = ''; ; ) {
    const [text] = await once(program.stdout, 'data');
    const match = /open http:\/\/127\.0\.0\.1:(\d+)\//.exec((said += text));
    if (match) return Number(match[1]);
  }
}

function statusOf(port) {
  return new Promise((resolve, reject) => {
    const sent = request({ host: '127.0.0.1', port, path: '/healthz' }, (answer) => resolve(answer.resume().statusCode));
    sent.on('error', reject).end();
  });
}

/** Lets strangers join in vain, of which the hub logs each. */
async function makeItLog(port) {
  for (let i = 0; i < 3; ++i) await run('sensor', '--source', 'sim', '--hub', `ws://127.0.0.1:${port}`, '--room', 'nowhere', '--once');
}

test('a_hub_goes_on_where_its_log_is_full', { timeout: 60_000 }, async (t) => {
  const full = openSync('/dev/full', 'w');
  const { program, ended } = startWith(t, full, 'hub', '--listen', '127.0.0.1:0', '--verbose', '--data', scratchFolder(t));
  closeSync(full);
  const port = await portOf(program);
  await makeItLog(port);
  assert.equal(await statusOf(port), 200);
  program.kill('SIGTERM');
  assert.equal(await ended, 0);
});

test('a_hub_goes_on_when_the_reader_of_its_log_leaves', { timeout: 60_000 }, async (t) => {
  const { program, ended } = startWith(t, 'pipe', 'hub', '--listen', '127.0.0.1:0', '--log', 'json', '--data', scratchFolder(t));
  const port = await portOf(program);
  program.stderr.destroy();
  await makeItLog(port);
  assert.equal(await statusOf(port), 200);
  program.kill('SIGTERM');
  assert.equal(await ended, 0);
});

test('a_sensor_and_a_recorder_go_on_without_a_log', { timeout: 60_000 }, async (t) => {
  const hub = await startHub(t);
  const rig = writeSmallRig(scratchFolder(t));
  const full = openSync('/dev/full', 'w');
  const sensor = startWith(t, full, 'sensor', '--source', `rig:${rig}#s0`, '--hub', hub.url, '--verbose');
  closeSync(full);
  const file = join(scratchFolder(t), 'room.mcap');
  assert.equal(await runIn('2>&-', 'record', file, '--hub', hub.url, '--seconds', '1'), 0);
  assert.equal(await runIn('2>/dev/full', 'view', '--hub', hub.url, '--size', '64,48', '--png', `${file}.png`), 0);
  assert.ok(readFileSync(file).length > 1000);
  sensor.program.kill('SIGTERM');
  assert.equal(await sensor.ended, 0);
});

/** With stderr closed, the first file that a hub opens would otherwise become descriptor 2, and its log would be written into it. */
test('a_closed_log_does_not_flow_into_another_file', { timeout: 60_000 }, async (t) => {
  const data = scratchFolder(t);
  const hub = new Program(['hub', '--listen', '127.0.0.1:0', '--verbose', '--data', data], { through: ['sh', '-c', 'exec "$0" "$@" 2>&-'] });
  t.after(() => hub.stop('SIGKILL'));
  await makeItLog(await hub.port());
  assert.equal(await hub.stop(), 0);
  assert.equal(readFileSync(join(data, 'hub.sqlite')).subarray(0, 15).toString(), 'SQLite format 3');
  const again = await run('token', '--list', '--data', data);
  assert.equal(again.code, 0, again.stderr);
});
