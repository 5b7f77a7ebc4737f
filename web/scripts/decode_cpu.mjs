// SPDX-License-Identifier: Apache-2.0
// npm run decode-cpu: what decoding costs in a real Chromium: processor time of the page's threads that receive and
// decode (worker, WebCodecs' threads, network), per frame, and as a share of one core for four sensors at 30 fps.
// Drawing is not counted. The frames are those of a simulated room, recorded first, so that the recording's encoders
// run at whatever speed they can.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as delay } from 'node:timers/promises';
import { openPage, startBrowser } from '../../tests/e2e/browser.mjs';
import { processesOf, threadSeconds } from '../../tests/e2e/chromium_processes.mjs';
import { requireBuilt, run, startHub, startSensor } from '../../tests/e2e/programs.mjs';
import { sensorsOf, untilAllShown } from '../../tests/e2e/waiting.mjs';

const sensors = 4;
const fps = 30;
const measured_s = 30;
const notDecoding = /^(CrRendererMain|chromium|Compositor)/; // the page's own thread, and drawing

/** Seconds of all threads that decode. */
function decodingSeconds(pids) {
  const all = pids.flatMap((pid) => [...threadSeconds(pid)]);
  return all.filter(([name]) => !notDecoding.test(name)).reduce((sum, [, seconds]) => sum + seconds, 0);
}

async function measure(page, pids) {
  const framesOf = async () => (await sensorsOf(page)).reduce((sum, { frames }) => sum + frames, 0);
  const before = { frames: await framesOf(), seconds: decodingSeconds(pids) };
  await delay(1000 * measured_s);
  const frames = (await framesOf()) - before.frames;
  const ms = (1000 * (decodingSeconds(pids) - before.seconds)) / frames;
  return { frames, ms };
}

requireBuilt();
const folder = mkdtempSync(join(tmpdir(), 'roomcast-decode-'));
const ends = [() => rmSync(folder, { recursive: true, force: true })];
try {
  const rig = join(folder, 'rig');
  console.log('recording a simulated room …');
  await run(
    'simulate',
    rig,
    '--sensors',
    String(sensors),
    '--fps',
    String(fps),
    '--seconds',
    '1',
    '--half-color',
    '--views',
    '0',
  );
  const hub = await startHub();
  ends.push(() => hub.end());
  for (let n = 0; n < sensors; n++) {
    const sensor = startSensor(hub, n, { rig });
    ends.push(() => sensor.end());
  }
  const browser = await startBrowser({ width: 160, height: 120 });
  ends.push(() => browser.end());
  const page = await openPage(browser.context, `${hub.page}?panel=0&mode=points`);
  await untilAllShown(page, sensors);
  const renderers = (await processesOf(browser.context))
    .filter(({ type }) => type === 'renderer')
    .map(({ pid }) => pid);
  console.log(`measuring for ${measured_s} s …`);
  const { frames, ms } = await measure(page, renderers);
  const share = (ms * sensors * fps) / 1000;
  console.log(`${frames} frames decoded; ${ms.toFixed(2)} ms of processor time each`);
  console.log(
    `${sensors} sensors at ${fps} fps: ${(100 * share).toFixed(0)} % of one core (simulated room, live codec)`,
  );
} finally {
  for (const end of ends.reverse()) await end();
}
