// SPDX-License-Identifier: Apache-2.0
// Lips to picture: how much later, or earlier, a page plays what was said at an instant than it draws the frame set of that
// instant. Two people in a room with a sensor; one says chirps. The figure is printed: docs/benchmarks/web.md.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { period_s, writeChirp } from './chirp.mjs';
import { chirpTimes, listenIn } from './listening.mjs';
import { oneSensorRoom } from './one_sensor_room.mjs';
import { slow, stateOf, until, untilAllShown } from './waiting.mjs';

const room = oneSensorRoom('lips');
const chirps = 6;

test('what is said is heard about when the frame set of the same instant is seen', slow, async (t) => {
  const sound = join(room.data, 'chirp.wav');
  writeChirp(sound);
  const browser = await startBrowser({
    width: 900,
    height: 700,
    more: ['--use-fake-device-for-media-stream', `--use-file-for-fake-audio-capture=${sound}`, '--use-fake-ui-for-media-stream'],
  });
  try {
    await browser.context.addInitScript(listenIn);
    const open = (name) => openPage(browser.context, `${room.hub.page}?panel=1&mode=points&name=${name}&at=0.2,1.7,2.6&look=0,0.9,-1`);
    const ada = await open('Ada');
    await until('Ada is there', () => stateOf(ada), ({ phase }) => phase === 'joined');
    await ada.getByRole('button', { name: 'Microphone' }).click();
    const bob = await open('Bob');
    await untilAllShown(bob, 1);
    await bob.locator('#room').click();
    await until('Bob hears Ada', () => bob.evaluate(() => window.roomcast.voice()), (voice) => voice?.speakers[0]?.played > 0 && voice.context === 'running');
    const pictures_ms = [];
    const watch = setInterval(() => void stateOf(bob).then(({ latency_ms }) => latency_ms && pictures_ms.push(latency_ms), () => undefined), 500);
    const whilePlayed = chirpTimes(bob, 'ear', chirps);
    const said = await chirpTimes(ada, 'mouth', Infinity, whilePlayed);
    const played = await whilePlayed;
    clearInterval(watch);
    const sounds_ms = played
      .map(({ time_ms, out_ms }) => {
        const from = said.filter((chirp) => chirp.time_ms < time_ms).at(-1);
        return from ? time_ms - from.time_ms + out_ms : Infinity;
      })
      .filter((way_ms) => way_ms < 500 * period_s); // else its own chirp was not found where it was said
    const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];
    const [sound_ms, picture_ms] = [median(sounds_ms), median(pictures_ms)];
    t.diagnostic(`mouth to ear ${sound_ms.toFixed(0)} ms, capture to picture ${picture_ms.toFixed(0)} ms: sound ${(sound_ms - picture_ms).toFixed(0)} ms after the picture`);
    assert.ok(sounds_ms.length >= chirps / 2 && pictures_ms.length > 5, `${sounds_ms.length} chirps, ${pictures_ms.length} readings`);
    assert.ok(Math.abs(sound_ms - picture_ms) < 1000, 'both are of the same second');
  } finally {
    await browser.end();
  }
});
