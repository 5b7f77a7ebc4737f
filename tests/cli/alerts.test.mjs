// SPDX-License-Identifier: Apache-2.0
// The alert rules for Prometheus: they ask for metrics that a hub has, with labels that these have. (promtool checks their
// grammar, and when they come, where it is installed.)
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { scratchFolder, startHub, startSensor } from './program.mjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
const file = join(root, 'packaging/alerts/roomcast.rules.yml');
const rules = readFileSync(file, 'utf8');
const documented = readFileSync(join(root, 'docs/guides/metrics.md'), 'utf8');

test('rules_ask_for_metrics_that_are_documented_and_served', async (t) => {
  const asked = new Set([...rules.matchAll(/^\s+expr: (.*)$/gm)].flatMap(([, expression]) => expression.match(/\b(?:roomcast|process)_\w+/g) ?? []));
  assert.ok(asked.size >= 10, [...asked].join());
  for (const metric of asked) assert.ok(documented.includes(`\`${metric}\``), `${metric} is not in docs/guides/metrics.md`);
  const hub = await startHub(t);
  await startSensor(t, hub, '--name', 'eye');
  const metrics = await (await fetch(`http://127.0.0.1:${hub.port}/metrics`)).text();
  for (const metric of asked) {
    if (metric.startsWith('roomcast_backplane_')) continue; // of a hub that shares its rooms
    assert.match(metrics, new RegExp(`^${metric}[ {]`, 'm'));
  }
  assert.match(metrics, /^roomcast_sensor_online\{(?=.*room=)(?=.*sensor="eye").*\} 1$/m);
});

test('each_rule_says_what_it_is_and_what_to_do', () => {
  const alerts = rules.split('- alert: ').slice(1);
  assert.ok(alerts.length >= 8);
  for (const alert of alerts) assert.match(alert, /expr: .*[^]*severity: (warning|critical)[^]*summary: "[^]+"[^]*description: "[^]+"/, alert);
});

const skip = spawnSync('promtool', ['--version']).error ? 'promtool is not installed (Debian: apt install prometheus)' : false;

function promtool(...args) {
  const { status, stdout, stderr } = spawnSync('promtool', args, { encoding: 'utf8' });
  assert.equal(status, 0, stdout + stderr);
}

test('promtool_accepts_the_rules', { skip }, () => promtool('check', 'rules', file));

test('each_alert_comes_when_it_should_and_says_what_is_wrong', { skip }, (t) => {
  const cases = join(scratchFolder(t), 'alert_rules.yml');
  writeFileSync(cases, readFileSync(join(root, 'tests/cli/alert_rules.yml'), 'utf8').replace('RULES', JSON.stringify(file)));
  promtool('test', 'rules', cases);
});
