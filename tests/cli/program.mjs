// SPDX-License-Identifier: Apache-2.0
// Runs the real roomcast program for the tests in this folder, with a time limit, on loopback, on a port of its own.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

import { env } from '../state_folder.mjs';

const sourceDir = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const binary = process.env.ROOMCAST_BIN ?? join(sourceDir, 'build/dev/bin/roomcast');

/** Default time limit of a command. The program is killed when it exceeds the limit, and the test fails. */
const timeLimitMs = 30_000;

const running = new Set();

/** A running roomcast; `stdout` and `stderr` grow while it runs, `ended` resolves to its exit code (or signal). */
export class Program {
  stdout = '';
  stderr = '';

  /** `through` is a command that runs the program, for example ["nice"]; `environment` adds environment variables. */
  constructor(args, { through = [], limitMs = timeLimitMs, environment = {} } = {}) {
    this.args = args;
    const [command, ...rest] = [...through, binary, ...args];
    this.child = spawn(command, rest, { env: { ...env, ...environment }, stdio: ['ignore', 'pipe', 'pipe'] });
    this.child.stdout.setEncoding('utf8').on('data', (text) => (this.stdout += text));
    this.child.stderr.setEncoding('utf8').on('data', (text) => (this.stderr += text));
    this.ended = once(this.child, 'close').then(([code, signal]) => code ?? signal);
    const limit = setTimeout(() => this.child.kill('SIGKILL'), limitMs);
    running.add(this);
    this.ended.then(() => {
      clearTimeout(limit);
      running.delete(this);
    });
  }

  /** Resolves once the program's output matches; rejects if the program ends before. */
  async prints(pattern) {
    for (;;) {
      const match = pattern.exec(this.stdout) ?? pattern.exec(this.stderr);
      if (match) return match;
      const more = Promise.race([once(this.child.stdout, 'data'), once(this.child.stderr, 'data')]);
      const over = await Promise.race([more.then(() => false), this.ended.then(() => true)]);
      if (over) assert.fail(`roomcast ${this.args.join(' ')} ended before it printed ${pattern}:\n${this.stderr}`);
    }
  }

  /**
   * The port of the page address printed by the program. Other addresses, such as NATS servers, may be printed before.
   */
  async port() {
    return Number((await this.prints(/open https?:\/\/127\.0\.0\.1:(\d+)\//))[1]);
  }

  async stop(signal = 'SIGTERM') {
    this.child.kill(signal);
    return this.ended;
  }
}

/** Runs a command to its end. Options of Program may follow its arguments. */
export async function run(...args) {
  const options = typeof args.at(-1) === 'object' ? args.pop() : {};
  const program = new Program(args, options);
  const code = await program.ended;
  return { code, stdout: program.stdout, stderr: program.stderr };
}

/** Runs a program other than roomcast to its end, for at most 25 s. */
export async function runOther(command, ...args) {
  const child = spawn(command, args, { stdio: ['ignore', 'pipe', 'pipe'], timeout: 25_000 });
  let stdout = '';
  let stderr = '';
  child.stdout.setEncoding('utf8').on('data', (text) => (stdout += text));
  child.stderr.setEncoding('utf8').on('data', (text) => (stderr += text));
  const [code, signal] = await once(child, 'close');
  return { code: code ?? signal, stdout, stderr };
}

/** Starts a hub on a free port, with a state of its own; it is stopped when the test `t` ends. */
export async function startHub(t, ...options) {
  return startHubThrough(t, [], ...options);
}

/** The same; `through` is a command that runs the hub. */
export async function startHubThrough(t, through, ...options) {
  const data = options.includes('--data') ? [] : ['--data', scratchFolder(t)];
  const hub = new Program(['hub', '--listen', '127.0.0.1:0', ...data, ...options], { through });
  t.after(() => hub.stop('SIGKILL'));
  const port = await hub.port();
  return { program: hub, port, url: `ws://127.0.0.1:${port}` };
}

/**
 * A folder that is deleted when the test `t` ends. Hooks run in the order in which they were added, so programs that
 * were started after the folder was made, and may still write into it, are ended here.
 */
export function scratchFolder(t) {
  const folder = mkdtempSync(join(tmpdir(), 'roomcast-cli-'));
  t.after(async () => {
    const users = [...running].filter(({ args }) => args.some((argument) => argument.includes(folder)));
    await Promise.all(users.map((program) => program.stop('SIGKILL')));
    rmSync(folder, { recursive: true, force: true });
  });
  return folder;
}

/** Asserts that the command failed with `code` and printed one sentence on stderr that matches. */
export function assertFailed({ code, stderr }, expectedCode, sentence) {
  assert.equal(code, expectedCode, stderr);
  const lines = stderr.trimEnd().split('\n');
  assert.equal(lines.length, 1, `one sentence, not ${lines.length} lines:\n${stderr}`);
  assert.match(lines[0], sentence);
}

/** Starts a simulated sensor and waits until it has joined the hub; it is stopped when the test `t` ends. */
export async function startSensor(t, hub, ...options) {
  const sensor = new Program(['sensor', '--source', 'sim', '--hub', hub.url, '--verbose', ...options]);
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  return sensor;
}

/** Asserts that the room can be seen: a viewer that joins now draws its sensor. */
export async function assertServes(t, hub) {
  const picture = join(scratchFolder(t), 'room.png');
  const { code, stderr } = await run('view', '--hub', hub.url, '--headless', '--png', picture);
  assert.equal(code, 0, stderr);
  assert.ok(existsSync(picture));
}
