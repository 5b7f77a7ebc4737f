// SPDX-License-Identifier: Apache-2.0
// A room in pages of other sites: in a frame where its owner has named the site, refused elsewhere, and as a layer of a
// three.js scene. The pages are those of examples/web.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { seriousFindings } from './accessibility.mjs';
import { startBrowser } from './browser.mjs';
import { adminsToken, requireBuilt, startHub, startSensor } from './programs.mjs';
import { startSite } from './other_site.mjs';
import { slow, until } from './waiting.mjs';

const fromRoot = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const example = (name) => readFileSync(fromRoot(`examples/web/${name}`), 'utf8');

const state = (page) => page.evaluate(() => document.querySelector('roomcast-view').state);
const roomFrame = (page) => page.frames().find((frame) => frame !== page.mainFrame() && frame.url() !== 'about:blank');
const policyOf = async (url) => (await fetch(url)).headers.get('content-security-policy');

describe('a room in a page of another site', () => {
  let data, hub, named, stranger, sensor, browser, token;
  before(async () => {
    requireBuilt();
    data = mkdtempSync(join(tmpdir(), 'roomcast-embed-'));
    const pages = {};
    const folders = {
      '/node_modules/roomcast-view/': fromRoot('build/roomcast-view'),
      '/node_modules/three/': fromRoot('web/node_modules/three'),
    };
    named = await startSite(pages, folders);
    stranger = await startSite(pages, folders);
    const config = join(data, 'roomcast.toml');
    writeFileSync(
      config,
      `access.origins = ["${named.address}"]
       [[room]]
       name = "room"
       embed_from = ["${named.address}"]
       [[room]]
       name = "private room"
       view = "token"
       embed_from = ["${named.address}"]
       [[room]]
       name = "closed"`,
    );
    hub = await startHub(0, { data, more: ['--config', config] });
    token = await adminsToken(data);
    sensor = startSensor(hub, 0, { fps: 3, token, room: 'room' });
    browser = await startBrowser({ width: 900, height: 700 });
    const here = (text) => text.replaceAll('https://hub.example.org', hub.page.slice(0, -1)).replaceAll('room=lab', 'room=room').replaceAll("'lab'", "'room'");
    pages['/'] = here(example('room_in_a_page.html'));
    pages['/layer'] = here(example('room_as_a_layer.html'));
    pages['/empty'] = here('<title>x</title><script type="module" src="https://hub.example.org/roomcast-view.js"></script>');
  }, slow);
  after(async () => {
    await browser?.end();
    await sensor?.end();
    await hub?.end();
    await named?.end();
    await stranger?.end();
    rmSync(data, { recursive: true, force: true });
  }, slow);

  async function open(site, path = '/') {
    const page = await browser.context.newPage();
    await page.goto(site.address + path);
    return page;
  }

  /** A page with one <roomcast-view> whose attributes and properties are set before it is there. */
  async function place(site, attributes, properties = {}) {
    const page = await open(site, '/empty');
    await page.evaluate(
      async ([attributes, properties]) => {
        await customElements.whenDefined('roomcast-view');
        const view = document.createElement('roomcast-view');
        window.told = [];
        view.addEventListener('roomcast-state', ({ detail }) => window.told.push(detail));
        Object.entries(attributes).forEach(([name, value]) => view.setAttribute(name, value));
        Object.assign(view, properties);
        document.body.append(view);
      },
      [attributes, properties],
    );
    return page;
  }

  const untilDrawn = (page) =>
    until(
      'the frame draws the room',
      async () => (await roomFrame(page)?.evaluate(() => window.roomcast?.sensors() ?? []).catch(() => [])) ?? [],
      (sensors) => sensors.some(({ shownSeq }) => shownSeq !== null),
    );

  test('is shown where its owner has named the site', slow, async () => {
    const page = await open(named);
    await until('it is live', () => page.locator('#said').innerText(), (text) => /^Live: 1 sensor\(s\), 1 person/.test(text));
    await untilDrawn(page);
    const { phase, room, sensors, muted } = await state(page);
    assert.deepEqual({ phase, room, sensors, muted }, { phase: 'joined', room: 'room', sensors: 1, muted: true });
    for (const hidden of ['#panel', '#tools', '#hint'])
      assert.equal(await roomFrame(page).locator(hidden).isVisible(), false, hidden);
    const size = await page.locator('roomcast-view').boundingBox();
    assert.ok(Math.abs(size.width / size.height - 16 / 9) < 0.01, 'it has a size without a style sheet');
    assert.deepEqual(await seriousFindings(page), []);
    await page.screenshot({ path: process.env.ROOMCAST_SHOTS ? `${process.env.ROOMCAST_SHOTS}/embed.png` : undefined });
    await page.close();
  });

  test('is refused elsewhere, with a sentence that says what the owner can do', slow, async () => {
    const page = await open(stranger);
    await until('it is refused', () => state(page), ({ phase }) => phase === 'refused');
    const said = await page.locator('#said').innerText();
    assert.ok(said.includes(`embed_from = ["${stranger.address}"]`), said);
    assert.deepEqual(page.frames().slice(1).filter((frame) => frame.url().startsWith(hub.page)), []);
    await page.screenshot({ path: process.env.ROOMCAST_SHOTS ? `${process.env.ROOMCAST_SHOTS}/refused.png` : undefined });
    await page.close();
    const closed = await place(named, { src: `${hub.page}?room=closed` });
    await until('this room is closed to all', () => state(closed), ({ phase }) => phase === 'refused');
    await closed.close();
  });

  test('is a matter of the address: a page that names no room, or another, is for no frame', slow, async () => {
    const allows = (site) => new RegExp(`frame-ancestors ${site.replace(/[.]/g, '\\.')}$`);
    assert.match(await policyOf(`${hub.page}?room=room`), allows(named.address));
    assert.match(await policyOf(`${hub.page}?mode=mesh&room=private+room`), allows(named.address));
    for (const address of ['', '?room=', '?room=closed', '?room=none', '?room=closed&room=room', 'index.html?rooms=room'])
      assert.match(await policyOf(hub.page + address), /frame-ancestors 'none'$/, address);
  });

  test('of a room that needs a token takes it as a property, and tells nobody', slow, async () => {
    const src = `${hub.page}?room=private room`;
    const without = await place(named, { src });
    const refused = await until('it asks', () => state(without), ({ needsToken }) => needsToken);
    assert.match(refused.sentence, /token/);
    assert.equal(await roomFrame(without).getByLabel('Token').count(), 1);
    assert.equal(await roomFrame(without).locator('form.token').isVisible(), false, 'nobody types a token into a frame');
    await without.close();

    const page = await place(named, { src }, { token });
    await until('it is live', () => state(page), ({ phase }) => phase === 'joined');
    assert.ok(!(await page.content()).includes(token));
    assert.ok(!JSON.stringify(await page.evaluate(() => window.told)).includes(token));
    await until('the address is clean', () => roomFrame(page).url(), (url) => !url.includes(token));
    assert.equal(await roomFrame(page).evaluate(() => sessionStorage.length), 0);
    const console = roomFrame(page).getByRole('button', { name: 'Console', exact: true });
    assert.equal(await console.isVisible(), false, 'an admin has no console in a frame');
    await page.close();

    const careless = await place(named, { src: `${src}#token=${token}` });
    const { phase, sentence } = await state(careless);
    assert.equal(phase, 'refused');
    assert.match(sentence, /property `token`/);
    await careless.close();
  });

  test('uses no token that the same tab has for the hub', slow, async () => {
    const page = await browser.context.newPage();
    await page.goto(`${hub.page}?room=private+room#token=${token}`);
    await page.getByRole('button', { name: 'Console', exact: true }).waitFor();
    await page.goto(`${named.address}/empty`);
    await page.evaluate((src) => {
      const view = document.createElement('roomcast-view');
      view.src = src;
      document.body.append(view);
    }, `${hub.page}?room=private room`);
    await until('it asks', () => state(page), ({ needsToken }) => needsToken);
    await page.close();
  });

  test('does what the page around it asks', slow, async () => {
    const page = await place(named, { src: `${hub.page}?room=room`, muted: '', mode: 'mesh', name: 'Ada' });
    await untilDrawn(page);
    await page.evaluate(() => document.querySelector('roomcast-view').removeAttribute('muted'));
    await until('it is heard', () => state(page), ({ muted }) => !muted);
    await page.evaluate(() => document.querySelector('roomcast-view').goTo([1, 1.5, 1], [0, 1, 0]));
    const viewOf = () => roomFrame(page).evaluate(() => window.roomcast.view());
    await until('it is there', viewOf, ({ position }) => Math.hypot(position[0] - 1, position[2] - 1) < 1e-3);
    await page.evaluate(() => document.querySelector('roomcast-view').setAttribute('mode', 'points'));
    const mode = () => roomFrame(page).locator('input[name=mode]:checked').inputValue();
    await until('it draws points', mode, (value) => value === 'points');

    await page.evaluate(() => document.querySelector('roomcast-view').remove());
    await until('the frame is gone', () => page.frames().length, (count) => count === 1);
    await page.close();
  });

  test('ends when the owner withdraws it, and nonsense is refused', slow, async () => {
    const change = (embed_from) =>
      fetch(`${hub.page}api/v1/rooms/closed`, {
        method: 'PATCH',
        headers: { authorization: `Bearer ${token}` },
        body: JSON.stringify({ embed_from }),
      });
    for (const wrong of ['*', 'example.org', 'https://example.org/page', "https://a.org; script-src *"]) {
      const answer = await change([wrong]);
      assert.equal(answer.status, 400, wrong);
      assert.match((await answer.json()).error.sentence, /^embed_from: ".*" is no web site; /);
    }
    assert.equal((await change([stranger.address.toUpperCase()])).status, 200);
    const page = await place(stranger, { src: `${hub.page}?room=closed` });
    await until('it is shown', () => state(page), ({ phase }) => phase === 'joined');
    await page.close();
    assert.equal((await change([])).status, 200);
    assert.match(await policyOf(`${hub.page}?room=closed`), /frame-ancestors 'none'$/);
  });

  test('is a layer of a three.js scene where the hub lists the site, and says why not elsewhere', slow, async () => {
    const page = await open(named, '/layer');
    const complaints = [];
    page.on('pageerror', (error) => complaints.push(error.message));
    const layer = () => page.evaluate(() => window.room?.state ?? {});
    await until('it draws', layer, ({ sets }) => sets >= 2);
    assert.deepEqual((await layer()).sensors, ['s0']);
    const colours = await page.evaluate(async () => {
      const drawn = document.querySelector('canvas');
      const picture = document.createElement('canvas').getContext('2d');
      await new Promise((done) => requestAnimationFrame(() => (picture.drawImage(drawn, 0, 0, 60, 60), done())));
      return new Set(new Uint32Array(picture.getImageData(0, 0, 60, 60).data.buffer)).size;
    });
    assert.ok(colours > 50, `${colours} colours`);
    await page.screenshot({ path: process.env.ROOMCAST_SHOTS ? `${process.env.ROOMCAST_SHOTS}/layer.png` : undefined });
    await page.evaluate(() => window.room.dispose());
    assert.deepEqual(complaints, []);
    await page.close();

    const other = await open(stranger, '/layer');
    const refused = await until('it waits', () => other.evaluate(() => window.room?.state ?? {}), ({ sentence }) => sentence);
    assert.equal(refused.sets, 0);
    await other.close();
  });
});
