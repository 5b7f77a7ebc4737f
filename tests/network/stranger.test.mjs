// SPDX-License-Identifier: Apache-2.0
// Runs docs/guides/first-room.md command by command: a public hub with encryption and tokens, two sensors and a
// colleague in another network (a network namespace), a revoked token, and a restart after which everything is still
// there. Needs root, for the namespace.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { Program, scratchFolder } from '../cli/program.mjs';
import { freePort } from './nginx.mjs';
import { writeSmallRig } from './small_rig.mjs';

const guide = resolve(dirname(fileURLToPath(import.meta.url)), '../../docs/guides/first-room.md');
const hubAddress = '10.77.3.1';
const colleagueAddress = '10.77.3.2';
const suffix = String(process.pid % 10_000);
const names = { namespace: `rc${suffix}`, here: `rch${suffix}`, there: `rct${suffix}` };

function ip(...args) {
  const { status, stderr, error } = spawnSync('ip', args, { encoding: 'utf8' });
  if (error || status !== 0) throw new Error(error?.message ?? stderr);
}

function whyNot() {
  if (process.getuid?.() !== 0) return 'making a network namespace takes root';
  try {
    ip('netns', 'add', names.namespace);
    ip('netns', 'del', names.namespace);
    return false;
  } catch (error) {
    return `no network namespace can be made here: ${error.message}`;
  }
}

/** Another network, connected to this machine by a virtual cable; programs run `through` it have its address. */
function otherNetwork(t) {
  ip('netns', 'add', names.namespace);
  t.after(() => ip('netns', 'del', names.namespace));
  ip('link', 'add', names.here, 'type', 'veth', 'peer', 'name', names.there, 'netns', names.namespace);
  ip('addr', 'add', `${hubAddress}/30`, 'dev', names.here);
  ip('link', 'set', names.here, 'up');
  ip('-n', names.namespace, 'addr', 'add', `${colleagueAddress}/30`, 'dev', names.there);
  ip('-n', names.namespace, 'link', 'set', names.there, 'up');
  return ['ip', 'netns', 'exec', names.namespace];
}

/** The guide's roomcast commands in order. */
function commandsOfGuide() {
  const blocks = [...readFileSync(guide, 'utf8').matchAll(/^```\n([^]*?)^```$/gm)].map(([, block]) => block);
  return blocks.flatMap((block) => block.split('\n')).filter((line) => /^roomcast \w+ /.test(line));
}

/** Runs the guide's commands in their order, in one folder, which is also their home. */
class Walk {
  #commands = commandsOfGuide();

  /** `instead`: replacements in the commands, [text of the guide, text to use]. */
  constructor(t, folder, instead) {
    Object.assign(this, { t, folder, instead });
  }

  /** Starts the next command, which must begin with `beginning`. */
  start(beginning, through = []) {
    let command = this.#commands.shift() ?? '';
    assert.ok(command.startsWith(`roomcast ${beginning}`), `the guide has "${command}" where "${beginning}" is expected`);
    for (const [theirs, ours] of this.instead) command = command.replace(theirs, ours);
    const [line, file] = command.split(' > ');
    const home = ['env', '-C', this.folder, '-u', 'XDG_STATE_HOME', `HOME=${this.folder}`];
    const program = new Program(line.split(' ').slice(1), { through: [...through, ...home], limitMs: 120_000 });
    this.t.after(() => program.stop('SIGKILL'));
    return Object.assign(program, { file });
  }

  /** Runs the next command to its end. */
  async run(beginning, through) {
    const program = this.start(beginning, through);
    const code = await program.ended;
    if (program.file) writeFileSync(join(this.folder, program.file), program.stdout);
    return { code, stdout: program.stdout, stderr: program.stderr };
  }

  isOver() {
    return this.#commands.length === 0;
  }
}

async function startHub(walk) {
  const hub = walk.start('hub --listen');
  const [, fingerprint] = await hub.prints(/--hub wss:\/\/[0-9.]+:\d+#sha256=([0-9a-f]{64})/);
  return { hub, fingerprint };
}

test('stranger_walks_from_nothing_to_a_shared_room', { skip: whyNot(), timeout: 120_000 }, async (t) => {
  const folder = scratchFolder(t);
  const rig = writeSmallRig(folder);
  const through = otherNetwork(t);
  const port = String(await freePort());
  const walk = new Walk(t, folder, [
    ['0.0.0.0:7600', `${hubAddress}:${port}`],
    ['192.0.2.10:7600', `${hubAddress}:${port}`],
    ['--source sim#0 --name left', `--source rig:${rig}#s0 --name left --verbose`],
    ['--source sim#1 --name right', `--source rig:${rig}#s1 --name right --verbose`],
    ['roomcast view', 'roomcast view --headless --size 64,48'],
  ]);
  const { hub, fingerprint } = await startHub(walk);
  walk.instead.push(['FINGERPRINT', fingerprint]);

  for (const name of ['left', 'right', 'Ada']) {
    const made = await walk.run(`token --room room --role ${name === 'Ada' ? 'viewer' : 'sensor'} --name ${name}`);
    assert.equal(made.code, 0, made.stderr);
  }
  const left = walk.start('sensor', through);
  await left.prints(/joined/);
  const right = walk.start('sensor', through);
  await right.prints(/joined/);

  assert.deepEqual(await walk.run('view', through), { code: 0, stdout: '', stderr: '' });
  assert.ok(existsSync(join(folder, 'room.png')));
  const stranger = await walk.run('view', through);
  assert.equal(stranger.code, 1);
  const [refusal] = readFileSync(guide, 'utf8').match(/^roomcast view: the hub says: .*$/m);
  assert.equal(stranger.stderr.trimEnd(), refusal);

  const { stdout: list } = await walk.run('token --list');
  walk.instead.push([/ ID$/, ` ${/^(\S+) +room +sensor +right /m.exec(list)[1]}`]);
  assert.equal((await walk.run('token --revoke')).code, 0);
  assert.equal(await right.ended, 1);
  assert.match(right.stderr, /revoked/);

  assert.equal(await hub.stop('SIGINT'), 0);
  const again = await startHub(walk);
  assert.equal(again.fingerprint, fingerprint, 'the same certificate');
  assert.equal((await walk.run('view', through)).code, 0, 'sensor and token still hold');
  assert.ok(existsSync(join(folder, 'again.png')));
  const refused = await walk.run('sensor', through);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /revoked/);
  assert.ok(walk.isOver(), 'the guide has more commands than were run');
});
