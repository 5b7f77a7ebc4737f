// SPDX-License-Identifier: Apache-2.0
// Unpacks the packages made by cpack into an empty folder and checks their contents, and that a program can be built
// against the library and run with nothing else. (scripts/package --prove installs them in a fresh Debian.)
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gunzipSync } from 'node:zlib';

import { binary } from './program.mjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
const build = resolve(dirname(binary), '..');
const hasPython = existsSync(join(build, 'python/roomcast/__init__.py'));
const packages = ['libroomcast-dev', 'libroomcast1', ...(hasPython ? ['python3-roomcast'] : []), 'roomcast-hub', 'roomcast-sensor', 'roomcast'];
const isBuilt = [join(build, 'CPackConfig.cmake'), join(build, 'lib/libroomcast.so.1'), join(root, 'build/web/index.html')];
const absent = isBuilt.find((path) => !existsSync(path));
const skip = absent ? `${absent} is not built` : false;
const run = (command, args, options) => execFileSync(command, args, { encoding: 'utf8', stdio: 'pipe', ...options });

let folder, debs;
const unpacked = (...path) => join(folder, 'root/usr', ...path);

before(() => {
  if (skip) return;
  folder = mkdtempSync(join(tmpdir(), 'roomcast-packages-'));
  run('cpack', ['-G', 'DEB', '--config', join(build, 'CPackConfig.cmake'), '-B', folder]);
  debs = readdirSync(folder).filter((name) => name.endsWith('.deb')).sort();
  for (const deb of debs) {
    const role = /^roomcast-(hub|sensor)_/.exec(deb)?.[1]; // instead of the others
    run('dpkg-deb', ['-x', join(folder, deb), join(folder, role ?? 'root')]);
  }
});

after(() => folder && rmSync(folder, { recursive: true, force: true }));

test('all_packages_are_made', { skip }, () => {
  assert.deepEqual(debs.map((name) => name.split('_')[0]), packages);
});

test('program_finds_its_page_and_has_a_man_page_for_each_command', { skip }, () => {
  const help = run(unpacked('bin/roomcast'), ['--help']);
  const commands = help.split('Subcommands:')[1].split('\n\n')[0].match(/^ {2}\w[\w-]*/gm).map((name) => name.trim());
  assert.ok(commands.length > 10);
  for (const command of commands) {
    const page = gunzipSync(readFileSync(unpacked(`share/man/man1/roomcast-${command}.1.gz`))).toString();
    assert.match(page, /^\.SH NAME$/m);
  }
  assert.ok(existsSync(unpacked('share/roomcast/web/index.html')));
});

test('program_finds_the_reader_of_oni_files_where_openni_is_built_in', { skip }, (t) => {
  const [openni] = JSON.parse(run(unpacked('bin/roomcast'), ['devices', '--json'])).kinds.filter(({ kind }) => kind === 'openni2');
  if (!openni.built_in) return t.skip('built without OpenNI');
  const file = join(folder, 'no_recording.oni');
  writeFileSync(file, 'text');
  const sensor = ['sensor', '--source', `openni2:${file}`, '--hub', 'ws://127.0.0.1:1'];
  assert.throws(() => run(unpacked('bin/roomcast'), sensor), ({ status, stderr }) => status === 1 && /OpenNI cannot open/.test(stderr));
});

const dependsOf = (name) => run('dpkg-deb', ['-f', join(folder, debs.find((deb) => deb.startsWith(`${name}_`))), 'Depends']);

test('packages_for_one_role_need_no_graphics_and_no_window', { skip }, () => {
  const graphics = /libgl1|libegl|libepoxy|libsdl2|libx11|libopenxr/i;
  assert.match(dependsOf('roomcast'), graphics);
  for (const role of ['roomcast-hub', 'roomcast-sensor']) assert.doesNotMatch(dependsOf(role), graphics);
  assert.doesNotMatch(dependsOf('roomcast-hub'), /freenect|openni|ddsc/i);
  assert.doesNotMatch(dependsOf('roomcast-sensor'), /libjwt/i);
});

test('programs_for_one_role_do_it', { skip }, () => {
  const hub = join(folder, 'hub/usr');
  const commands = (program) => run(program, ['--help']).split('Subcommands:')[1].split('\n\n')[0].match(/^ {2}\w[\w-]*/gm).map((name) => name.trim());
  assert.deepEqual(commands(join(hub, 'bin/roomcast')), ['hub', 'token', 'record', 'play', 'study']);
  assert.deepEqual(commands(join(folder, 'sensor/usr/bin/roomcast')), ['sensor', 'devices', 'calibrate', 'board']);
  const config = join(hub, 'share/doc/roomcast/examples/roomcast.toml');
  assert.match(run(join(hub, 'bin/roomcast'), ['hub', '--data', join(folder, 'data-hub'), '--config', config, '--check']), /lab/);
  assert.ok(existsSync(join(hub, 'share/roomcast/web/index.html')));
  assert.ok(existsSync(join(hub, 'lib/systemd/system/roomcast-hub.service')));
  assert.ok(existsSync(join(folder, 'sensor/usr/lib/systemd/system/roomcast-sensor@.service')));
});

test('completion_knows_commands_and_their_options', { skip }, () => {
  const complete = (...words) =>
    run('bash', ['-c', `source "$1"; COMP_WORDS=("\${@:2}"); COMP_CWORD=$(($# - 2)); _roomcast; echo "\${COMPREPLY[@]}"`, 'bash',
      unpacked('share/bash-completion/completions/roomcast'), ...words],
      { env: { ...process.env, PATH: `${unpacked('bin')}:${process.env.PATH}` } }).trim();
  assert.equal(complete('roomcast', 'reco'), 'record');
  assert.match(complete('roomcast', 'record', '--sec'), /^--seconds$/);
  assert.equal(complete('roomcast', 'bench', 're'), 'register real redundancy render');
  assert.match(complete('roomcast', 'bench', 'codec', '--back'), /^--back-and-forth$/);
  assert.equal(complete('roomcast', 'hub', '--log', ''), 'text json');
  assert.equal(complete('roomcast', 'export', 'room.mcap', '--format', 'g'), 'gltf');
  assert.equal(complete('roomcast', 'view', '--mode', 'p'), 'points');
});

test('documents_link_to_documents_that_are_installed', { skip }, () => {
  const folder = unpacked('share/doc/roomcast');
  const documents = run('find', [folder, '-name', '*.md']).trim().split('\n');
  assert.ok(documents.length > 20);
  const dead = documents.flatMap((document) =>
    [...readFileSync(document, 'utf8').matchAll(/\]\(([^)#\s]+)/g)]
      .map(([, link]) => link)
      .filter((link) => !/^[a-z]+:/.test(link) && !existsSync(resolve(dirname(document), link)))
      .map((link) => `${document.slice(folder.length + 1)}: ${link}`),
  );
  assert.deepEqual(dead, []);
});

test('configuration_to_begin_with_can_be_used', { skip }, () => {
  const data = join(folder, 'data');
  const said = run(unpacked('bin/roomcast'), ['hub', '--data', data, '--config', unpacked('share/doc/roomcast/examples/roomcast.toml'), '--check']);
  assert.match(said, /lab/);
});

test('services_start_programs_and_options_that_there_are', { skip }, () => {
  const units = unpacked('lib/systemd/system');
  for (const unit of readdirSync(units)) {
    const text = readFileSync(join(units, unit), 'utf8').replaceAll('\\\n', ' ');
    const starts = [...text.matchAll(/^ExecStart\w*=.*?roomcast (\w+)(.*)$/gm)];
    assert.ok(starts.length > 0, unit);
    for (const [, command, options] of starts) {
      const help = run(unpacked('bin/roomcast'), [command, '--help']);
      for (const option of options.match(/--[a-z-]+/g) ?? []) assert.ok(help.includes(option), `${unit}: ${command} ${option}`);
    }
  }
});

test('every_camera_that_is_known_may_be_opened', { skip }, () => {
  const known = readFileSync(join(root, 'roomcast/source/camera/usb_device.cpp'), 'utf8').matchAll(/Known\{0x(\w{4}), 0x(\w{4}), "\w+", "([^"]+)"/g);
  const rules = readFileSync(unpacked('lib/udev/rules.d/60-roomcast-cameras.rules'), 'utf8').split('\n');
  const isOpened = (vendor, product) =>
    rules.some((rule) => rule.includes(`ATTR{idVendor}=="${vendor}"`) && (!/idProduct/.test(rule) || /idProduct}=="([^"]*)"/.exec(rule)[1].split('|').includes(product)));
  const closed = [...known].filter(([, vendor, product]) => !isOpened(vendor, product)).map(([, , , model]) => model);
  assert.deepEqual(closed, []);
});

test('python_imports_the_unpacked_module', { skip: skip || (!hasPython && 'the Python module is not built') }, () => {
  const env = { ...process.env, PYTHONPATH: unpacked('lib/python3/dist-packages'), PYTHONDONTWRITEBYTECODE: '1' };
  const place = run('/usr/bin/python3', ['-c', 'import roomcast; print(roomcast.__file__)'], { env }).trim();
  assert.ok(place.startsWith(folder), place);
  assert.ok(existsSync(unpacked('lib/python3/dist-packages/roomcast/__init__.pyi')));
  const deb = debs.find((name) => name.startsWith('python3-roomcast'));
  assert.match(run('dpkg-deb', ['-f', join(folder, deb), 'Depends']), /python3-numpy/);
});

test('program_is_built_against_the_unpacked_library_by_pkg_config', { skip }, () => {
  const config = run('find', [join(folder, 'root'), '-name', 'roomcast.pc']).trim();
  const env = { ...process.env, PKG_CONFIG_PATH: dirname(config) };
  const flags = run('pkg-config', ['--cflags', '--libs', 'roomcast'], { env }).trim().split(/\s+/);
  assert.ok(flags.some((flag) => flag.startsWith(`-I${folder}`)), flags.join(' '));
  const program = join(folder, 'points');
  run('cc', [unpacked('share/doc/libroomcast-dev/examples/points.c'), ...flags, '-o', program]);
  const linked = run('ldd', [program], { env: { ...process.env, LD_LIBRARY_PATH: dirname(dirname(config)) } });
  assert.match(linked, new RegExp(`libroomcast\\.so\\.1 => ${folder}`));
});
