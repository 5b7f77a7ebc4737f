// SPDX-License-Identifier: Apache-2.0
// Runs a roomcast program with hostile arguments or files, and says what it did wrong: died, said nothing, went on for
// ever, took much memory, or passed on what steers a terminal.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';

import { binary } from '../cli/program.mjs';

const obeysWithin_ms = 8_000; // of a machine whose cores are all busy
const mostMemory_mb = 1_500;
const looksEvery_ms = 20;
const documentedCodes = [0, 1, 2];
const keptOutput = 200_000;
const ownFault = /terminate called|internal error|bad_alloc|what\(\)|broke its own promise|Assertion|std::|core dumped/;
const steersTerminal = /[\u0000-\u0008\u000b\u000c\u000e-\u001f\u007f-\u009f\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]/;

/**
 * A command that runs another one where nothing but `folder` can be changed: hostile paths lead anywhere, and root may
 * write everywhere. Nothing is needed for other users.
 */
export function confinedTo(folder) {
  if (process.getuid?.() !== 0) return [];
  const mounts = `mount --bind '${folder}' '${folder}' && mount -o remount,ro,bind / && mount -o remount,ro /dev`;
  const command = ['unshare', '--mount', 'sh', '-c', `${mounts} && cd '${folder}' && exec "$0" "$@"`];
  const isPossible = spawnSync(command[0], [...command.slice(1), 'true']).status === 0;
  return isPossible ? command : undefined;
}

/** What the program wrote and how it ended. `patience_ms`: it is interrupted after this time. */
export async function runAttacked(args, { through, cwd, env, patience_ms }) {
  const [command, ...rest] = [...through, binary, ...args];
  const child = spawn(command, rest, { cwd, env, stdio: ['ignore', 'pipe', 'pipe'] });
  const run = { args, stdout: '', stderr: '', peak_mb: 0, isInterrupted: false, isKilled: false };
  for (const stream of ['stdout', 'stderr']) {
    child[stream].setEncoding('utf8').on('data', (text) => (run[stream] = (run[stream] + text).slice(-keptOutput)));
  }
  const ended = once(child, 'close');
  const memory = setInterval(() => (run.peak_mb = Math.max(run.peak_mb, peakOf_mb(child.pid))), looksEvery_ms);
  const interrupted = setTimeout(() => ((run.isInterrupted = true), child.kill('SIGINT')), patience_ms);
  const killed = setTimeout(() => ((run.isKilled = true), child.kill('SIGKILL')), patience_ms + obeysWithin_ms);
  [run.code, run.signal] = await ended;
  clearInterval(memory);
  [interrupted, killed].forEach(clearTimeout);
  return run;
}

function peakOf_mb(pid) {
  try {
    return Number(/VmHWM:\s+(\d+) kB/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))[1]) / 1000;
  } catch {
    return 0; // it has just ended
  }
}

/** Sentences. A program that handles no interrupt may be ended by ours. */
export function faultsOf(run) {
  const { args, code, signal, stdout, stderr, peak_mb } = run;
  const faults = [];
  if (run.isKilled) faults.push('did not obey an interrupt');
  else if (signal && !(run.isInterrupted && signal === 'SIGINT')) faults.push(`ended by ${signal}`);
  else if (!signal && !documentedCodes.includes(code)) faults.push(`exit code ${code}`);
  if (code > 0 && !/\S/.test(stderr)) faults.push(`exit code ${code} without a sentence`);
  if (code > 0 && /\S/.test(stderr) && !/^roomcast\S*( [a-z-]+)*: \S/.test(lastLine(stderr))) faults.push('the last line is no sentence of ours');
  if (ownFault.test(stderr)) faults.push('tells of a fault of its own');
  if (steersTerminal.test(stderr + stdout)) faults.push('passes on what steers a terminal');
  if (peak_mb > mostMemory_mb) faults.push(`took ${peak_mb.toFixed(0)} MB`);
  const line = args.map((arg) => JSON.stringify(arg.length > 300 ? `${arg.slice(0, 300)}... (${arg.length})` : arg)).join(' ');
  return faults.map((fault) => `${fault}: roomcast ${line}\n${stderr.slice(-600)}`);
}

function lastLine(text) {
  return text.trimEnd().split('\n').at(-1).split('\r').at(-1);
}
