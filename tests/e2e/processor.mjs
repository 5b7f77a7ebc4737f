// SPDX-License-Identifier: Apache-2.0
// How much of the machine nobody needs: for tests that look at time.
import { readFileSync } from 'node:fs';
import { setTimeout as delay } from 'node:timers/promises';

const look_ms = 300;
const ticksPerSecond = 100;

/** Of all cores: idle, or with what gives way to everybody else. */
function freeTicks() {
  const [, , nice, , idle] = readFileSync('/proc/stat', 'utf8').split('\n')[0].split(/\s+/).map(Number);
  return nice + idle;
}

/** In cores, over a moment. */
export async function freeCores() {
  const began_ms = performance.now();
  const before = freeTicks();
  await delay(look_ms);
  return (((freeTicks() - before) / ticksPerSecond) * 1000) / (performance.now() - began_ms);
}

/** Waits until a good part of a core is free, or as long as that makes sense. Returns how many are. */
export async function untilQuiet(wanted = 0.8, within_ms = 6_000) {
  const deadline = performance.now() + within_ms;
  for (;;) {
    const free = await freeCores();
    if (free >= wanted || performance.now() > deadline) return free;
  }
}
