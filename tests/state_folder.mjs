// SPDX-License-Identifier: Apache-2.0
// Keeps the hub's state (certificate, poses) in a folder of this test run, apart from the user's own state.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const folder = mkdtempSync(join(tmpdir(), 'roomcast-state-'));
process.on('exit', () => rmSync(folder, { recursive: true, force: true }));

/** The environment for programs under test. */
export const env = { ...process.env, XDG_STATE_HOME: folder };
