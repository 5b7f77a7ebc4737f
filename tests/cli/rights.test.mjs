// SPDX-License-Identifier: Apache-2.0
// Recording rights set by a room's owner, and their enforcement by our programs.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';

import { Program, assertFailed, binary, run, scratchFolder, startHub } from './program.mjs';

const example = resolve(dirname(binary), 'roomcast_example_points');
const library = resolve(dirname(binary), '../lib/libroomcast.so.1');
const notRecorded = /this room does not let viewers record/;

/** A hub on this machine with one room and one sensor; `rights` are lines of its configuration. */
async function startRoom(t, ...rights) {
  const config = join(scratchFolder(t), 'roomcast.toml');
  writeFileSync(config, ['[[room]]', 'name = "lab"', ...rights, ''].join('\n'));
  const hub = await startHub(t, '--config', config);
  const sensor = new Program(['sensor', '--source', 'sim', '--hub', hub.url, '--verbose']);
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  return hub;
}

test('no_program_records_a_room_that_does_not_let_viewers_record', async (t) => {
  const hub = await startRoom(t, 'record = "admin"');
  const folder = scratchFolder(t);
  const kept = (name) => join(folder, name);
  assertFailed(await run('view', '--hub', hub.url, '--headless', '--png', kept('a.png')), 1, notRecorded);
  assertFailed(await run('record', kept('a.mcap'), '--hub', hub.url, '--seconds', '1'), 1, /does not let you record/);
  const last = await run('view', '--hub', hub.url, '--seconds', '1', '--last-picture', kept('b.png'));
  assertFailed(last, 1, notRecorded);
  for (const name of ['a.png', 'a.mcap', 'b.png']) assert.equal(existsSync(kept(name)), false, name);
});

test('recordings_of_a_room_without_the_right_to_export_are_not_exported', async (t) => {
  const hub = await startRoom(t, 'export = "admin"');
  const folder = scratchFolder(t);
  const file = join(folder, 'a.mcap');
  const recorded = await run('record', file, '--hub', hub.url, '--seconds', '1');
  assert.equal(recorded.code, 0, recorded.stderr);
  assertFailed(await run('export', file, '--out', join(folder, 'out')), 1, /did not let viewers export/);
  assert.equal(existsSync(join(folder, 'out')), false);
});

/** Calls libroomcast as a program in another language would. */
const asksLibrary = `
import ctypes, sys
class Options(ctypes.Structure):
    _fields_ = [("size", ctypes.c_size_t), *[(name, ctypes.c_char_p) for name in ("hub", "room", "name", "token")]]
library = ctypes.CDLL(sys.argv[1])
library.roomcast_connect.restype = ctypes.c_void_p
error = ctypes.create_string_buffer(256)
viewer = library.roomcast_connect(ctypes.byref(Options(ctypes.sizeof(Options), sys.argv[2].encode())), error, len(error))
for ask in (library.roomcast_may_record, library.roomcast_may_export):
    error.value = b""
    print(ask(ctypes.c_void_p(viewer), error, ctypes.c_size_t(len(error))), error.value.decode())
library.roomcast_disconnect(ctypes.c_void_p(viewer))
`;

test('the_library_reports_the_rights_of_viewers', { skip: existsSync(library) ? false : `${library} is not built` }, async (t) => {
  const hub = await startRoom(t, 'record = "nobody"');
  const { stdout, stderr } = spawnSync('python3', ['-c', asksLibrary, library, hub.url], { encoding: 'utf8', timeout: 25_000 });
  assert.equal(stdout, '0 this room does not let viewers record\n1 \n', stderr);
});

test('the_c_example_writes_no_file_of_a_room_without_the_right_to_export',
  { skip: existsSync(example) ? false : `${example} is not built` }, async (t) => {
    const hub = await startRoom(t, 'export = "nobody"');
    const ply = join(scratchFolder(t), 'room.ply');
    const { status, stderr } = spawnSync(example, [hub.url, ply], { encoding: 'utf8', timeout: 25_000 });
    assert.equal(status, 1);
    assert.equal(stderr, 'this room does not let viewers export\n');
    assert.equal(existsSync(ply), false);
  });
