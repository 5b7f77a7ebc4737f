// SPDX-License-Identifier: Apache-2.0
// Measures the idle capacity of the machine, for tests that measure time.
import { readFileSync } from 'node:fs';
import { setTimeout as delay } from 'node:timers/promises';

const look_ms = 300;
const ticksPerSecond = 100;

/** Ticks of all cores that were idle or used by low-priority work. */
function freeTicks() {
  const [, , nice, , idle] = readFileSync('/proc/stat', 'utf8').split('\n')[0].split(/\s+/).map(Number);
  return nice + idle;
}

/** Free cores, averaged over a short time. */
export async function freeCores() {
  const began_ms = performance.now();
  const before = freeTicks();
  await delay(look_ms);
  return (((freeTicks() - before) / ticksPerSecond) * 1000) / (performance.now() - began_ms);
}

/** Waits until `wanted` cores are free, at most `within_ms`. Returns the number of free cores. */
export async function untilQuiet(wanted = 0.8, within_ms = 6_000) {
  const deadline = performance.now() + within_ms;
  for (;;) {
    const free = await freeCores();
    if (free >= wanted || performance.now() > deadline) return free;
  }
}
