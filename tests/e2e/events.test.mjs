// SPDX-License-Identifier: Apache-2.0
// What an admin sees of what happened in the room, and settings of sensors from afar.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { seriousFindings } from './accessibility.mjs';
import { keepPicture, openPage, startBrowser } from './browser.mjs';
import { adminsToken, requireBuilt, startHub, startSensor } from './programs.mjs';
import { slow, until, untilAllShown } from './waiting.mjs';

describe('in the console', () => {
  const data = mkdtempSync(join(tmpdir(), 'roomcast-events-'));
  let hub, sensors, browser, token, page;

  before(async () => {
    requireBuilt();
    hub = await startHub(0, { data });
    token = await adminsToken(data);
    sensors = [startSensor(hub, 0, { fps: 3 }), startSensor(hub, 1, { fps: 3, more: ['--no-remote-settings'] })];
    browser = await startBrowser({ width: 1200, height: 760 });
    page = await openPage(browser.context, `${hub.page}?panel=1&mode=points&name=Ada#token=${token}`);
    await untilAllShown(page, 2);
    await page.getByRole('button', { name: 'Console', exact: true }).click();
  }, slow);

  after(async () => {
    await browser?.end();
    await Promise.all([...(sensors ?? []), hub].map((program) => program?.end()));
    rmSync(data, { recursive: true, force: true });
  }, slow);

  const events = () => page.locator('.event-list').innerText();
  const card = (name) => page.locator('#console .card').filter({ has: page.getByRole('heading', { name }) });
  const settingsOf = async (name) => {
    const answer = await fetch(`${hub.page}api/v1/rooms/room/sensors`, { headers: { authorization: `Bearer ${token}` } });
    return (await answer.json()).sensors.find((sensor) => sensor.name === name)?.settings;
  };

  test('a sensor is asked for another codec and rate, and joins again with them', slow, async () => {
    const details = card('s0').locator('.sensor-settings');
    const summary = details.locator('summary');
    await summary.waitFor(); // press() alone does not: its key would go to the console's close button, which has the focus
    await summary.press('Enter');
    await details.getByLabel('Target rate').selectOption('number');
    await details.getByLabel('Mbit/s', { exact: true }).fill('3');
    await details.getByLabel('Frames per second').fill('4');
    assert.deepEqual(await seriousFindings(page), []);
    await keepPicture(page, 'sensor_settings');
    await details.getByRole('button', { name: 'Apply' }).press('Enter');
    await until('it says so', () => details.innerText(), (text) => /Done\. The sensor joins again/.test(text));
    await until('it has them', () => settingsOf('s0'), (now) => now?.mbit === 3 && now.fps === 4);
    await untilAllShown(page, 2);
  });

  test('a sensor refuses what it cannot do in its own words, and goes on', slow, async () => {
    const details = card('s0').locator('.sensor-settings');
    await until('the form shows what it has now', () => details.getByLabel('Frames per second').inputValue(), (fps) => fps === '4');
    await details.getByLabel('Depth coding').selectOption('lossless');
    await details.getByRole('button', { name: 'Apply' }).click();
    await until('it refuses', () => details.innerText(), (text) => /a target rate needs live depth/.test(text));
    assert.equal((await settingsOf('s0')).codec, 'live');
  });

  test('a restart asks first', slow, async () => {
    const before = (await sensors[0].lines.filter((line) => /joined as/.test(line))).length;
    const restart = card('s0').getByRole('button', { name: /Restart/ });
    await restart.click();
    await card('s0').getByRole('button', { name: 'Restart it now?: s0' }).click();
    const joins = () => sensors[0].lines.filter((line) => /joined as/.test(line)).length;
    await until('it joined again', joins, (count) => count === before + 1);
    await untilAllShown(page, 2);
  });

  test('takes no settings where its owner forbids it', slow, async () => {
    assert.equal(await card('s1').locator('.sensor-settings').isVisible(), false);
    const answer = await fetch(`${hub.page}api/v1/rooms/room/sensors/s1`, {
      method: 'PATCH',
      headers: { authorization: `Bearer ${token}` },
      body: JSON.stringify({ restart: true }),
    });
    assert.equal(answer.status, 400);
    assert.match((await answer.json()).error.sentence, /takes no settings from afar/);
  });

  test('one sees who came and went, who was refused and why, and what admins did', slow, async () => {
    const stranger = await openPage(browser.context, `${hub.page}?name=Eve&room=room#token=a.b.c`);
    await until('she is refused', () => stranger.locator('#panel').innerText(), (text) => /token/.test(text));
    await stranger.close();
    await page.getByRole('tab', { name: 'Events' }).click();
    const list = await until('the list', events, (text) => /Eve was refused: /.test(text));
    assert.match(list, /Ada joined/);
    assert.match(list, /an admin changed s0: 3 Mbit\/s, 4 frames\/s/);
    assert.match(list, /s0 refused what an admin asked for: codec lossless/);
    assert.match(list, /an admin changed s0: restart/);
    assert.deepEqual(await seriousFindings(page), []);
    await keepPicture(page, 'events');
  });

  test('the list is filtered by keyboard and saved as CSV and JSON', slow, async () => {
    const filter = page.locator('.events').getByLabel('Show');
    await filter.selectOption('refused');
    assert.ok((await events()).split('\n').every((line) => !/joined/.test(line)), await events());
    const save = async (name) => {
      const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name }).press('Enter')]);
      return readFileSync(await download.path(), 'utf8');
    };
    const csv = await save('Download CSV');
    assert.match(csv, /^at,kind,role,name,by,sentence,times,peer,token_id\r\n/);
    assert.match(csv, /,refused,viewer,Eve,/);
    await filter.selectOption('all');
    const kinds = JSON.parse(await save('Download JSON')).map(({ kind }) => kind);
    assert.ok(['joined', 'left', 'refused', 'changed_sensor', 'sensor_refused'].every((kind) => kinds.includes(kind)), kinds);
  });

  test('the events fit a phone', slow, async () => {
    await page.setViewportSize({ width: 390, height: 760 });
    assert.ok(await page.locator('.event-list').evaluate((list) => list.scrollWidth <= list.clientWidth), 'no line is cut off');
    assert.equal(await page.locator('#hint').isVisible(), false, 'the hint how to move does not lie under the console');
    await page.getByRole('button', { name: 'Close the console' }).click();
    assert.ok(await page.locator('#hint').isVisible(), 'it comes back: nobody has moved yet');
    await page.getByRole('button', { name: 'Console', exact: true }).click();
    await keepPicture(page, 'events_phone');
    const unexpected = page.complaints.filter((text) => !/status of 400/.test(text)); // what the sensor refused
    assert.deepEqual(unexpected, []);
  });
});
