// SPDX-License-Identifier: Apache-2.0
// Command-line usage: help with examples, and exit code 2 with one sentence for wrong usage.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { assertFailed, run } from './program.mjs';

const commands = [['demo'], ['hub'], ['sensor'], ['view'], ['simulate'], ['devices'], ['calibrate'], ['info'], ['bench', 'codec'], ['bench', 'register']];

for (const command of commands) {
  const name = command.join(' ');
  test(`help_of_${command.join('_')}_has_an_example`, async () => {
    const { code, stdout } = await run(...command, '--help');
    assert.equal(code, 0);
    assert.match(stdout, new RegExp(`example[^]*roomcast ${name}`, 'i'));
  });
}

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
  hub_not_an_address: [['sensor', '--source', 'sim', '--hub', 'ftp://x'], /ftp/],
};

for (const [name, [args, sentence]] of Object.entries(wrongUsages)) {
  test(`wrong_usage_ends_with_2_and_one_sentence: ${name}`, async () => {
    assertFailed(await run(...args), 2, sentence);
  });
}
