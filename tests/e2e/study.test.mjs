// SPDX-License-Identifier: Apache-2.0
// A study with real people’s steps: a participant agrees, goes through two conditions with questionnaires, and what is
// exported is what was done and measured. Then what can go wrong: a reload, a hub that goes away, erasure, and who declines.
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { seriousFindings } from './accessibility.mjs';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, run, startHub, startSensor } from './programs.mjs';
import { sensorsOf, slow, stateOf, until, untilAllShown } from './waiting.mjs';

const plan = `[study]
name = "delay"
title = "A remote room"
consent = "We keep where you look and what you answer, under a number."
thanks = "Thank you, we are done."

[[condition]]
name = "live"
seconds = 6
instruction = "Look at the table."

[[condition]]
name = "late"
seconds = 6
latency_ms = 1500
mode = "points"
sensors_off = ["s1", "s9"]
voice = false

[[questionnaire]]
name = "presence"
title = "How it was"
when = ["after-condition"]
  [[questionnaire.item]]
  name = "there"
  text = "I had the feeling of being in that room."
  labels = ["not at all", "very much"]
  [[questionnaire.item]]
  name = "found"
  text = "Did you see the table?"
  choices = ["yes", "no"]
  [[questionnaire.item]]
  name = "remarks"
  text = "Anything else?"
  kind = "text"
  required = false

[[comparison]]
name = "believable"
real = "photographs"
drawn = "drawn"

[[questionnaire]]
name = "sick"
at_s = [3]
  [[questionnaire.item]]
  name = "now"
  text = "How sick do you feel, from 0 to 20?"
  kind = "number"
`;

const folder = mkdtempSync(join(tmpdir(), 'roomcast-study-'));
const planFile = join(folder, 'plan.toml');
const sessions = join(folder, 'sessions');
let hub, sensors, browser;

/** A PNG of one colour, 2x2: what is on it does not matter here. */
const png = (color) => Buffer.from({ red: 'iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEElEQVR4nGP4z8AARAwQCgAf7gP9i18U1AAAAABJRU5ErkJggg==', blue: 'iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAD0lEQVR4nGNgYPgPRmAKABf2A/1+6zfzAAAAAElFTkSuQmCC' }[color], 'base64');

/** Red is the photograph: chooses by what is on the canvases, as a person does. */
async function chooseRed(page) {
  const sides = page.locator('.comparing button');
  await sides.first().waitFor();
  const isRed = await sides.locator('canvas').evaluateAll((canvases) => canvases.map((canvas) => canvas.getContext('2d').getImageData(0, 0, 1, 1).data[0] > 128));
  await sides.nth(isRed.indexOf(true)).click();
}

const start = (port = 0) => startHub(port, { data: join(folder, 'data'), more: ['--study', planFile, '--study-folder', sessions, '--record'] });
const open = (context = browser.context, more = '') => openPage(context, `${hub.page}?study=1&at=0.2,1.7,2.6&look=0,0.9,-1${more}`);
const sheet = (page) => page.locator('#study-sheet');
const button = (page, name) => page.getByRole('button', { name, exact: true });
const heading = (page, text) => page.getByRole('heading', { name: text, exact: true }).waitFor();
const bar = (page) => page.locator('#study-bar');

/** The rows of a CSV file as objects. */
function read(csv, name) {
  const [head, ...rows] = readFileSync(join(csv, `${name}.csv`), 'utf8').trim().split('\r\n');
  const cells = (line) => [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].slice(0, head.split(',').length).map(([, cell]) => cell.replace(/^"|"$/g, '').replaceAll('""', '"'));
  return rows.map((row) => Object.fromEntries(cells(row).map((cell, i) => [head.split(',')[i], cell])));
}

async function exported(name) {
  const csv = join(folder, name);
  await run('study', 'export', sessions, '--csv', csv);
  return csv;
}

function logOf(participant) {
  const log = join(sessions, 'participants', participant, 'log.jsonl');
  return existsSync(log) ? readFileSync(log, 'utf8') : '';
}

async function agree(page) {
  await button(page, 'I agree and want to take part').click();
  const text = await page.getByText(/Your number in this study is/).innerText();
  await button(page, 'Continue').click();
  return /P\d+/.exec(text)[0];
}

async function answerSick(page, value) {
  await page.getByLabel('How sick do you feel').fill(String(value));
  await button(page, 'Continue').click();
}

async function answerPresence(page, there, found, remarks = '') {
  await heading(page, 'How it was');
  await page.getByRole('group', { name: 'I had the feeling' }).getByRole('radio').nth(there - 1).check();
  await page.getByLabel(found, { exact: true }).check();
  if (remarks) await page.getByLabel('Anything else?').fill(remarks);
  await button(page, 'Continue').click();
}

before(async () => {
  requireBuilt();
  writeFileSync(planFile, plan);
  for (const [kind, color] of [['photographs', 'red'], ['drawn', 'blue']]) {
    mkdirSync(join(folder, kind));
    for (const name of ['desk', 'door']) writeFileSync(join(folder, kind, `${name}.png`), png(color));
  }
  hub = await start();
  sensors = [0, 1].map((n) => startSensor(hub, n, { fps: 5 }));
  browser = await startBrowser({ width: 1000, height: 640 });
}, slow);

after(async () => {
  await browser?.end();
  for (const sensor of sensors ?? []) await sensor.end();
  await hub?.end();
  rmSync(folder, { recursive: true, force: true });
}, slow);

describe('a participant', () => {
  let page, participant, latencies, csv;

  test('reads what is kept before anything is', slow, async () => {
    page = await open();
    await heading(page, 'A remote room');
    await page.getByText('We keep where you look and what you answer').waitFor();
    assert.deepEqual(readdirSync(join(sessions, 'participants')), []);
    assert.deepEqual(await seriousFindings(page), []);
    participant = await agree(page);
    assert.equal(participant, 'P001');
  });

  test('goes through two conditions, and is asked in between', slow, async () => {
    await heading(page, 'Part 1 of 2');
    await sheet(page).getByText('Look at the table.').waitFor();
    await untilAllShown(page, 2); // behind the sheet: on a busy machine the first picture takes as long as the whole part
    await button(page, 'Start').click();
    await bar(page).getByText(/left/).waitFor();
    assert.ok(await page.locator('#panel').isHidden(), 'nothing else changes the condition');
    assert.deepEqual(await seriousFindings(page), []);
    await page.evaluate(() => window.roomcast.setView([0.5, 1.6, 0.5], [0, 1, -1]));
    await page.getByLabel('How sick do you feel').waitFor();
    const { latency_ms: live } = await stateOf(page);
    assert.deepEqual(await seriousFindings(page), []);
    await answerSick(page, 0);
    await heading(page, 'How it was');
    await button(page, 'Continue').click();
    await page.getByText('2 answers are missing.').waitFor();
    await answerPresence(page, 6, 'yes', 'It was "nice",\nreally');

    await heading(page, 'Part 2 of 2');
    await button(page, 'Start').click();
    await page.getByLabel('How sick do you feel').waitFor();
    const { latency_ms: late } = await stateOf(page);
    latencies = { live, late };
    assert.equal(await page.evaluate(() => window.roomcast.state().mode), 'points');
    await answerSick(page, 2.5);
    await answerPresence(page, 3, 'no');
    await page.getByText('Which of the two is a photograph?').waitFor();
    await page.getByText('Pair 1 of 2').waitFor();
    assert.deepEqual(await seriousFindings(page), []);
    await chooseRed(page);
    await page.getByText('Pair 2 of 2').waitFor();
    await chooseRed(page);
    await heading(page, 'You are done');
    await page.getByText('Thank you, we are done.').waitFor();
    await page.getByText('All is sent.').waitFor();
    assert.deepEqual(page.complaints, []);
  });

  test('is exported as it was', slow, async (t) => {
    csv = await exported('csv');
    assert.deepEqual(read(csv, 'participants').map(({ participant: id, order, steps }) => [id, order, steps]), [['P001', 'live late', '5']]);
    const answers = read(csv, 'answers').map(({ condition, questionnaire, item, value, at_s }) => [condition, questionnaire, item, value, at_s]);
    assert.deepEqual(answers, [
      ['live', 'sick', 'now', '0', '3'],
      ['', 'presence', 'there', '6', '0'],
      ['', 'presence', 'found', 'yes', '0'],
      ['', 'presence', 'remarks', 'It was "nice",\nreally', '0'],
      ['late', 'sick', 'now', '2.5', '3'],
      ['', 'presence', 'there', '3', '0'],
      ['', 'presence', 'found', 'no', '0'],
      ['', 'presence', 'remarks', '', '0'],
    ]);
    const steps = read(csv, 'steps').map(({ step, name, begins }) => [step, name, begins]);
    const compared = read(csv, 'comparisons');
    assert.deepEqual(compared.map(({ pair }) => pair).sort(), ['desk', 'door']);
    assert.ok(compared.every(({ left, chosen, correct }) => correct === 'true' && (left === 'real') === (chosen === 'left')), JSON.stringify(compared));
    const expected = ['live', 'presence', 'late', 'presence', 'believable'].flatMap((name, step) => [[`${step}`, name, 'true'], [`${step}`, name, 'false']]);
    assert.deepEqual(steps, expected);
    for (const name of ['live', 'late']) {
      const poses = read(csv, 'poses').filter(({ condition }) => condition === name);
      assert.ok(poses.length > 45, `${poses.length} poses in ${name}`);
    }
    const last = read(csv, 'poses').filter(({ condition }) => condition === 'live').at(-1);
    assert.deepEqual([last.x, last.y, last.z].map(Number), [0.5, 1.6, 0.5]);
    const shown = (name) => read(csv, 'sensors').filter(({ condition, sensor }) => condition === name && sensor === 's1').map((row) => row.shown);
    assert.ok(shown('live').every((is) => is === 'true') && shown('late').every((is) => is === 'false'), `${shown('late')}`);
    assert.ok(read(csv, 'page').some(({ what, note }) => what === 'trouble' && /no sensor "s9"/.test(note)));
    const median = (name) => {
      const of = read(csv, 'figures').filter(({ condition }) => condition === name).map((row) => Number(row.latency_ms)).filter((ms) => ms > 0);
      return of.sort((a, b) => a - b)[of.length >> 1];
    };
    const added = median('late') - median('live');
    t.diagnostic(`latency logged: live ${median('live')} ms, late ${median('late')} ms; on the page ${JSON.stringify(latencies)}`);
    assert.ok(added > 1000 && added < 2500, `${added} ms were added`);
    await run('study', 'report', sessions, '--out', join(folder, 'report'));
    const means = read(join(folder, 'report'), 'summary').map(({ measure, condition, mean }) => [measure, condition, Number(mean)]);
    assert.deepEqual(means.filter(([measure]) => measure === 'presence.there'), [['presence.there', 'live', 6], ['presence.there', 'late', 3]]);
    const latency = Object.fromEntries(means.filter(([measure]) => measure === 'latency_ms').map(([, name, mean]) => [name, mean]));
    assert.deepEqual(latency, { live: median('live'), late: median('late') });
    assert.match(readFileSync(join(folder, 'report', 'report.html'), 'utf8'), /I had the feeling of being in that room\.[^]*believable<td>2<td>2<td>100 %/);
    const dictionary = read(csv, 'data_dictionary');
    assert.ok(dictionary.every(({ file, column }) => file && column));
  });
});

describe('what a participant saw', () => {
  test('is found in a recording of the room', slow, async () => {
    const [file] = readdirSync(join(folder, 'data', 'recordings'));
    const recording = join(folder, 'data', 'recordings', file);
    const lines = await run('study', 'replay', sessions, 'P001', '--recording', recording, '--out', join(folder, 'seen by P001'), '--json');
    const { conditions } = JSON.parse(lines.join('\n'));
    assert.deepEqual(conditions.map(({ condition }) => condition), ['live', 'late']);
    const [live, late] = conditions;
    assert.ok(late.to_s - late.from_s > 5.5 && late.from_s > live.to_s - 1.5, lines.join());
    assert.match(late.command, /export .*--format video --out '.*seen by P001\/late' --path '.*late\.json' --from [\d.]+ --to [\d.]+ --mode points$/);
    const { keys } = JSON.parse(readFileSync(live.path, 'utf8'));
    assert.deepEqual(keys.at(-1).at, [0.5, 1.6, 0.5]);
  });
});

describe('a session', () => {
  test('goes on after a reload, in the order of the next row', slow, async () => {
    const page = await open();
    const participant = await agree(page);
    await heading(page, 'Part 1 of 2');
    await button(page, 'Start').click();
    await answerSick(page, 1);
    await answerPresence(page, 1, 'no');
    await heading(page, 'Part 2 of 2');
    await until('what was answered is sent', () => logOf(participant), (text) => /"item":"found"/.test(text));
    await page.reload();
    await heading(page, 'Part 2 of 2');
    await button(page, 'Start').click();
    await button(page, 'Stop taking part').click();
    await button(page, 'Stop for good?').click();
    await page.getByRole('heading', { name: 'You have stopped' }).waitFor();
    await page.getByText('All is sent.').waitFor();
    const csv = await exported('csv-reload');
    assert.equal(read(csv, 'participants').find((row) => row.participant === participant).order, 'late live');
    const own = (name) => read(csv, name).filter((row) => row.participant === participant);
    assert.equal(own('page').filter(({ what }) => what === 'loaded').length, 1);
    assert.deepEqual(own('answers').map(({ value }) => value), ['1', '1', 'no', '']);
    const times = own('poses').map(({ t_s }) => Number(t_s));
    assert.deepEqual(times, [...times].sort((a, b) => a - b), 'time goes on');
    await page.close();
  });

  test('waits for a hub that has gone away, and loses nothing', slow, async () => {
    const page = await open();
    const participant = await agree(page);
    await button(page, 'Start').click();
    await page.getByLabel('How sick do you feel').waitFor();
    const { port } = hub;
    await hub.end('SIGKILL');
    await answerSick(page, 7);
    await answerPresence(page, 4, 'yes');
    await delay(2500);
    hub = await start(port);
    await heading(page, 'Part 2 of 2');
    await until('it is sent', () => logOf(participant), (text) => /"value":7/.test(text));
    await page.close();
  });

  test('of an erased participant ends with a sentence', slow, async () => {
    const page = await open();
    const participant = await agree(page);
    await delay(2500);
    await run('study', 'erase', sessions, participant);
    await page.getByText(/Your session cannot go on/).waitFor();
    assert.ok(!existsSync(join(sessions, 'participants', participant)));
    await page.reload();
    await button(page, 'Begin anew').click();
    await button(page, 'I agree and want to take part').waitFor();
    await page.close();
  });

  test('of who declines is none', slow, async () => {
    const count = readdirSync(join(sessions, 'participants')).length;
    const page = await open();
    await button(page, 'I do not want to take part').click();
    await page.getByText('Nothing was kept.').waitFor();
    assert.equal(readdirSync(join(sessions, 'participants')).length, count);
    await page.close();
  });

  test('works by keyboard alone, and on a phone', slow, async () => {
    const phone = await startBrowser({ width: 390, height: 844, phone: true });
    const page = await open(phone.context);
    await heading(page, 'A remote room');
    await page.keyboard.press('Enter'); // the first button has the focus
    await page.getByText(/Your number/).waitFor();
    await page.keyboard.press('Enter');
    await heading(page, 'Part 1 of 2');
    await page.keyboard.press('Escape');
    await heading(page, 'Part 1 of 2');
    await page.keyboard.press('Enter');
    await page.getByLabel('How sick do you feel').fill('1');
    await page.keyboard.press('Enter');
    await heading(page, 'How it was');
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing sticks out');
    assert.deepEqual(await seriousFindings(page), []);
    await page.screenshot({ path: process.env.ROOMCAST_STUDY_PICTURE ?? join(folder, 'phone.png') });
    await phone.end();
  });
});

describe('a page without a study', () => {
  test('says that the hub runs none', slow, async () => {
    const other = await startHub();
    const page = await browser.context.newPage();
    await page.goto(`${other.page}?study=1`);
    await page.getByText('The study cannot begin: this hub runs no study').waitFor();
    await page.close();
    await other.end();
  });
});
