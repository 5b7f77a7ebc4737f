// SPDX-License-Identifier: Apache-2.0
// A recording that the hub keeps, played in the page: what was there is seen again; timeline, pause, speed, repeat, by mouse,
// keyboard and finger; damaged and deleted ones; and how long it takes to seek in ten minutes.
import assert from 'node:assert/strict';
import { copyFileSync, readFileSync, rmSync, statSync, truncateSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe, test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { seriousFindings } from './accessibility.mjs';
import { openPage, startBrowser } from './browser.mjs';
import { repeatRecording } from './long_recording.mjs';
import { oneSensorRoom } from './one_sensor_room.mjs';
import { startSensor } from './programs.mjs';
import { distance, panelText, slow, stateOf, until, untilAllShown, viewOf } from './waiting.mjs';

const view = 'mode=points&at=0.2,1.7,2.6&look=0,0.9,-1';
const room = oneSensorRoom('playback');
const name = 'roomcast-room-0001';
const file = (which = name) => join(room.data, 'recordings', `${which}.mcap`);
const ask = async (method, path) => {
  const headers = { Authorization: `Bearer ${room.token}` };
  return fetch(`${room.hub.page}api/v1/rooms/room${path}`, { method, headers });
};

/** Ten seconds of two sensors, a person who comes and walks, and a note that is left in the middle. */
async function recordVisit() {
  const second = startSensor(room.hub, 1, { fps: 3 });
  const open = `${room.hub.page}?panel=0&${view}`;
  const bob = await openPage(room.browser.context, `${open}&name=Bob`);
  await untilAllShown(bob, 2);
  const now = async () => (await ask('GET', '/recording')).json();
  assert.equal((await ask('POST', '/recording')).status, 201);
  await until('it is recorded', now, ({ frames }) => frames > 2);
  await delay(3000);
  await bob.evaluate(() => window.roomcast.setView([0.5, 1.6, 0.5], [0, 1, -1]));
  await bob.getByRole('button', { name: 'Note', exact: true }).click();
  await bob.locator('#room.aiming').waitFor();
  await bob.mouse.click(600, 440);
  await bob.getByLabel('Note for everybody in the room').fill('seen again');
  await bob.keyboard.press('Enter');
  await until('the note is left', () => marksOf(bob), ({ length }) => length === 1);
  await delay(4000);
  await ask('DELETE', '/recording');
  await until('it has ended', now, ({ state }) => state === 'off');
  await bob.close();
  await second.end();
}

const marksOf = (page) => page.evaluate(() => window.roomcast.marks());
const figures = (page) => page.evaluate(() => window.roomcast.playback());
const position = async (page) => (await figures(page)).position_s;
const timeline = (page) => page.getByRole('slider', { name: 'Position in the recording' });
const button = (page, text) => page.getByRole('button', { name: text, exact: true });
const play = (which = name, more = '', context = room.browser.context) =>
  openPage(context, `${room.hub.page}?panel=0&${view}&room=room&play=${encodeURIComponent(which)}${more}#token=${room.token}`);

/** Moves the timeline as a person does by mouse, and waits for the moment. */
async function seek(page, position_s) {
  await timeline(page).evaluate((line, value) => {
    line.value = String(value);
    line.dispatchEvent(new Event('input', { bubbles: true }));
  }, position_s);
  return until(`${position_s} s are shown`, () => figures(page), ({ exactPicture_ms }) => exactPicture_ms !== null);
}

describe('a recording in the page', () => {
  let page, length_s;
  before(async () => {
    await recordVisit();
    page = await play();
    await untilAllShown(page, 2);
    ({ length_s } = await until('the controls are there', () => figures(page), (known) => known !== null));
  }, slow);

  test('is opened from the console’s list', slow, async () => {
    const admin = await openPage(room.browser.context, `${room.hub.page}?panel=1&${view}#token=${room.token}`);
    await button(admin, 'Console').click();
    await admin.getByRole('tab', { name: 'Recordings' }).click();
    await admin.getByRole('link', { name: `Play: ${name}` }).click();
    await admin.getByRole('region', { name: 'Playback' }).waitFor();
    await untilAllShown(admin, 2);
    assert.match(await panelText(admin), /recording/);
    await admin.getByRole('link', { name: 'Live room' }).click();
    await until('the room is live', () => admin.evaluate(() => window.roomcast?.state().viewerId), (id) => id > 0);
    assert.deepEqual(admin.complaints, []);
    await admin.close();
  });

  test('plays to its end, slower and faster, and stands still there', slow, async () => {
    await page.bringToFront();
    const start = await seek(page, 1);
    assert.ok(Math.abs(start.position_s - 1) < 2, `${start.position_s}`);
    if ((await figures(page)).paused) await button(page, 'Play').click(); // it may have come to its end meanwhile
    await until('it advances', () => position(page), (at) => at > 2);
    await page.getByLabel('Speed').selectOption('4');
    const began = Date.now();
    await seek(page, 1);
    const end = await until('it ends', () => figures(page), ({ paused }) => paused);
    assert.ok(Math.abs(end.position_s - length_s) < 0.01, `${end.position_s} of ${length_s}`);
    assert.ok(Date.now() - began > 1000 * ((length_s - 1) / 4), 'no faster than was asked');
    await page.getByLabel('Speed').selectOption('1');
    await button(page, 'Play').click();
    await until('it begins anew', () => position(page), (at) => at > 0.2 && at < 3);
    await button(page, 'Pause').click();
    assert.deepEqual(await seriousFindings(page), []);
    assert.deepEqual(page.complaints, []);
  });

  test('shows the same frames of a moment each time, also backwards', slow, async () => {
    const shown = async () => (await page.evaluate(() => window.roomcast.sensors())).map(({ shownSeq }) => shownSeq);
    await seek(page, 5);
    const first = await shown();
    await seek(page, 8);
    assert.notDeepEqual(await shown(), first);
    await seek(page, 5);
    assert.deepEqual(await shown(), first);
    assert.deepEqual((await page.evaluate(() => window.roomcast.sensors())).map(({ problem }) => problem), ['', '']);
  });

  test('shows marks and people as they were', slow, async () => {
    await seek(page, 0.5);
    assert.deepEqual(await marksOf(page), []);
    const { viewers } = await stateOf(page);
    assert.ok(viewers.some((viewer) => viewer.name === 'Bob'), JSON.stringify(viewers));
    await seek(page, length_s - 0.5);
    assert.deepEqual((await marksOf(page)).map(({ text, author }) => [text, author]), [['seen again', 'Bob']]);
    await seek(page, 2);
    await button(page, 'Play').click();
    await until('Bob walks', () => page.evaluate(() => window.roomcast.otherPoses()), (poses) =>
      poses.some(({ head }) => head && distance([head.x, head.y, head.z], [0.5, 1.6, 0.5]) < 0.05));
    await until('the note comes', () => marksOf(page), ({ length }) => length === 1);
    await button(page, 'Pause').click();
  });

  test('has pictures along its timeline; a click on one goes there', slow, async (t) => {
    const strip = page.locator('#playback .pictures');
    const painted = () => strip.locator('canvas').evaluateAll((canvases) => canvases.map((canvas) => {
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      return canvas.width === 144 && new Set(data).size > 20;
    }));
    const all = await until('they are there', painted, (done) => done.length > 0 && done.every(Boolean));
    assert.ok(all.length >= 4 && all.length <= 16, `${all.length}`);
    const loads = await page.evaluate(() => performance.getEntriesByType('resource').filter(({ name }) => /key-frames/.test(name)).map(({ transferSize, duration }) => [transferSize, duration]));
    const [bytes, took_ms] = [0, 1].map((which) => loads.reduce((sum, each) => sum + each[which], 0));
    t.diagnostic(`${all.length} pictures: ${(bytes / 1000).toFixed(0)} kB, fetched in ${took_ms.toFixed(0)} ms in all`);
    assert.ok(bytes < 6.5e6, `${bytes} bytes`);
    const box = await strip.boundingBox();
    await page.mouse.click(box.x + 0.25 * box.width, box.y + box.height / 2);
    await until('it is there', () => figures(page), ({ position_s, exactPicture_ms }) =>
      exactPicture_ms !== null && Math.abs(position_s - length_s / 4) < 0.5);
    assert.deepEqual(page.complaints, []);
  });

  test('repeats when that is wanted', slow, async () => {
    await page.getByLabel('Repeat').check();
    await seek(page, length_s - 0.3);
    await button(page, 'Play').click();
    await until('it has begun anew', () => position(page), (at) => at > 0.1 && at < 3);
    await page.getByLabel('Repeat').uncheck();
    await button(page, 'Pause').click();
  });

  test('is used by keyboard alone; the view is still the viewer’s', slow, async () => {
    await seek(page, 2);
    await page.locator('#room').focus();
    await page.keyboard.press('Space');
    await until('it plays', () => figures(page), ({ paused }) => !paused);
    await page.keyboard.press('Space');
    await until('it pauses', () => figures(page), ({ paused }) => paused);
    const before = await viewOf(page);
    await page.keyboard.press('KeyW');
    assert.ok(distance((await viewOf(page)).position, before.position) > 0.01);
    await timeline(page).focus();
    const at = await position(page);
    await page.keyboard.press('ArrowRight');
    await until('a second later', () => position(page), (now) => Math.abs(now - at - 1) < 0.05);
    assert.match(await timeline(page).getAttribute('aria-valuetext'), /^0:0\d of 0:\d\d$/);
    await page.keyboard.press('Home');
    await until('the start', () => position(page), (now) => now === 0);
    await page.keyboard.press('End');
    await until('the end', () => position(page), (now) => Math.abs(now - length_s) < 0.11);
  });

  test('is for admins only, and says so', slow, async () => {
    const { context, end } = await startBrowser();
    const guest = await context.newPage();
    await guest.goto(`${room.hub.page}?panel=1&room=room&play=${name}`);
    await guest.getByText('Recordings are for the room’s admins').first().waitFor();
    await guest.getByLabel('Token').first().waitFor();
    await end();
  });

  test('is worked with one finger on a phone', slow, async () => {
    await page.close(); // then the phone is not taken along by it
    await delay(500);
    const phone = await startBrowser({ width: 390, height: 844, phone: true });
    const small = await play(name, '', phone.context);
    await untilAllShown(small, 2);
    await button(small, 'Pause').tap();
    const box = await timeline(small).boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 390, JSON.stringify(box));
    await small.touchscreen.tap(box.x + box.width / 2, box.y + box.height / 2);
    await until('the middle', () => position(small), (at) => Math.abs(at - length_s / 2) < 0.6);
    assert.deepEqual(await seriousFindings(small), []);
    assert.ok(await small.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing sticks out');
    assert.deepEqual(small.complaints, []);
    await phone.end();
  });
});

describe('a recording that is not as it should be', () => {
  test('is played up to where its end is missing, and around damage within it', slow, async () => {
    copyFileSync(file(), file('cut'));
    truncateSync(file('cut'), Math.floor(statSync(file()).size * 0.6));
    const cut = await play('cut', '&from=1');
    await untilAllShown(cut, 2);
    await cut.close();
    const bytes = readFileSync(file());
    for (let at = Math.floor(bytes.length * 0.4); at < bytes.length * 0.5; at++) bytes[at] ^= 0x5a;
    writeFileSync(file('holes'), bytes);
    const holes = await play('holes');
    await untilAllShown(holes, 2);
    await until('it says so', () => holes.locator('#playback').innerText(), (text) => /damaged here/.test(text));
    await until('it goes on', () => figures(holes), ({ position_s, length_s }) => position_s > 0.8 * length_s);
    assert.deepEqual(holes.complaints, []);
    await holes.close();
  });

  test('and cannot be read, or is not there, is refused with a sentence', slow, async () => {
    writeFileSync(file('noise'), 'nothing of the kind');
    for (const [which, said] of [['noise', /It is not an MCAP file\./], ['../hub', /not there any more/], ['none', /not there any more/]]) {
      const page = await play(which, '&panel=1');
      await until(`${which} is refused`, () => page.locator('body').innerText(), (text) => said.test(text));
      await page.close();
    }
  });

  test('is deleted while it is played', slow, async () => {
    copyFileSync(file(), file('going'));
    const page = await play('going');
    await untilAllShown(page, 2);
    rmSync(file('going'));
    await timeline(page).evaluate((line) => {
      line.value = '1';
      line.dispatchEvent(new Event('input', { bubbles: true }));
    });
    await page.getByText('This recording is not there any more: it was deleted or renamed.').first().waitFor();
    await page.close();
  });
});

describe('a recording of ten minutes', () => {
  test('shows another moment soon (the times are printed)', slow, async () => {
    const length_s = repeatRecording(file(), file('long'), 600);
    assert.ok(length_s >= 600);
    const page = await play('long', '&mode=points');
    await untilAllShown(page, 2);
    await until('the controls are there', () => figures(page), (known) => known !== null);
    await button(page, 'Pause').click();
    const taken = [];
    for (const share of [0.9, 0.1, 0.55, 0.31, 0.77, 0.02, 0.99, 0.5, 0.66]) taken.push(await seek(page, share * length_s));
    const sorted = (of) => taken.map(of).sort((a, b) => a - b);
    const first_ms = sorted(({ firstPicture_ms }) => firstPicture_ms);
    const exact_ms = sorted(({ exactPicture_ms }) => exactPicture_ms);
    const megabytes = (statSync(file('long')).size / 1e6).toFixed(0);
    console.log(`# seek in ${length_s.toFixed(0)} s, ${megabytes} MB, 2 simulated sensors: first full picture ${first_ms.map(Math.round)} ms`);
    console.log(`# the moment itself ${exact_ms.map(Math.round)} ms`);
    await page.close();
  });
});
