// SPDX-License-Identifier: Apache-2.0
// The summary of scripts/test, when files of tests that measure times run again because a test in them failed.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const scripts = fileURLToPath(new URL('../../scripts', import.meta.url));

test('tests that were skipped are listed once, those of files that do not run again, too', (t) => {
  const folder = mkdtempSync(join(tmpdir(), 'roomcast-suites-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  writeFileSync(
    join(folder, 'quiet.test.mjs'),
    "import { test } from 'node:test'; test('passes', () => 0); test('left out', { skip: 'no device' }, () => 0);",
  );
  writeFileSync(
    join(folder, 'busy.test.mjs'),
    `import { existsSync, writeFileSync } from 'node:fs'; import { test } from 'node:test';
     const here = ${JSON.stringify(join(folder, 'ran'))};
     test('left out as well', { skip: 'no network' }, () => 0);
     test('fails once', () => { if (existsSync(here)) return; writeFileSync(here, ''); throw new Error('too slow'); });`,
  );
  const script = `
    here=${scripts}; source "$here/steps.sh"; source "$here/suites.sh"
    plan 1; logs=${folder}
    run_files() { node --test --test-concurrency=1 --test-reporter=tap "$@"; }
    timed_suite 'timed tests' run_files ${folder}/*.test.mjs 2>/dev/null
    sum_up`;
  const env = { ...process.env };
  delete env.NODE_TEST_CONTEXT; // the tests within are no part of this one
  const said = execFileSync('bash', ['-c', script], { encoding: 'utf8', env });
  const [, skipped, repeated] = /\nskipped:\n([^]*?)\n\npassed only when they ran alone:\n([^]*?)\n\n/.exec(said) ?? [];
  assert.deepEqual(skipped?.split('\n').sort(), ['  left out as well: no network', '  left out: no device'], said);
  assert.match(repeated, /^  fails once: '?too slow'?$/);
  assert.match(said, /\n2 passed, 0 failed, 2 skipped\n$/);
});
