// SPDX-License-Identifier: Apache-2.0
// Two people in two pages of a real Chromium, whose microphone is a file with a chirp: what one says is found in what
// the other's page plays. Then what the page says where nothing can be said or heard.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { seriousFindings } from './accessibility.mjs';
import { openPage, startBrowser, withoutHub } from './browser.mjs';
import { period_s, writeChirp } from './chirp.mjs';
import { chirpTimes, isSilent, listenIn } from './listening.mjs';
import { adminsToken, requireBuilt, startHub } from './programs.mjs';
import { panelText, slow, stateOf, until } from './waiting.mjs';

const { WebSocket } = createRequire(new URL('../../web/package.json', import.meta.url))('ws');
const longestMouthToEar_ms = 400; // on a busy machine, too; docs/benchmarks/web.md has the figure of a quiet one
const chirps = 8;

const data = mkdtempSync(join(tmpdir(), 'roomcast-voice-'));
const sound = join(data, 'chirp.wav');
const microphone = ['--use-fake-device-for-media-stream', `--use-file-for-fake-audio-capture=${sound}`];
const permitted = '--use-fake-ui-for-media-stream';
let hub, token;

before(async () => {
  requireBuilt();
  writeChirp(sound);
  hub = await startHub(0, { data });
  token = await adminsToken(data);
}, slow);

after(async () => {
  await hub?.end();
  rmSync(data, { recursive: true, force: true });
}, slow);

const button = (page) => page.getByRole('button', { name: 'Microphone' });
const voiceOf = (page) => page.evaluate(() => window.roomcast.voice());
const note = (page) => page.locator('#panel .sound p').innerText();
const says = (page, pattern) => until(`the page says ${pattern}`, () => note(page), (text) => pattern.test(text));
const joined = (page) => until('it has joined', () => stateOf(page), ({ phase }) => phase === 'joined');

async function open(browser, name, more = '') {
  const page = await openPage(browser.context, `${hub.page}?panel=1&mode=points&name=${name}${more}`);
  await joined(page);
  return page;
}

describe('two people', () => {
  let browser, ada, bob;

  before(async () => {
    browser = await startBrowser({ width: 900, height: 700, more: [...microphone, permitted] });
    await browser.context.addInitScript(listenIn);
    ada = await open(browser, 'Ada');
    bob = await open(browser, 'Bob');
  }, slow);
  after(() => browser?.end(), slow);

  test('nothing of voice is loaded before somebody speaks', slow, async () => {
    const files = await bob.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
    assert.deepEqual(files.filter((name) => /voice|worklet/.test(name)), []);
    await says(ada, /microphone is off/);
  });

  test('a chirp said by one is soon played by the other', slow, async (t) => {
    await bob.locator('#room').click();
    await button(ada).press('Enter');
    await says(ada, /when you speak|hear you/);
    await until('Bob’s page hears Ada', () => voiceOf(bob), (voice) => voice?.speakers[0]?.played > 0);
    await bob.locator('#room').click(); // a gesture, without which browsers play nothing
    await until('sound is on', () => voiceOf(bob), (voice) => voice.context === 'running');
    const whilePlayed = chirpTimes(bob, 'ear', chirps);
    const said = await chirpTimes(ada, 'mouth', Infinity, whilePlayed);
    const played = await whilePlayed;
    const ways_ms = played
      .map(({ time_ms, out_ms }) => {
        const from = said.filter((chirp) => chirp.time_ms < time_ms).at(-1);
        return from && time_ms - from.time_ms + out_ms;
      })
      .filter((way_ms) => way_ms < 500 * period_s)
      .sort((a, b) => a - b);
    assert.ok(ways_ms.length >= chirps / 2, `${said.length} chirps said, ${played.length} played`);
    const median_ms = ways_ms[ways_ms.length >> 1];
    const figures = JSON.stringify((await voiceOf(bob)).speakers);
    t.diagnostic(`mouth to ear: median ${median_ms.toFixed(0)} ms of ${ways_ms.map(Math.round)}; ${figures}`);
    t.diagnostic(`likeness ${played.map(({ likeness }) => likeness.toFixed(2))}`);
    assert.ok(median_ms > 5 && median_ms <= longestMouthToEar_ms, `${median_ms} ms`);
  });

  test('each sees at the names who speaks', slow, async () => {
    const row = bob.locator('#panel .people li', { hasText: 'Ada' });
    await until('“speaks” at Ada’s name', () => row.innerText(), (text) => /speaks/.test(text));
    await until('and then no more', () => row.innerText(), (text) => !/speaks/.test(text));
  });

  test('one person’s volume is set without the others knowing', slow, async () => {
    const slider = bob.getByRole('slider', { name: 'Volume of Ada' });
    await slider.focus();
    await bob.keyboard.press('Home');
    assert.equal((await voiceOf(bob)).speakers[0].volume, 0);
    await delay(1000);
    assert.ok(await isSilent(bob), 'silenced');
    await bob.keyboard.press('End');
    assert.equal((await chirpTimes(bob, 'ear', 1)).length, 1, 'heard again');
    assert.match(await note(ada), /hear/);
  });

  test('push to talk sends while the key is held, and not otherwise', slow, async () => {
    await ada.getByText('While I hold V').click();
    await says(ada, /while you hold V/);
    await delay(1000);
    const before = (await voiceOf(bob)).speakers[0].played;
    await delay(3000);
    assert.ok((await voiceOf(bob)).speakers[0].played - before <= 25, 'nothing is sent');
    await ada.locator('#room').focus();
    await ada.keyboard.down('v');
    await says(ada, /^The others hear you\.$/);
    await delay(1500);
    await ada.keyboard.up('v');
    await says(ada, /while you hold V/);
    const sent = async () => (await voiceOf(bob)).speakers[0].played - before;
    await until('packets of 1.5 s, of which a busy machine may lose some', sent, (packets) => packets > 40);
    await ada.getByText('When I speak').click();
  });

  test('an admin mutes somebody, who is told, and ends that', slow, async () => {
    const admin = await open(browser, 'Cleo', `#token=${token}`);
    await admin.getByRole('button', { name: 'Console' }).click();
    await admin.getByRole('tab', { name: 'People' }).click();
    const mute = admin.getByRole('button', { name: 'Mute: Ada' });
    await mute.click();
    await says(ada, /muted you/);
    assert.deepEqual(await seriousFindings(admin), []);
    assert.ok(await button(ada).isDisabled());
    assert.equal((await voiceOf(ada)).isOn, false);
    const row = bob.locator('#panel .people li', { hasText: 'Ada' });
    await until('“muted” at Ada’s name', () => row.innerText(), (text) => /muted/.test(text));
    await until('the switch shows it', () => mute.getAttribute('aria-pressed'), (pressed) => pressed === 'true');
    await mute.click();
    await says(ada, /microphone is off/);
    await admin.close();
    await button(ada).click();
    await says(ada, /hear you/);
  });

  test('while the hub is away the page says that nobody hears one, and then goes on', slow, async () => {
    const { port } = hub;
    assert.deepEqual([...ada.complaints, ...bob.complaints], [], 'before');
    await hub.end('SIGKILL');
    await says(ada, /Nobody hears you/);
    hub = await startHub(port, { data });
    await joined(ada);
    await joined(bob);
    await says(ada, /hear you/);
    const { viewerId } = await stateOf(ada);
    const hears = ({ speakers }) => speakers.some(({ id, played }) => id === viewerId && played > 0);
    await until('Bob hears Ada again', () => voiceOf(bob), hears);
  });

  test('a hostile speaker disturbs nobody with broken packets', slow, async () => {
    const { viewerId } = await stateOf(ada);
    const playedOfAda = async () => (await voiceOf(bob)).speakers.find(({ id }) => id === viewerId)?.played ?? 0;
    const stranger = await joinAsStranger();
    const before = await playedOfAda();
    for (let seq = 0; seq < 100; seq++) {
      stranger.send(audioPacket(seq, seq % 3 === 0 ? Buffer.from([0xfb, 0x3f, 1, 2]) : randomBytes(100, seq)));
      await delay(20);
    }
    await until('Bob still hears Ada', playedOfAda, (played) => played > before + 10);
    assert.equal(stranger.readyState, WebSocket.OPEN);
    stranger.close();
  });

  test('all of it is usable by keyboard and screen reader', slow, async () => {
    assert.deepEqual(await seriousFindings(ada), []);
    assert.deepEqual(await seriousFindings(bob), []);
    await button(ada).focus();
    await ada.keyboard.press('Space');
    await says(ada, /microphone is off/);
    assert.equal(await button(ada).getAttribute('aria-pressed'), 'false');
  });

  test('the pages have logged no errors', () => {
    assert.deepEqual([...ada.complaints, ...bob.complaints].filter((complaint) => !withoutHub.test(complaint)), []);
  });
});

describe('where one cannot speak or hear, the page says why', () => {
  const cases = [
    { what: 'no microphone', more: [permitted], press: true, said: /No microphone was found/ },
    { what: 'permission denied', more: [...microphone, '--deny-permission-prompts'], press: true, said: /does not let this page use the microphone/ },
    { what: 'a browser that cannot decode', gone: ['AudioDecoder'], said: /cannot decode voice/ },
    { what: 'a browser that cannot encode', gone: ['AudioEncoder'], said: /play voices but not encode yours/ },
  ];
  for (const { what, more = [], gone = [], press = false, said } of cases) {
    test(what, slow, async () => {
      const browser = await startBrowser({ more });
      try {
        await browser.context.addInitScript((names) => names.forEach((name) => delete window[name]), gone);
        const page = await open(browser, 'Ada');
        if (press) await button(page).click();
        await says(page, said);
        assert.equal(await button(page).isDisabled(), !press);
        assert.equal(await button(page).getAttribute('aria-pressed'), 'false');
      } finally {
        await browser.end();
      }
    });
  }

  test('an insecure page', slow, async () => {
    const config = join(data, 'insecure.toml');
    writeFileSync(config, '[access]\nhosts = ["hub.test"]\n');
    const plain = await startHub(0, { more: ['--config', config] });
    const browser = await startBrowser({ more: ['--host-resolver-rules=MAP hub.test 127.0.0.1'] });
    try {
      const page = await openPage(browser.context, `http://hub.test:${plain.port}/?panel=1`);
      await says(page, /only on pages loaded over HTTPS/);
      await joined(page);
      assert.ok(await button(page).isDisabled());
      assert.match(await panelText(page), /live/);
    } finally {
      await browser.end();
      await plain.end();
    }
  });
});

/** A client of its own that sends what it likes. */
async function joinAsStranger() {
  const socket = new WebSocket(`ws://127.0.0.1:${hub.port}/ws`, 'roomcast.v1');
  await new Promise((resolve, reject) => socket.once('open', resolve).once('error', reject));
  // Control{join{name: "Eve", viewer{}}}
  socket.send(Buffer.from([0x52, 0x43, 1, 2, 0x0a, 7, 0x12, 3, ...Buffer.from('Eve'), 0x22, 0]));
  await new Promise((resolve) => socket.once('message', resolve));
  return socket;
}

function audioPacket(seq, payload) {
  const packet = Buffer.alloc(28 + payload.length);
  packet.set([0x52, 0x43, 1, 3, 28]);
  packet.writeUInt32LE(seq, 12);
  packet.writeUInt16LE(payload.length, 24);
  packet[26] = 1;
  packet.set(payload, 28);
  return packet;
}

/** The first byte is that of a packet of 20 ms. */
function randomBytes(count, seed) {
  const bytes = Buffer.from(Array.from({ length: count }, (_, i) => ((seed + 1) * 2654435761 * (i + 7)) >>> 24));
  bytes[0] = 0x78;
  return bytes;
}
