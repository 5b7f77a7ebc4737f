// SPDX-License-Identifier: Apache-2.0
// Waits for a state of the page through window.roomcast, with a deadline and a message that shows the last state.
import { setTimeout as delay } from 'node:timers/promises';
import { whatProgramsSaid } from './programs.mjs';

const poll_ms = 50;
const patience_ms = 60_000; // with software rendering and other programs running, a picture takes seconds

/** Time limit of a test. */
export const slow = { timeout: 3 * patience_ms };

/** Calls `ask` until `enough` is true of the answer, and returns the answer. */
export async function until(what, ask, enough, within_ms = patience_ms) {
  const deadline = Date.now() + within_ms;
  for (;;) {
    const answer = await ask();
    if (enough(answer)) return answer;
    if (Date.now() > deadline) {
      const last = JSON.stringify(answer);
      throw new Error(`${what}: not within ${within_ms} ms; last: ${last}\n${whatProgramsSaid()}`);
    }
    await delay(poll_ms);
  }
}

export const stateOf = (page) => page.evaluate(() => window.roomcast.state());
export const viewOf = (page) => page.evaluate(() => window.roomcast.view());
/** Of two points. */
export const distance = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));
export const sensorsOf = (page) => page.evaluate(() => window.roomcast.sensors());
export const coverageOf = (page) => page.evaluate(() => window.roomcast.coverage());
export const panelText = (page) => page.locator('#panel').innerText();

/** Waits until the view stays the same from one picture to the one after the next: it may be on its way to somewhere. */
export function untilStill(page) {
  const moves = async () => {
    const [{ pictures }, before] = [await stateOf(page), await viewOf(page)];
    await until('two pictures', () => stateOf(page), (now) => now.pictures >= pictures + 2);
    return JSON.stringify(await viewOf(page)) !== JSON.stringify(before);
  };
  return until('the view stands still', moves, (does) => !does);
}

/** Waits until `count` sensors are online and a frame of each has been drawn. */
export function untilAllShown(page, count) {
  const shown = (sensors) => sensors.filter((sensor) => sensor.online && sensor.shownSeq !== null).length === count;
  return until(`${count} sensors drawn`, () => sensorsOf(page), shown);
}
