// SPDX-License-Identifier: Apache-2.0
// The page's requests, its permissions as set by the hub, and the size of a first visit.
import assert from 'node:assert/strict';
import { get } from 'node:http';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { slow, untilAllShown } from './waiting.mjs';

const mostBytes = 600_000;

/** Size of a file as transferred to a browser. */
function bytesOnTheWire(url) {
  return new Promise((done, failed) => {
    get(url, { headers: { 'accept-encoding': 'gzip' } }, (response) => {
      let size = 0;
      response.on('data', (piece) => (size += piece.length)).on('end', () => done(size));
    }).on('error', failed);
  });
}

describe('the page', () => {
  let hub, sensor, browser;
  const asked = [];
  before(async () => {
    requireBuilt();
    hub = await startHub();
    sensor = startSensor(hub, 0, { fps: 2 });
    browser = await startBrowser({ width: 320, height: 240 });
  }, slow);
  after(async () => {
    await browser?.end();
    await sensor?.end();
    await hub?.end();
  }, slow);

  test('connects to its hub only, runs isolated, and obeys its own policy', slow, async () => {
    browser.context.on('request', (request) => asked.push(new URL(request.url())));
    const page = await openPage(browser.context, `${hub.page}?panel=1`);
    await untilAllShown(page, 1);
    const strangers = asked.filter(({ protocol, host }) => protocol !== 'data:' && host !== `127.0.0.1:${hub.port}`);
    assert.deepEqual(strangers.map(String), []);
    assert.ok(asked.length >= 4, 'page, script, style, worker');
    assert.equal(await page.evaluate(() => window.crossOriginIsolated), true);
    const policy = (await (await fetch(hub.page)).headers.get('content-security-policy')) ?? '';
    assert.match(policy, /default-src 'none'/);
    assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'|\*/);
    assert.deepEqual(page.complaints, [], 'a breach of the policy would be one');
  });

  test('runs no foreign or inline scripts', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?panel=0`);
    const ran = await page.evaluate(async () => {
      const script = document.createElement('script');
      script.textContent = 'window.injected = true';
      document.head.append(script);
      await new Promise((resolve) => setTimeout(resolve, 50));
      return window.injected === true;
    });
    assert.equal(ran, false);
    await assert.rejects(page.evaluate(() => fetch('https://example.com/')));
    await page.close();
  });

  test('is asked for again at each visit, its styles and decoder never', slow, async () => {
    const cachingOf = async (url) => (await fetch(url)).headers.get('cache-control');
    const hashed = asked.filter(({ pathname }) => pathname.startsWith('/assets/'));
    const lasting = hashed.filter(({ pathname }) => !pathname.endsWith('.js'));
    assert.ok(lasting.length >= 2, 'style, decoder');
    for (const url of lasting) assert.match(await cachingOf(url), /max-age=31536000, immutable/);
    // A worker's policy comes with its script.
    const scripts = hashed.filter(({ pathname }) => pathname.endsWith('.js'));
    for (const url of [hub.page, ...scripts]) assert.equal(await cachingOf(url), 'no-cache');
  });

  test('loads no more than 600 KB', slow, async (t) => {
    const files = [...new Set(asked.filter(({ protocol }) => protocol === 'http:').map(String))];
    const sizes = await Promise.all(files.map(bytesOnTheWire));
    const total = sizes.reduce((sum, size) => sum + size, 0);
    t.diagnostic(`${files.length} files, ${Math.round(total / 1000)} KB`);
    assert.ok(total > 100_000 && total <= mostBytes, `${total} bytes of ${files.join(' ')}`);
  });
});
