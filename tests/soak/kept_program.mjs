// SPDX-License-Identifier: Apache-2.0
// A roomcast program that runs for as long as the soak: it is started again after each end. An end that nobody asked for
// is a finding. Memory and descriptors are read from /proc.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readdirSync, readFileSync } from 'node:fs';

import { binary } from '../cli/program.mjs';
import { env } from '../state_folder.mjs';

const keptLines = 5; // of stderr
const kibibyte = 1024;
const running = new Set();
process.on('exit', () => running.forEach((child) => child.kill('SIGKILL'))); // also when the soak itself fails

export class KeptProgram {
  lastWords = []; // the newest lines of stderr
  stdout = '';
  #wanted = null; // the end that was asked for: a signal, or 'any' in good order
  #stopped = false;

  /**
   * `args()` gives the arguments of the next start. `onFinding(sentence)` is called for an unasked end, unless
   * `expects(result)` is true for its exit code or signal. `environment` adds environment variables.
   */
  constructor(name, args, { onFinding, expects = () => false, environment = {} }) {
    Object.assign(this, { name, args, onFinding, expects, environment });
    this.#start();
  }

  #start() {
    this.stdout = '';
    this.lastWords = [];
    this.#wanted = null;
    const child = spawn(binary, this.args(), { env: { ...env, ...this.environment }, stdio: ['ignore', 'pipe', 'pipe'] });
    this.child = child;
    running.add(child);
    child.stdout.setEncoding('utf8').on('data', (text) => (this.stdout += text));
    child.stderr.setEncoding('utf8').on('data', (text) => this.#keep(text));
    this.ended = once(child, 'exit').then(([code, signal]) => this.#afterEnd(child, code ?? signal));
  }

  get isRunning() {
    return this.child.exitCode === null && this.child.signalCode === null;
  }

  /** From now on, until the next start, it may end with a reason, or not. */
  mayEnd(may) {
    this.#wanted = may ? 'any' : null;
  }

  /** Ends the program and waits for its end, and its next start. */
  async end(signal) {
    this.#wanted = signal;
    this.child.kill(signal);
    return this.ended;
  }

  /** Ends it for good. Resolves to the exit code or signal. */
  async stop(signal) {
    this.#stopped = true;
    if (!this.isRunning) return this.child.exitCode ?? this.child.signalCode;
    return this.end(signal);
  }

  signal(name) {
    this.child.kill(name);
  }

  /** Nobody reads its stderr any more, as when the reader of a log ends. */
  closeStderr() {
    this.child.stderr.destroy();
  }

  /** {rss_mb, descriptors}; nothing if it has just ended. */
  usage() {
    try {
      const folder = `/proc/${this.child.pid}`;
      const [, kib] = /VmRSS:\s+(\d+) kB/.exec(readFileSync(`${folder}/status`, 'utf8'));
      return { rss_mb: (Number(kib) * kibibyte) / 1e6, descriptors: readdirSync(`${folder}/fd`).length };
    } catch {
      return undefined;
    }
  }

  #keep(text) {
    this.lastWords = [...this.lastWords, ...text.trimEnd().split('\n')].slice(-keptLines);
  }

  #afterEnd(child, result) {
    running.delete(child);
    const wasWanted = this.#wanted === null ? this.expects(result) : this.#isAsWanted(result);
    if (!wasWanted) this.onFinding(`${this.name} ended with ${result}: ${this.lastWords.join(' | ') || 'no word'}`);
    if (!this.#stopped) this.#start();
    return result;
  }

  #isAsWanted(result) {
    if (this.#wanted === 'any') return result === 0 || result === 1 || result === 'SIGKILL'; // no other signal
    return this.#wanted === 'SIGKILL' ? result === 'SIGKILL' : result === 0;
  }
}
