// SPDX-License-Identifier: Apache-2.0
// Memory and processor time of Chromium's processes, from /proc. The browser itself lists its processes.
import { readFileSync, readdirSync } from 'node:fs';

const ticksPerSecond = 100; // Linux's USER_HZ

/** Process ids by kind: 'browser', 'GPU', 'renderer', ... */
export async function processesOf(context) {
  const session = await context.browser().newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  return processInfo.map(({ id, type }) => ({ pid: id, type }));
}

/** Resident memory, MB. */
export function residentMb(pid) {
  const [, kb] = /VmRSS:\s+(\d+) kB/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'));
  return kb / 1024;
}

/** Processor time of each thread so far, seconds, by thread name. */
export function threadSeconds(pid) {
  const seconds = new Map();
  for (const task of readdirSync(`/proc/${pid}/task`)) {
    const stat = readFileSync(`/proc/${pid}/task/${task}/stat`, 'utf8');
    const name = stat.slice(stat.indexOf('(') + 1, stat.lastIndexOf(')'));
    const fields = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
    seconds.set(name, (seconds.get(name) ?? 0) + (Number(fields[11]) + Number(fields[12])) / ticksPerSecond);
  }
  return seconds;
}
