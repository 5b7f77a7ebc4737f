// SPDX-License-Identifier: Apache-2.0
// The codec's golden payloads in a real browser: the page's decoder gives the same bytes there as on other platforms,
// and the browser's VP9 decoder accepts the colour.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, describe, test } from 'node:test';
import { startBrowser } from './browser.mjs';
import { slow } from './waiting.mjs';

const { transformSync } = createRequire(new URL('../../web/node_modules/vite/package.json', import.meta.url))('esbuild');

const root = new URL('../../', import.meta.url);
const wasm = new URL('build/wasm/roomcast_codec.wasm', root);
const golden = new URL('tests/golden/', root);
const entries = JSON.parse(readFileSync(new URL('frames.json', golden), 'utf8'));
const withColor = entries.filter((entry) => entry.color_length > 0);
const origin = 'https://codec.test'; // served by the test itself; WebCodecs needs a secure page

const typeScript = (path) => transformSync(readFileSync(new URL(path, root), 'utf8'), { loader: 'ts' }).code;

/** Serves the page's requests from the source tree. */
function answer(path) {
  if (path === '/') return { contentType: 'text/html', body: '<!doctype html><title>codec</title>' };
  if (path === '/roomcast_codec.wasm') return { contentType: 'application/wasm', body: readFileSync(wasm) };
  if (path.startsWith('/golden/')) return { body: readFileSync(new URL(path.slice(8), golden)) };
  return { contentType: 'text/javascript', body: typeScript(`web/src${path}`) };
}

/** Runs in the page. Checksums of depth and mask of every payload; a new decoder begins at each key frame. */
async function decodeAll(entries) {
  const { CodecModule, PayloadDecoder } = await import('/codec/codec_module.ts');
  const { crc32 } = await import('/stream/crc32.ts');
  const bytes = async (path) => new Uint8Array(await (await fetch(path)).arrayBuffer());
  const wasm = await bytes('/roomcast_codec.wasm');
  const found = [];
  let decoder;
  for (const { file, width, height, key } of entries) {
    if (key) decoder = new PayloadDecoder(await CodecModule.load(wasm), width, height);
    const { depth_mm, color } = decoder.decode(await bytes(`/golden/${file}`));
    const depth_crc32 = crc32(new Uint8Array(depth_mm.slice().buffer));
    found.push({ file, depth_crc32, mask_crc32: color && crc32(color.seen) });
  }
  return found;
}

/** Runs in the page. Counts the pictures, by size, that the browser decodes from the payloads' colour. */
async function decodeColor(entries) {
  const sizes = [];
  const failures = [];
  const decoder = new VideoDecoder({
    output: (frame) => {
      sizes.push(`${frame.visibleRect.width}x${frame.visibleRect.height}`);
      frame.close();
    },
    error: (error) => failures.push(error.message),
  });
  decoder.configure({ codec: 'vp09.00.10.08', optimizeForLatency: true });
  for (const [timestamp, { file, key, color_offset, color_length }] of entries.entries()) {
    const payload = new Uint8Array(await (await fetch(`/golden/${file}`)).arrayBuffer());
    const data = payload.subarray(color_offset, color_offset + color_length);
    decoder.decode(new EncodedVideoChunk({ type: key ? 'key' : 'delta', timestamp, data }));
  }
  await decoder.flush();
  return { sizes, failures };
}

describe('golden payloads in a browser', () => {
  let browser, page;
  before(async () => {
    assert.ok(existsSync(wasm), 'build/wasm/roomcast_codec.wasm is not built: cmake --build --preset wasm');
    browser = await startBrowser();
    page = await browser.context.newPage();
    await page.route(`${origin}/**`, (route) => route.fulfill(answer(new URL(route.request().url()).pathname)));
    await page.goto(origin);
  }, slow);
  after(() => browser?.end(), slow);

  test('every one decodes to the depth and the mask of the index', slow, async () => {
    const expected = entries.map(({ file, depth_crc32, mask_crc32 }) => ({ file, depth_crc32, mask_crc32 }));
    assert.deepEqual(await page.evaluate(decodeAll, entries), expected);
  });

  test('the colour of every one becomes a picture', slow, async () => {
    const { sizes, failures } = await page.evaluate(decodeColor, withColor);
    assert.deepEqual(failures, []);
    assert.deepEqual(sizes, withColor.map(({ width, height }) => `${width}x${height}`));
  });
});
