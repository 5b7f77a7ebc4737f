// SPDX-License-Identifier: Apache-2.0
// roomcast study: plans that are right and wrong, and folders that are none.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { run } from './program.mjs';

const folder = mkdtempSync(join(tmpdir(), 'roomcast-plan-'));
const plan = join(folder, 'plan.toml');
after(() => rmSync(folder, { recursive: true, force: true }));

test('the example is a plan, and is described', async () => {
  const example = await run('study', 'example');
  assert.equal(example.code, 0);
  writeFileSync(plan, example.stdout);
  const check = await run('study', 'check', plan);
  assert.equal(check.code, 0, check.stderr);
  assert.match(check.stdout, /delay: 2 conditions, 4\.0 minutes in all; 1 questionnaires with 3 items/);
  assert.match(check.stdout, /P001: live, late\nP002: late, live/);
  assert.match(check.stdout, /repeat after 2 participants/);
  const json = JSON.parse((await run('study', 'check', plan, '--json')).stdout);
  assert.deepEqual(json.faults, []);
  assert.equal(json.study.conditions[1].latency_ms, 400);
});

test('all mistakes of a plan are told with their lines', async () => {
  writeFileSync(plan, '[study]\nname = "a b"\nconsent = "yes"\n[[condition]]\nname = "one"\nfps = "fast"\n');
  const check = await run('study', 'check', plan);
  assert.equal(check.code, 1);
  assert.match(check.stderr, /line 2: "a b" is no name/);
  assert.match(check.stderr, /line 6: this must be a number from 0\.1 to 240/);
  assert.match(check.stderr, /this plan has 2 mistakes/);
  const json = JSON.parse((await run('study', 'check', plan, '--json')).stdout);
  assert.deepEqual(json.faults.map(({ line }) => line), [2, 6]);
  const hub = await run('hub', '--study', plan, '--check');
  assert.equal(hub.code, 1);
  assert.match(hub.stderr, /plan\.toml, line 2: "a b" is no name/);
});

test('what is not there is told', async () => {
  for (const [args, said] of [
    [['check', join(folder, 'none.toml')], /none\.toml/],
    [['export', folder, '--csv', join(folder, 'csv')], /is no folder of a study/],
    [['erase', folder, 'P001'], /is no folder of a study/],
    [['report', folder, '--out', join(folder, 'report')], /is no folder of a study/],
    [['replay', folder, 'P001', '--recording', plan, '--out', folder], /is no folder of a study/],
  ]) {
    const { code, stderr } = await run('study', ...args);
    assert.equal(code, 1, args[0]);
    assert.match(stderr, said);
  }
});
