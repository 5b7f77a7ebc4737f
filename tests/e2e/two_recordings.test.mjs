// SPDX-License-Identifier: Apache-2.0
// Two recordings as two Azure Kinects on a sync cable make them (.mkv), of one simulated room, without poses: `roomcast demo` joins
// and aligns them, and a person sees one room.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { binary, requireBuilt, run, startDemo } from './programs.mjs';
import { coverageOf, sensorsOf, slow, until, untilAllShown } from './waiting.mjs';

const writer = join(dirname(binary), 'roomcast_azure_recordings');
const fps = 6;
const worst_m = 0.03;
const worst_deg = 0.6;
const alignedWithin_ms = 150_000; // the aligner gives way to all else that a busy machine does

const folder = mkdtempSync(join(tmpdir(), 'roomcast-recordings-'));
const rig = join(folder, 'rig');
let demo, browser, page;

/** a_from_b of two row-major rigid transforms world_from_a, world_from_b. */
function between(worldFromA, worldFromB) {
  const product = Array(16).fill(0);
  const inverse = [0, 1, 2].flatMap((y) => {
    const row = [0, 1, 2].map((x) => worldFromA[4 * x + y]);
    return [...row, -row.reduce((sum, value, x) => sum + value * worldFromA[4 * x + 3], 0)];
  });
  inverse.push(0, 0, 0, 1);
  for (let y = 0; y < 4; ++y) for (let x = 0; x < 4; ++x) for (let k = 0; k < 4; ++k) product[4 * y + x] += inverse[4 * y + k] * worldFromB[4 * k + x];
  return product;
}

function difference(a, b) {
  const moved = between(a, b);
  const cosine = (moved[0] + moved[5] + moved[10] - 1) / 2;
  return { metres: Math.hypot(moved[3], moved[7], moved[11]), degrees: (Math.acos(Math.min(1, cosine)) * 180) / Math.PI };
}

describe('a room of two .mkv recordings', { skip: existsSync(writer) ? false : `${writer} is not built` }, () => {
  before(async () => {
    requireBuilt();
    const room = ['--scene', 'office', '--camera', 'azure', '--sensors', '2', '--clock-offset', '0', '--drops', '0', '--seed', '4'];
    await run('simulate', rig, ...room, '--seconds', '3', '--fps', String(fps), '--views', '0');
    execFileSync(writer, [rig, folder]);
    demo = await startDemo(`mkv:${join(folder, 's0.mkv')}`, `mkv:${join(folder, 's1.mkv')}`);
    browser = await startBrowser({ width: 480, height: 320 });
    page = await openPage(browser.context, `${demo.page}?panel=0&at=0,1.7,2&look=0,0.9,-1`);
  }, slow);

  after(async () => {
    await browser?.end();
    await demo?.end();
    rmSync(folder, { recursive: true, force: true });
  }, slow);

  test('is joined by the cable and seen: each sensor at pixels of its own', slow, async () => {
    await untilAllShown(page, 2);
    assert.ok(demo.lines.some((line) => /the recordings are joined by/.test(line)), demo.lines.join('\n'));
    for (const { id, only } of await coverageOf(page)) assert.ok(only > 200, `sensor ${id} alone covers ${only} pixels`);
    assert.deepEqual(page.complaints, []);
  });

  test('is aligned as the room was', slow, async () => {
    const areEstimated = (sensors) => sensors.length === 2 && sensors.every(({ source }) => source === 'estimated');
    const sensors = await until('two estimated poses', () => sensorsOf(page), areEstimated, alignedWithin_ms);
    const truth = JSON.parse(readFileSync(join(rig, 'rig.json'), 'utf8')).sensors;
    const [a, b] = ['s0', 's1'].map((name) => sensors.find((sensor) => sensor.name === name).worldFromDepth);
    const { metres, degrees } = difference(between(a, b), between(truth[0].world_from_depth, truth[1].world_from_depth));
    assert.ok(metres < worst_m && degrees < worst_deg, `${metres} m, ${degrees} degrees`);
  });
});
