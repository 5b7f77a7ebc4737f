// SPDX-License-Identifier: Apache-2.0
// Command-line usage: help with examples, and exit code 2 with one sentence for wrong usage.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { assertFailed, run, scratchFolder } from './program.mjs';

const commands = [['demo'], ['hub'], ['sensor'], ['view'], ['simulate'], ['devices'], ['calibrate'], ['info'], ['foxglove'], ['ros2'], ['bench', 'codec'], ['bench', 'register']];

for (const command of commands) {
  const name = command.join(' ');
  test(`help_of_${command.join('_')}_has_an_example`, async () => {
    const { code, stdout } = await run(...command, '--help');
    assert.equal(code, 0);
    assert.match(stdout, new RegExp(`example[^]*roomcast ${name}`, 'i'));
  });
}

test('version_names_the_program_its_commit_its_wire_and_its_cameras', async () => {
  const { code, stdout } = await run('--version');
  assert.equal(code, 0);
  const [first, second, ...others] = stdout.trimEnd().split('\n');
  assert.match(first, /^roomcast \d+\.\d+\.\d+ \(commit [0-9a-z-]+, wire version \d+\)$/);
  const { kinds } = JSON.parse((await run('devices', '--json')).stdout);
  const builtIn = kinds.filter(({ built_in }) => built_in).map(({ kind }) => kind);
  assert.equal(second, `cameras built in: ${builtIn.join(', ') || 'none'}`);
  assert.deepEqual(others, []);
});

test('help_names_every_command', async () => {
  const { code, stdout } = await run('--help');
  assert.equal(code, 0);
  for (const [first] of commands) assert.match(stdout, new RegExp(`^ +${first}\\b`, 'm'));
});

const wrongUsages = {
  no_command: [[], /command/],
  unknown_command: [['fly'], /command/],
  unknown_option: [['hub', '--altitude', '3'], /--altitude/],
  sensor_without_source: [['sensor', '--hub', 'ws://127.0.0.1:1'], /--source/],
  view_without_hub: [['view', '--headless', '--png', 'x.png'], /--hub/],
  sensors_not_a_number: [['demo', '--sensors', 'many'], /--sensors/],
  zero_sensors: [['demo', '--sensors', '0'], /sensors/],
  port_too_large: [['hub', '--listen', '127.0.0.1:70000'], /70000|port/],
  listen_not_an_address: [['hub', '--listen', 'somewhere:1'], /somewhere/],
  unknown_kind_of_source: [['sensor', '--source', 'crystal:ball', '--hub', 'ws://127.0.0.1:1'], /crystal/],
  seconds_not_a_number: [['record', 'x.mcap', '--hub', 'ws://127.0.0.1:1', '--seconds', 'nan'], /nan is not a number from 0 to/],
  seconds_without_end: [['demo', '--seconds', '1e400'], /1e400 is not a number from 0 to/],
  seed_below_zero: [['simulate', '/tmp/never', '--seed', '-1'], /whole number/],
  seed_too_large: [['simulate', '/tmp/never', '--seed', '999999999999999999999'], /whole number/],
  upstream_that_is_no_host: [['hub', '--check', '--upstream', '../../../../etc/passwd'], /not a hub's address/],
  json_without_picture: [['view', '--hub', 'ws://127.0.0.1:1', '--json'], /--png/],
  headset_without_window: [['view', '--hub', 'ws://127.0.0.1:1', '--png', 'x.png', '--vr'], /--vr/],
  hub_not_an_address: [['sensor', '--source', 'sim', '--hub', 'ftp://x'], /ftp/],
};

for (const [name, [args, sentence]] of Object.entries(wrongUsages)) {
  test(`wrong_usage_ends_with_2_and_one_sentence: ${name}`, async () => {
    assertFailed(await run(...args), 2, sentence);
  });
}

for (const [name, args] of Object.entries({ hub: ['hub', '--check'], token: ['token', '--list'] })) {
  test(`a_configuration_that_is_a_folder_or_has_no_end_is_refused: ${name}`, async () => {
    assertFailed(await run(...args, '--config', '/etc'), 1, /cannot read \/etc: Is a directory/);
    assertFailed(await run(...args, '--config', '/dev/zero'), 1, /has more than \d+ bytes/);
  });
}

test('a_token_file_without_an_end_is_refused', async () => {
  const result = await run('record', '/tmp/never.mcap', '--hub', 'ws://127.0.0.1:1', '--token-file', '/dev/zero');
  assertFailed(result, 1, /has more than \d+ bytes/);
});

test('what_steers_a_terminal_or_turns_text_is_spelled_out', async () => {
  const { stderr } = await run('info', '/nowhere/\u001b[31mred\u202ecba');
  assert.match(stderr, /\\u001B\[31mred\\u202Ecba/);
  assert.doesNotMatch(stderr, /[\u001b\u202e]/);
});

test('a_folder_that_cannot_be_written_is_noticed_before_the_work', async (t) => {
  const folder = scratchFolder(t);
  writeFileSync(join(folder, 'kept'), '');
  for (const [out, why] of [[folder, /is not empty/], ['/proc/nope/out', /cannot/]]) {
    const begin = performance.now();
    assertFailed(await run('simulate', out, '--sensors', '8', '--seconds', '100'), 1, why);
    t.diagnostic(`${(performance.now() - begin).toFixed(0)} ms`);
  }
});

test('without_memory_or_descriptors_a_program_ends_with_a_sentence', async (t) => {
  for (const limits of ['ulimit -n 8', 'ulimit -v 200000']) {
    const args = ['hub', '--listen', '127.0.0.1:0', '--data', scratchFolder(t), '--threads', '8'];
    const { code, stderr } = await run(...args, { through: ['sh', '-c', `${limits}; exec "$0" "$@"`] });
    assert.ok(code === 1 || code === 127, `${limits}: ${code} ${stderr}`);
    assert.doesNotMatch(stderr, /terminate called|bad_alloc|internal error/);
    assert.match(stderr.trimEnd().split('\n').at(-1), /memory|system refused|cannot|shared/);
  }
});
