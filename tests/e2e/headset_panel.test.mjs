// SPDX-License-Identifier: Apache-2.0
// The panel in a headset, and a study with its questionnaires there. The headset is emulated (headset_device.mjs); its hand
// points at buttons of the panel and pulls the trigger.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { keepPicture, openPage, startBrowser } from './browser.mjs';
import { pressOnBoard, wearHeadsets } from './headset_device.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { slow, until, untilAllShown } from './waiting.mjs';

const plan = `[study]
name = "presence"
title = "A remote room"
consent = "We keep what you answer."

[[condition]]
name = "live"
seconds = 4
instruction = "Look around."

[[questionnaire]]
name = "how"
when = ["after-condition"]
  [[questionnaire.item]]
  name = "there"
  text = "I had the feeling of being in that room."
  labels = ["not at all", "very much"]
  [[questionnaire.item]]
  name = "sick"
  text = "How sick do you feel, from 0 to 20?"
  kind = "number"
`;

describe('in a headset', () => {
  const folder = mkdtempSync(join(tmpdir(), 'roomcast-headset-'));
  let hub, sensor, browser;

  before(async () => {
    requireBuilt();
    writeFileSync(join(folder, 'plan.toml'), plan);
    const study = ['--study', join(folder, 'plan.toml'), '--study-folder', join(folder, 'sessions')];
    hub = await startHub(0, { data: join(folder, 'data'), more: study });
    sensor = startSensor(hub, 0, { fps: 2 });
    browser = await startBrowser({ width: 900, height: 450 });
    await wearHeadsets(browser.context);
  }, slow);

  after(async () => {
    await browser?.end();
    await sensor?.end();
    await hub?.end();
    rmSync(folder, { recursive: true, force: true });
  }, slow);

  const panelOf = (page) => page.evaluate(() => window.roomcast.headset().panel);
  const untilPanel = (page, what, enough) => until(what, () => panelOf(page), enough);
  const has = (text) => (panel) => panel?.board?.texts.join(' ').includes(text) || panel?.board?.buttons.some((b) => b.text === text);
  const press = (page, text) => pressOnBoard(page, () => panelOf(page), text);
  const view = 'at=0.5,1.6,1.5&look=0.5,1.6,0&mode=points';

  test('a tile opens a panel with people, whom one can mute, and the way out', slow, async () => {
    const other = await openPage(browser.context, `${hub.page}?panel=0&mode=points&name=Bo`);
    const page = await openPage(browser.context, `${hub.page}?panel=1&${view}&name=Ada`);
    await untilAllShown(page, 1);
    await page.getByRole('button', { name: 'Enter VR' }).click();
    await untilPanel(page, 'the tile', (panel) => panel?.tile?.buttons[0]?.text === 'Menu');
    await press(page, 'Menu');
    const { board } = await untilPanel(page, 'the panel', has('Leave the headset'));
    assert.ok(board.buttons.some(({ text, isOn }) => text === 'Bo' && isOn), JSON.stringify(board));
    await keepPicture(page, 'headset_menu');
    await press(page, 'Bo');
    await untilPanel(page, 'he is muted', has('Bo (muted)'));
    await press(page, 'Bo (muted)');
    await untilPanel(page, 'he is heard', has('Bo'));
    await other.close();
    await untilPanel(page, 'nobody is left', has('Nobody else is here.'));
    const head_m = () => page.evaluate(() => window.roomcast.headset().views[0].position[1]);
    const rise = (height_m) => page.evaluate((to_m) => window.device.position.set(0, to_m, 0), height_m);
    await rise(1.1);
    await until('they have sat down', head_m, (height_m) => Math.abs(height_m - 1.1) < 0.02);
    await press(page, 'I sit');
    await until('who sits is lifted', head_m, (height_m) => Math.abs(height_m - 1.6) < 0.02);
    await press(page, 'I sit');
    await until('and put down again', head_m, (height_m) => Math.abs(height_m - 1.1) < 0.02);
    await rise(1.7);
    await press(page, 'Close');
    await untilPanel(page, 'it is closed', (panel) => panel.board === null && panel.tile !== null);

    await sensor.end('SIGKILL');
    const isTold = ({ tile }) => /gone/.test(tile?.texts.join(' ') ?? '');
    await untilPanel(page, 'the tile says what is wrong', isTold);
    await keepPicture(page, 'headset_trouble');
    sensor = startSensor(hub, 0, { fps: 2 });
    await untilPanel(page, 'all is well', (panel) => !isTold(panel));

    await press(page, 'Menu');
    await untilPanel(page, 'the panel', has('Leave the headset'));
    const { selects } = await page.evaluate(() => window.roomcast.headset());
    await press(page, 'Leave the headset');
    await until('it is off', () => page.evaluate(() => window.roomcast.headset().on), (on) => !on);
    assert.ok(selects >= 4, 'each press was a trigger, and none of them a teleport');
    assert.deepEqual(page.complaints, []);
    await page.close();
  });

  test('a participant of a study answers its questions there', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?study=1&${view}`);
    await page.getByRole('button', { name: 'Put on the headset' }).click();
    await untilPanel(page, 'the consent', has('We keep what you answer.'));
    await keepPicture(page, 'headset_consent');
    await press(page, 'I agree and want to take part');
    await untilPanel(page, 'the number', has('Continue'));
    await press(page, 'Continue');
    await untilPanel(page, 'the condition', has('Start'));
    await press(page, 'Start');
    const inRoom = ({ board, tile }) => board === null && /Look around\./.test(tile?.texts.join(' ') ?? '');
    await untilPanel(page, 'the room, with nothing in front of it', inRoom);
    await untilPanel(page, 'a question', has('I had the feeling of being in that room.'));
    await press(page, '6');
    await untilPanel(page, 'it is chosen', ({ board }) => board.buttons.some(({ text, isOn }) => text === '6' && isOn));
    await keepPicture(page, 'headset_question');
    await press(page, 'Next question');
    await untilPanel(page, 'the next one', has('How sick do you feel, from 0 to 20?'));
    await press(page, 'Continue');
    await untilPanel(page, 'it must be answered', has('One answer is missing.'));
    await press(page, '1');
    await press(page, '2');
    await untilPanel(page, 'twelve', has('12'));
    await keepPicture(page, 'headset_number');
    await press(page, 'Continue');
    await untilPanel(page, 'the end', has('All is sent. You can close this page.'));
    const participants = join(folder, 'sessions', 'participants');
    const [participant] = readdirSync(participants);
    const log = readFileSync(join(participants, participant, 'log.jsonl'), 'utf8');
    assert.match(log, /"item":"there"[^}]*"value":6|"value":6[^}]*"item":"there"/);
    assert.match(log, /"item":"sick"[^}]*"value":12|"value":12[^}]*"item":"sick"/);
    assert.deepEqual(page.complaints, []);
    await page.close();
  });
});
