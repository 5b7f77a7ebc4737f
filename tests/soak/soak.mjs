// SPDX-License-Identifier: Apache-2.0
// A hub, two simulated sensors, viewers and recorders run for hours, while faults come one after the other: kills,
// suspensions, a bad network, logs that nobody reads, clocks that are set, a full disk. Prints a summary; exits with 1 if
// a check failed.
//   node tests/soak/soak.mjs --hours 1 --seed 7
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as delay } from 'node:timers/promises';
import { parseArgs } from 'node:util';

import { makeToken } from '../network/admin.mjs';
import { freePort } from '../network/nginx.mjs';
import { WallClock, noWallClocks } from '../network/wall_clock.mjs';
import { BadNetwork } from './bad_network.mjs';
import { faults } from './faults.mjs';
import { Usage, median, table } from './figures.mjs';
import { KeptProgram } from './kept_program.mjs';
import { Pledges } from './pledges.mjs';
import { Recordings } from './recordings.mjs';
import { Witness } from './witness.mjs';

const fps = 5;
const sensorNames = ['a', 'b'];
const mostLoss_s = 1.1; // of a recording's end
const wellWithin_ms = 30_000;
const givesUpAfter_ms = 120_000;
const staysWellFor_ms = 2_000;
const longestPause_ms = 3_000;
const endsWithin_ms = 20_000;
const leastSamples = 6; // of a program's life, to speak of growth
const mostDescriptorGrowth = 3;
const mostFindings = 50;
const hour_ms = 3_600_000;

const { values: options } = parseArgs({
  options: { hours: { type: 'string', default: '1' }, seed: { type: 'string', default: '1' }, growth: { type: 'string' } },
});
const hours = Number(options.hours);
const seed = Number(options.seed);
if (!(hours > 0) || !Number.isInteger(seed) || seed < 1) {
  console.error('usage: soak --hours H [--seed N] [--growth PERCENT]; N is a whole number from 1');
  process.exit(2);
}
/** A short run has not yet allocated what it will keep. */
const mostGrowth_percent = Number(options.growth ?? (hours >= 1 ? 2 : 10));

/** The same numbers in [0, 1) in every run, from a linear congruential generator (Park and Miller 1988). */
function randomNumbers(start) {
  let state = start % 0x7fffffff || 1;
  return () => (state = (state * 48_271) % 0x7fffffff) / 0x7fffffff;
}

const random = randomNumbers(seed);
const startedAt_ms = Date.now();
const findings = [];
const recoveries = new Map(); // fault -> [seconds until the room was well again]
const usage = new Usage();
let faultCount = 0;
let faultIsOn = false;
let pictures = 0;
let isOver = false;

function say(text) {
  console.log(`${((Date.now() - startedAt_ms) / 1000).toFixed(0).padStart(6)} s  ${text}`);
}

function onFinding(sentence) {
  findings.push(sentence);
  say(`FOUND: ${sentence}`);
  if (findings.length >= mostFindings) isOver = true;
}

/** Everything that runs. */
async function startRoom(folder) {
  const data = join(folder, 'data');
  const admin = (await makeToken(data, '--role', 'admin', '--ttl', '30d')).token;
  const port = await freePort();
  const url = `ws://127.0.0.1:${port}`;
  const hubArgs = ['hub', '--listen', `127.0.0.1:${port}`, '--data', data, '--verbose'];
  const clocks = noWallClocks ? [] : [new WallClock(folder), new WallClock(folder)];
  const [ofHub, ofSensor] = clocks.map(({ environment }) => environment);
  const hub = new KeptProgram('hub', () => hubArgs, { onFinding, environment: ofHub });
  const network = await BadNetwork.start(port, random);
  const sensor = (n, at) => [
    ...['sensor', '--source', `sim#${n}`, '--sensors', '2', '--fps', String(fps), '--name', sensorNames[n], '--hub', at],
    ...['--wait', '--verbose'],
  ];
  const sensors = [
    new KeptProgram('sensor a', () => sensor(0, url), { onFinding, environment: ofSensor }),
    new KeptProgram('sensor b', () => sensor(1, `ws://127.0.0.1:${network.port}`), { onFinding }),
  ];
  let recordingNumber = 0;
  const recorderFile = () => join(folder, `room${recordingNumber}.mcap`);
  const witness = new Witness(url);
  const soak = {
    ...{ folder, port, url, admin, hub, sensors, clocks, network, witness, random, recorderFile, onFinding },
    recordings: new Recordings(onFinding, mostLoss_s),
    pledges: new Pledges(port, admin, { random, onFinding }),
  };
  await becomesWell(soak, 'the start');
  const nextRecording = () => {
    ++recordingNumber;
    return ['record', recorderFile(), '--hub', url, '--verbose'];
  };
  soak.recorder = new KeptProgram('recorder', nextRecording, { onFinding });
  soak.viewer = startViewer(folder, url);
  return soak;
}

/** Draws one picture after the other. One that fails while there are faults is no finding. */
function startViewer(folder, url) {
  let faultsBefore = 0;
  const args = () => {
    faultsBefore = faultIsOn ? faultCount - 1 : faultCount; // it may begin in the midst of one
    return ['view', '--hub', url, '--headless', '--size', '160,120', '--seconds', '4', '--png', join(folder, 'room.png')];
  };
  const expects = (result) => {
    pictures += result === 0 ? 1 : 0;
    return result === 0 || (result === 1 && faultCount > faultsBefore);
  };
  return new KeptProgram('viewer', args, { onFinding, expects });
}

function isWell({ witness, recorder }) {
  return witness.sees(sensorNames) && (!recorder || (recorder.isRunning && witness.people().includes('recorder')));
}

/** Waits until frames of both sensors come, and the recorder is there, for a while. Returns the time until then. */
async function becomesWell(soak, after) {
  soak.witness.forget();
  const began_ms = Date.now();
  let since_ms = null;
  let isLate = false;
  for (;;) {
    const now_ms = Date.now();
    if (!isWell(soak)) since_ms = null;
    else since_ms ??= now_ms;
    if (since_ms && now_ms - since_ms >= staysWellFor_ms) return (since_ms - began_ms) / 1000;
    if (!isLate && now_ms - began_ms > wellWithin_ms) {
      isLate = true;
      onFinding(`the room is not well ${wellWithin_ms / 1000} s after: ${after}`);
    }
    if (now_ms - began_ms > givesUpAfter_ms) throw new Error(`the room does not come back after: ${after}`);
    await delay(50);
  }
}

/** One fault after the other, each as often as the others; early ones come first. */
function* chosenFaults() {
  for (let round = 0; ; ++round) {
    const shuffled = faults.map((fault) => ({ fault, key: random() - (round === 0 && fault.early ? 1 : 0) }));
    yield* shuffled.sort((a, b) => a.key - b.key).map(({ fault }) => fault);
  }
}

async function injectFaults(soak, end_ms) {
  const half_ms = (Date.now() + end_ms) / 2;
  for (const fault of chosenFaults()) {
    if (isOver || Date.now() >= end_ms) return;
    const isSecondHalf = Date.now() > half_ms;
    if ((fault.early && isSecondHalf) || (fault.isPossible && !fault.isPossible())) continue;
    ++faultCount;
    faultIsOn = true;
    const isSkipped = (await fault.run(soak)) === 'skipped';
    const recovery_s = isSkipped ? 0 : await becomesWell(soak, fault.name);
    faultIsOn = false;
    if (isSkipped) continue;
    soak.sensors.forEach((sensor) => sensor.mayEnd(false));
    ++faultCount; // for a picture that was begun while the room was coming back
    recoveries.set(fault.name, [...(recoveries.get(fault.name) ?? []), recovery_s]);
    say(`${fault.name}: well again after ${recovery_s.toFixed(1)} s`);
    await soak.pledges.check();
    await delay(random() * longestPause_ms);
    if (isSecondHalf) [soak.hub, ...soak.sensors].forEach((program) => usage.add(program));
  }
}

async function endsInTime(program, signal) {
  const result = await Promise.race([program.stop(signal), delay(endsWithin_ms, 'late', { ref: false })]);
  if (result !== 'late') return;
  onFinding(`${program.name} does not end within ${endsWithin_ms / 1000} s of ${signal}`);
  program.signal('SIGKILL');
}

async function endRoom(soak) {
  const { recorder, viewer, sensors, hub, network, witness, recordings, recorderFile } = soak;
  if (viewer) await viewer.stop('SIGKILL');
  if (recorder) {
    const lastFrameAt_ms = witness.lastFrameAt_ms;
    await endsInTime(recorder, 'SIGINT');
    await recordings.check(recorderFile(), { wasKilled: false, lastFrameAt_ms });
  }
  await Promise.all(sensors.map((sensor) => endsInTime(sensor, 'SIGTERM')));
  await witness.end();
  network.close();
  await endsInTime(hub, 'SIGTERM');
}

function checkGrowth(rows) {
  for (const { name, growth_percent, descriptors } of rows) {
    if (growth_percent > mostGrowth_percent)
      onFinding(`the memory of ${name} grew by ${growth_percent.toFixed(1)} %, more than ${mostGrowth_percent} %`);
    if (descriptors && descriptors[1] - descriptors[0] > mostDescriptorGrowth)
      onFinding(`${name} has ${descriptors[1]} open descriptors, ${descriptors[0]} before`);
  }
}

function printSummary({ recordings, pledges, witness }, rows) {
  const faultRows = [...recoveries].map(([name, times]) =>
    [name, times.length, median(times).toFixed(1), Math.max(...times).toFixed(1)]);
  console.log(`\n${table(['fault', 'times', 'well again: median s', 'longest s'], faultRows)}\n`);
  const used = rows.map(({ name, samples, first, last, growth_percent, descriptors }) =>
    first === undefined
      ? [name, samples, '-', '-', '-', '-']
      : [name, samples, first.toFixed(1), last.toFixed(1), growth_percent.toFixed(1), descriptors.join(' -> ')]);
  console.log(`${table(['memory, second half', 'samples', 'first MB', 'last MB', 'growth %', 'descriptors'], used)}\n`);
  const { finished, killed, worstLoss_s } = recordings;
  console.log(`recordings: ${finished} finished, ${killed} of killed recorders; at most ${worstLoss_s.toFixed(2)} s lost`);
  console.log(`acknowledged writes: ${pledges.acknowledged}, lost: ${pledges.lost}`);
  const lasted_h = ((Date.now() - startedAt_ms) / hour_ms).toFixed(2);
  console.log(`pictures drawn: ${pictures}; frames seen: ${witness.framesSeen}; seed ${seed}, ${lasted_h} h`);
  console.log(findings.length === 0 ? '\nnothing found' : `\n${findings.length} found:\n  ${findings.join('\n  ')}`);
}

async function main() {
  const folder = mkdtempSync(join(tmpdir(), 'roomcast-soak-'));
  process.once('SIGINT', () => (isOver = true));
  const soak = await startRoom(folder);
  try {
    await becomesWell(soak, 'the start of the recorder');
    await injectFaults(soak, startedAt_ms + hours * hour_ms);
  } catch (error) {
    onFinding(error.message);
  }
  await endRoom(soak);
  const rows = usage.rows(leastSamples);
  checkGrowth(rows);
  printSummary(soak, rows);
  if (findings.length === 0) rmSync(folder, { recursive: true, force: true });
  else console.log(`\nwhat is left is in ${folder}`);
  process.exit(findings.length === 0 ? 0 : 1);
}

await main();
