// SPDX-License-Identifier: Apache-2.0
// For the tests of a whole file: a hub with a folder of its own, an admin's token, one sensor and a browser, before the
// first test and until after the last.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { startBrowser } from './browser.mjs';
import { adminsToken, requireBuilt, startHub, startSensor } from './programs.mjs';
import { slow } from './waiting.mjs';

/** The room's `hub`, `token`, `sensor` and `browser`, from the first test on; `data` is the hub's folder. `more` are arguments of the browser. */
export function oneSensorRoom(name, { more = [] } = {}) {
  const room = { data: mkdtempSync(join(tmpdir(), `roomcast-${name}-`)) };

  before(async () => {
    requireBuilt();
    room.hub = await startHub(0, { data: room.data });
    room.token = await adminsToken(room.data);
    room.sensor = startSensor(room.hub, 0, { fps: 3 });
    room.browser = await startBrowser({ width: 1000, height: 640, more });
  }, slow);

  after(async () => {
    await room.browser?.end();
    await room.sensor?.end();
    await room.hub?.end();
    rmSync(room.data, { recursive: true, force: true });
  }, slow);

  return room;
}
