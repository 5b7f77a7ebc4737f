// SPDX-License-Identifier: Apache-2.0
// Two people play one recording together: each sees the other in it, and what one does with the timeline happens to both.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { before, describe, test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { seriousFindings } from './accessibility.mjs';
import { openPage, startBrowser } from './browser.mjs';
import { repeatRecording } from './long_recording.mjs';
import { oneSensorRoom } from './one_sensor_room.mjs';
import { distance, slow, stateOf, until, untilAllShown } from './waiting.mjs';

const room = oneSensorRoom('together');
const ask = (method, path) =>
  fetch(`${room.hub.page}api/v1/rooms/room${path}`, { method, headers: { Authorization: `Bearer ${room.token}` } });
const played = 'long';
const longer_s = 300; // so that it does not end while a busy machine draws
const file = (name) => join(room.data, 'recordings', `${name}.mcap`);
const figures = (page) => page.evaluate(() => window.roomcast.playback());
const button = (page, text) => page.getByRole('button', { name: text, exact: true });
const timeline = (page) => page.getByRole('slider', { name: 'Position in the recording' });

async function play(context, name) {
  const page = await openPage(context, `${room.hub.page}?panel=0&mode=points&at=0.2,1.7,2.6&look=0,0.9,-1&room=room&play=${played}&name=${name}#token=${room.token}`);
  await untilAllShown(page, 1);
  await until('the controls are there', () => figures(page), (known) => known !== null);
  return page;
}

describe('two people in one recording', () => {
  let other, ada, bob;
  before(async () => {
    await ask('POST', '/recording');
    await until('it is recorded', async () => (await ask('GET', '/recording')).json(), ({ frames }) => frames > 2);
    await delay(6000);
    await ask('DELETE', '/recording');
    await until('it has ended', async () => (await ask('GET', '/recording')).json(), ({ state }) => state === 'off');
    repeatRecording(file('roomcast-room-0001'), file(played), longer_s);
    other = await startBrowser({ width: 900, height: 600 });
    ada = await play(room.browser.context, 'Ada');
    bob = await play(other.context, 'Bob');
  }, slow);

  test('see each other in it', slow, async () => {
    await ada.getByText('Together with Bob').waitFor();
    await bob.getByText('Together with Ada').waitFor();
    await ada.evaluate(() => window.roomcast.setView([0.5, 1.6, 0.5], [0, 1, -1]));
    await until('she is with Bob', () => stateOf(bob), ({ viewers }) => viewers.some(({ name }) => name === 'Ada (with you)'));
    await until('Ada walks', () => bob.evaluate(() => window.roomcast.otherPoses()), (poses) =>
      poses.some(({ head }) => head && distance([head.x, head.y, head.z], [0.5, 1.6, 0.5]) < 0.05));
    assert.deepEqual(await seriousFindings(bob), []);
  });

  test('pause, seek and change the speed for both', slow, async (t) => {
    const began = Date.now();
    await button(ada, 'Pause').click();
    await until('Bob’s pauses, too', () => figures(bob), ({ paused }) => paused);
    t.diagnostic(`a pause took ${Date.now() - began} ms to reach the other page`);
    await timeline(bob).press('Home');
    await until('Ada’s is at the start', () => figures(ada), ({ position_s }) => position_s < 0.5);
    await timeline(ada).press('PageUp');
    const { position_s } = await until('Ada’s is at the end', () => figures(ada), (state) => state.position_s > 4);
    await until('and so is Bob’s', () => figures(bob), (state) => Math.abs(state.position_s - position_s) < 0.5);
    await timeline(ada).press('Home');
    await until('both at the start', () => figures(bob), (state) => state.position_s < 0.5);
    await bob.getByLabel('Speed').selectOption('0.5');
    await until('Ada’s is slower, too', () => figures(ada), ({ speed }) => speed === 0.5);
    await button(bob, 'Play').click();
    await until('Ada’s plays', () => figures(ada), ({ paused, position_s: at }) => !paused && at > 1);
    // One of the two pages may answer later than the other, at a later position.
    const positions = () => Promise.all([figures(ada), figures(bob)].map(async (asked) => (await asked).position_s));
    const [a, b] = await until('they are in step', positions, ([one, two]) => Math.abs(one - two) < 1);
    t.diagnostic(`positions ${a.toFixed(2)} and ${b.toFixed(2)} s`);
  });

  test('who comes later is taken along, and who leaves is gone', slow, async () => {
    await button(bob, 'Pause').click();
    await timeline(bob).press('End');
    await until('the end is shown', () => figures(ada), (state) => state.position_s > state.length_s - 0.5);
    const { position_s } = await until('it stands', () => figures(ada), ({ paused }) => paused);
    const cleo = await play(other.context, 'Cleo');
    await until('Cleo is where the others are', () => figures(cleo), (state) => state.paused && Math.abs(state.position_s - position_s) < 0.5);
    await ada.getByText(/Together with .*Cleo/).waitFor();
    await cleo.close();
    await ada.getByText('Together with Bob', { exact: true }).waitFor();
    await ada.getByLabel('Together with Bob').uncheck();
    await button(bob, 'Play').click();
    await delay(1500);
    assert.ok((await figures(ada)).paused, 'Ada is alone now');
    await ada.getByLabel('Together with others').check();
    await ada.getByText('Together with Bob', { exact: true }).waitFor();
    await other.end();
    await until('Ada is alone', () => ada.locator('#playback .company').isHidden(), (isHidden) => isHidden);
    assert.deepEqual(ada.complaints, []);
  });
});
