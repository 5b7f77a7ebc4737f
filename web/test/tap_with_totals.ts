// SPDX-License-Identifier: Apache-2.0
// vitest's TAP without the totals that node's own runner ends with; scripts/test counts by them.
import type { RunnerTestCase, RunnerTestFile, RunnerTestSuite } from 'vitest';
import { TapFlatReporter } from 'vitest/reporters';

function testsIn(suite: RunnerTestSuite): RunnerTestCase[] {
  return suite.tasks.flatMap((task) => (task.type === 'suite' ? testsIn(task) : [task]));
}

export default class TapWithTotals extends TapFlatReporter {
  override onFinished(files: RunnerTestFile[] = []): void {
    super.onFinished(files);
    const tests = files.flatMap(testsIn);
    const count = (counts: (test: RunnerTestCase) => boolean) => tests.filter(counts).length;
    const brokenFiles = files.filter((file) => file.result?.state === 'fail' && testsIn(file).length === 0).length;
    this.ctx.logger.log(`# pass ${count((t) => t.result?.state === 'pass')}`);
    this.ctx.logger.log(`# fail ${count((t) => t.result?.state === 'fail') + brokenFiles}`);
    this.ctx.logger.log(`# skipped ${count((t) => t.mode === 'skip')}`);
    this.ctx.logger.log(`# todo ${count((t) => t.mode === 'todo')}`);
  }
}
