// SPDX-License-Identifier: Apache-2.0
// A hub, three simulated sensors and Chromium, all real processes on loopback: what a user sees, and the state behind
// it. The tests build on each other, in order, on one room.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser, withoutHub } from './browser.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { coverageOf, panelText, sensorsOf, slow, stateOf, until, untilAllShown } from './waiting.mjs';

const sensorCount = 3;
const fps = 4; // three sensors, hub, decoders and a software renderer share few cores
const view = 'panel=0&at=0.2,1.7,2.6&look=0,0.9,-1';
const leastPixels = 500; // covered by only one sensor
const comparedFrames = 10;

const logs = mkdtempSync(join(tmpdir(), 'roomcast-logs-'));
const logOf = (n) => join(logs, `s${n}.jsonl`);
let hub, sensors, browser, page;

describe('a room of three sensors', () => {
  before(async () => {
    requireBuilt();
    hub = await startHub();
    sensors = Array.from({ length: sensorCount }, (_, n) => startSensor(hub, n, { fps, log: logOf(n) }));
    browser = await startBrowser();
    page = await openPage(browser.context, `${hub.page}?${view}&record=1&name=first`);
  }, slow);

  after(async () => {
    await browser?.end();
    await Promise.all([...(sensors ?? []), hub].map((program) => program?.end()));
    rmSync(logs, { recursive: true, force: true });
  }, slow);

  test('all sensors are drawn: each one at pixels that only it sees', slow, async () => {
    await untilAllShown(page, sensorCount);
    for (const { id, only } of await coverageOf(page)) {
      assert.ok(only > leastPixels, `sensor ${id} alone covers ${only} pixels`);
      const setVisible = (visible) => page.evaluate(([n, v]) => window.roomcast.setVisible(n, v), [id, visible]);
      // The room is live: pixels that only one sensor drew a moment ago may have no reading now.
      const drawnAndWithout = async () => {
        const { example } = (await coverageOf(page)).find((sensor) => sensor.id === id);
        const pixelThere = () => page.evaluate(([x, y]) => window.roomcast.pixel(x, y), example);
        const drawn = await pixelThere();
        await setVisible(false);
        const without = await pixelThere();
        await setVisible(true);
        return { drawn, without };
      };
      const isAlone = ({ drawn, without }) => drawn.sensor === id && without.sensor === null;
      const { drawn, without } = await until(`a pixel that sensor ${id} alone draws`, drawnAndWithout, isAlone);
      assert.notDeepEqual(drawn.rgba, without.rgba);
    }
  });

  test('depth in the page equals the sources’ depth bit for bit', slow, async () => {
    for (const { id, name } of await sensorsOf(page)) {
      const framesOf = () => page.evaluate((sensor) => window.roomcast.decodedFrames(sensor), id);
      const decoded = await until(`frames of ${name}`, framesOf, (frames) => frames.length >= comparedFrames);
      const produced = await until(
        `the log of ${name}`,
        () => readLog(logOf(name.slice(1))),
        (log) => log.has(decoded.at(-1).seq),
      );
      for (const { seq, captureNs, depthCrc32 } of decoded) {
        const source = produced.get(seq);
        assert.ok(source, `${name} did not log frame ${seq}`);
        assert.equal(captureNs, source.capture_ns, `capture time of frame ${seq} of ${name}`);
        assert.equal(depthCrc32, source.depth_crc32, `depth of frame ${seq} of ${name}`);
      }
      assert.ok(
        new Set(decoded.map((frame) => frame.depthCrc32)).size > comparedFrames / 2,
        `${name} sends different pictures`,
      );
    }
  });

  test('the picture keeps moving', slow, async () => {
    const before = { state: await stateOf(page), sensors: await sensorsOf(page) };
    const pictures = new Set();
    const look = async () => pictures.add(await page.evaluate(() => window.roomcast.pictureCrc32())).size;
    await until('three different pictures', look, (different) => different >= 3);
    await until(
      'every sensor goes on',
      () => sensorsOf(page),
      (now) =>
        now.every(
          (sensor, i) => sensor.frames > before.sensors[i].frames + 2 && sensor.shownSeq > before.sensors[i].shownSeq,
        ),
    );
    const now = await stateOf(page);
    assert.ok(now.shownSets > before.state.shownSets && now.pictures > before.state.pictures);
    assert.ok(now.latency_ms > 0, `latency ${now.latency_ms} ms`);
  });

  test('two viewers see each other', slow, async () => {
    const second = await openPage(browser.context, `${hub.page}?${view}&name=second`);
    const { viewerId } = await until(
      'it has joined',
      () => stateOf(second),
      (state) => state.viewerId !== null,
    );
    const { viewerId: first } = await stateOf(page);
    await until(
      "the second viewer's avatar",
      () => stateOf(page),
      (state) => state.avatars.includes(viewerId),
    );
    await until(
      "the first viewer's avatar",
      () => stateOf(second),
      (state) => state.avatars.includes(first),
    );
    assert.deepEqual((await stateOf(second)).viewers.map((viewer) => viewer.name).sort(), ['first', 'second']);
    await second.close();
    await until(
      'one viewer again',
      () => stateOf(page),
      (state) => state.viewers.length === 1,
    );
  });

  test('a sensor that is killed and started again comes back with the same id and pose', slow, async () => {
    const victim = (await sensorsOf(page)).find((sensor) => sensor.name === 's1');
    const now = async () => (await sensorsOf(page)).find((sensor) => sensor.name === 's1');
    await sensors[1].end('SIGKILL');
    await until('it is gone', now, (sensor) => !sensor.online);
    const others = await sensorsOf(page);
    await until(
      'the others go on',
      () => sensorsOf(page),
      (sensors) => sensors.every((sensor, i) => !sensor.online || sensor.frames > others[i].frames),
    );
    const { frames } = await now();
    sensors[1] = startSensor(hub, 1, { fps });
    const back = await until('it is back', now, (sensor) => sensor.online && sensor.frames > frames + 2);
    assert.equal(back.id, victim.id);
    assert.deepEqual(back.worldFromDepth, victim.worldFromDepth);
    const covered = (await coverageOf(page)).find((sensor) => sensor.id === victim.id);
    assert.ok(covered.only > leastPixels);
    assert.equal((await sensorsOf(page)).length, sensorCount);
  });

  test('a hub that disappears is reported in the page, and the page recovers when it is back', slow, async () => {
    const { port } = hub;
    assert.deepEqual(page.complaints, [], 'before');
    await hub.end('SIGKILL');
    await until(
      'the page notices',
      () => stateOf(page),
      (state) => state.phase === 'waiting',
    );
    const said = await until(
      'the panel says so',
      () => panelText(page),
      (text) => /hub/.test(text),
    );
    assert.match(said, /The (connection to the )?hub .*(is gone|does not answer|has stopped)/);
    hub = await startHub(port);
    await until(
      'joined again',
      () => stateOf(page),
      (state) => state.phase === 'joined' && state.firstShown_ms !== null,
      40_000,
    );
    const before = await untilAllShown(page, sensorCount);
    await until(
      'frames again',
      () => sensorsOf(page),
      (now) => now.every((sensor, i) => sensor.online && sensor.frames > before[i].frames),
    );
  });

  test('the page has logged no errors', () => {
    assert.deepEqual(
      page.complaints.filter((complaint) => !withoutHub.test(complaint)),
      [],
    );
  });
});

/** Frames by sequence number. capture_ns exceeds 2^53, so it is kept as text. */
function readLog(file) {
  const complete = readFileSync(file, 'utf8').split('\n').slice(0, -1);
  return new Map(
    complete.map((line) => {
      const { seq, capture_ns, depth_crc32 } = JSON.parse(line.replace(/("capture_ns":)(-?\d+)/, '$1"$2"'));
      return [seq, { capture_ns, depth_crc32 }];
    }),
  );
}
