// SPDX-License-Identifier: Apache-2.0
// roomcast doctor.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { run, startHub } from './program.mjs';

const topics = ['processor', 'memory', 'connections', 'clock', 'disk', 'network', 'port', 'page', 'browser', 'graphics'];

test('doctor_looks_at_everything_and_says_what_to_do', async () => {
  const { code, stdout } = await run('doctor', '--json');
  const report = JSON.parse(stdout);
  assert.equal(code, report.problems === 0 ? 0 : 1);
  const found = report.findings.map((finding) => finding.topic);
  for (const topic of topics) assert.ok(found.includes(topic), `${topic} in ${found}`);
  for (const { topic, verdict, sentence, remedy } of report.findings) {
    assert.ok(['ok', 'notice', 'problem'].includes(verdict), topic);
    assert.ok(sentence.length > 0, topic);
    if (verdict === 'problem') assert.ok(remedy.length > 0, topic);
  }
});

test('doctor_contacts_a_hub', async (t) => {
  const hub = await startHub(t);
  const { stdout } = await run('doctor', '--hub', hub.url);
  assert.match(stdout, /^ok +hub +127\.0\.0\.1:\d+ answers; the round trip takes [\d.]+ ms\.$/m);
});

test('doctor_names_a_hub_that_does_not_answer', async (t) => {
  const hub = await startHub(t);
  await hub.program.stop('SIGINT');
  const { code, stdout } = await run('doctor', '--hub', hub.url);
  assert.equal(code, 1);
  assert.match(stdout, /^problem +hub /m);
});
