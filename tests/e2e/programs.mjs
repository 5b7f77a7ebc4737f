// SPDX-License-Identifier: Apache-2.0
// Starts the real programs on loopback and ends them by their process id. ROOMCAST_BIN is the roomcast binary,
// ROOMCAST_WEB the built page (default: build/web).
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { setTimeout as delay } from 'node:timers/promises';

import { env } from '../state_folder.mjs';

const readyWithin_ms = 60_000;
const endWithin_ms = 20_000;
const kept_lines = 200;
const kept_bytes = 100_000; // of standard output

const fromRoot = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));

export const binary = process.env.ROOMCAST_BIN ?? fromRoot('build/dev/bin/roomcast');
export const webFolder = process.env.ROOMCAST_WEB ?? fromRoot('build/web');

export function requireBuilt() {
  if (!existsSync(binary)) throw new Error(`there is no program at ${binary}; build it or set ROOMCAST_BIN`);
  if (!existsSync(`${webFolder}/index.html`)) throw new Error(`there is no page in ${webFolder}; run npm run build`);
}

const running = new Set();

/** The last output lines of every program that runs, for the message of a failed test. */
export function whatProgramsSaid() {
  return [...running].map(({ name, lines }) => `${name}: ${lines.slice(-8).join(' | ')}`).join('\n');
}

/** One running program: its last output lines, and a way to end it. */
class Program {
  constructor(name, args) {
    this.name = name;
    this.lines = [];
    this.child = spawn(binary, args, { env, stdio: ['ignore', 'pipe', 'pipe'] });
    running.add(this);
    this.ended = once(this.child, 'close').finally(() => running.delete(this));
    this.printed = '';
    this.child.stdout.on('data', (text) => (this.printed = (this.printed + text).slice(-kept_bytes)));
    for (const stream of [this.child.stdout, this.child.stderr]) {
      stream.setEncoding('utf8').on('data', (text) => this.keep(text));
    }
  }

  keep(text) {
    this.lines.push(...text.split('\n').filter((line) => line !== ''));
    this.lines.splice(0, this.lines.length - kept_lines);
  }

  /** Resolves to the first output line that matches. */
  async says(pattern) {
    const deadline = Date.now() + readyWithin_ms;
    for (;;) {
      const match = this.lines.map((line) => pattern.exec(line)).find(Boolean);
      if (match) return match;
      if (this.child.exitCode !== null) throw new Error(`${this.name} has ended:\n${this.lines.join('\n')}`);
      if (Date.now() > deadline) throw new Error(`${this.name} did not say ${pattern}:\n${this.lines.join('\n')}`);
      await delay(20);
    }
  }

  async end(signal = 'SIGTERM') {
    if (this.child.exitCode === null && this.child.signalCode === null) this.child.kill(signal);
    const late = delay(endWithin_ms, 'late', { ref: false });
    if ((await Promise.race([this.ended, late])) === 'late') {
      this.child.kill('SIGKILL');
      await this.ended;
    }
  }
}

/** Runs a program to its end. Returns the lines of its standard output; throws when it fails. */
export async function run(...args) {
  const program = new Program(args[0], args);
  const [code] = await program.ended;
  if (code !== 0) throw new Error(`${args[0]} has failed:\n${program.lines.join('\n')}`);
  return program.printed.split('\n').filter((line) => line !== '');
}

/** An admin's token for the hub whose state is in the folder `data`. */
export async function adminsToken(data) {
  const [token] = await run('token', '--data', data, '--role', 'admin');
  return token;
}

/**
 * Starts a hub on a free port, or on `port`, with its state in the folder `data`. `more` are options of the program.
 */
export async function startHub(port = 0, { data, more = [] } = {}) {
  const args = ['hub', '--listen', `127.0.0.1:${port}`, '--web', webFolder, '--verbose', ...more];
  const hub = new Program('hub', data ? [...args, '--data', data] : args);
  const [, found] = await hub.says(/open http:\/\/127\.0\.0\.1:(\d+)\//);
  hub.port = Number(found);
  hub.page = `http://127.0.0.1:${found}/`;
  return hub;
}

/** Simulated sensors, of which the first draws the time of capture; `view` says where to stand to read it. */
export async function startClockSensors(hub) {
  const sensors = new Program('bench', ['bench', 'latency', '--clock-sensors', `ws://127.0.0.1:${hub.port}`]);
  const [line] = await sensors.says(/^\{.*"squares".*\}$/);
  sensors.view = JSON.parse(line);
  return sensors;
}

/** Starts hub, aligner, page and these sources in one program. */
export async function startDemo(...sources) {
  const args = ['demo', '--port', '0', '--web', webFolder, '--verbose', ...sources.flatMap((source) => ['--source', source])];
  const demo = new Program('demo', args);
  const [, found] = await demo.says(/open http:\/\/127\.0\.0\.1:(\d+)\//);
  demo.page = `http://127.0.0.1:${found}/`;
  return demo;
}

/** Sensor number `n` of a simulated room, or of the recording `rig`; `log` is a file for one JSON line per frame sent. */
export function startSensor(hub, n, { fps = 5, log, rig, token, room, audio, more = [] } = {}) {
  const args = [
    'sensor',
    '--source',
    rig ? `rig:${rig}#s${n}` : `sim#${n}`,
    '--hub',
    `ws://127.0.0.1:${hub.port}`,
    '--fps',
    String(fps),
    '--wait',
    '--verbose',
  ];
  if (token) args.push('--token', token);
  if (room) args.push('--room', room);
  if (audio) args.push('--audio', audio);
  args.push(...more);
  return new Program(`sensor ${n}`, log ? [...args, '--log-frames', log] : args);
}
