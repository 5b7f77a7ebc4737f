// SPDX-License-Identifier: Apache-2.0
// What a hub keeps (certificate, poses) is kept in a folder of this test run, not among the tester's own.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const folder = mkdtempSync(join(tmpdir(), 'roomcast-state-'));
process.on('exit', () => rmSync(folder, { recursive: true, force: true }));

/** The environment for programs under test. */
export const env = { ...process.env, XDG_STATE_HOME: folder };
