// SPDX-License-Identifier: Apache-2.0
// Tests the modules, with SIMD and without, against the golden frames of the native decoder's tests. Run:
// node --test web/wasm/decoder.test.mjs    ROOMCAST_WASM is the folder of the modules when it is not build/wasm.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = new URL("../../", import.meta.url);
const folder = process.env.ROOMCAST_WASM ?? fileURLToPath(new URL("build/wasm", root));
const modules = ["roomcast_codec", "roomcast_codec_plain"];
const golden = new URL("tests/golden/", root);

function load(name = modules[0]) {
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(join(folder, `${name}.wasm`))));
  exports.__wasm_call_ctors();
  return exports;
}

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  }
  return ~crc >>> 0;
}

function decode(codec, decoder, payload) {
  const at = codec.decoder_input(decoder, payload.length);
  assert.notEqual(at, 0);
  new Uint8Array(codec.memory.buffer, at, payload.length).set(payload);
  return codec.decoder_decode(decoder, payload.length);
}

function errorOf(codec, decoder) {
  const text = new Uint8Array(codec.memory.buffer, codec.decoder_error(decoder), codec.decoder_error_length(decoder));
  return new TextDecoder().decode(text);
}

const frames = JSON.parse(readFileSync(new URL("frames.json", golden), "utf8"));
const payloadOf = (frame) => readFileSync(new URL(frame.file, golden));

// A stream's frames depend on each other: one decoder from each key frame to the next.
let codec, decoder;
for (const [name, frame] of modules.flatMap((name) => frames.map((frame) => [name, frame]))) {
  test(`${frame.file} decodes to what it was made from in ${name}`, () => {
    if (frame.key) {
      codec = load(name);
      decoder = codec.decoder_create(frame.width, frame.height);
    }
    assert.equal(decode(codec, decoder, payloadOf(frame)), 0, errorOf(codec, decoder));
    const pixels = frame.width * frame.height;
    const depth = new Uint8Array(codec.memory.buffer, codec.decoder_depth(decoder), 2 * pixels);
    assert.equal(crc32(depth), frame.depth_crc32);
    const mask = codec.decoder_mask(decoder);
    assert.equal(mask !== 0, frame.mask_crc32 !== undefined);
    if (mask === 0) return;
    assert.equal(crc32(new Uint8Array(codec.memory.buffer, mask, pixels)), frame.mask_crc32);
    assert.equal(codec.decoder_color_offset(decoder), frame.color_offset);
    assert.equal(codec.decoder_color_length(decoder), frame.color_length);
    assert.equal(codec.decoder_color_is_key(decoder), frame.key ? 1 : 0);
  });
}

test("live depth that builds on a missing frame is refused until a key frame comes", () => {
  const codec = load();
  const live = frames.filter((f) => f.file.startsWith("frame_live_1_"));
  const decoder = codec.decoder_create(live[0].width, live[0].height);
  assert.equal(decode(codec, decoder, payloadOf(live[0])), 0);
  assert.equal(decode(codec, decoder, payloadOf(live[2])), 1);
  assert.notEqual(errorOf(codec, decoder), "");
  assert.equal(decode(codec, decoder, payloadOf(live[3])), 1);
  const key = live.findLast((f) => f.key);
  assert.equal(decode(codec, decoder, payloadOf(key)), 0);
});

test("damaged and cut payloads are refused or decoded, and the next good one decodes", () => {
  const codec = load();
  const frame = frames.find((f) => f.mask_crc32 !== undefined);
  const good = payloadOf(frame);
  const decoder = codec.decoder_create(frame.width, frame.height);
  let refused = 0;
  for (let i = 0; i < good.length; i += 7) {
    assert.notEqual(decode(codec, decoder, good.subarray(0, i)), 0);
    const flipped = Uint8Array.from(good);
    flipped[i] ^= 1 << (i % 8);
    if (decode(codec, decoder, flipped) !== 0) refused++;
  }
  assert.ok(refused > 0);
  assert.notEqual(errorOf(codec, decoder), "");
  assert.equal(decode(codec, decoder, good), 0);
});

test("sizes and lengths out of range are refused", () => {
  const codec = load();
  assert.equal(codec.decoder_create(15, 64), 0);
  assert.equal(codec.decoder_create(64, 4097), 0);
  assert.equal(codec.decoder_create(-1, -1), 0);
  const decoder = codec.decoder_create(64, 64);
  assert.equal(codec.decoder_input(decoder, 3 * 64 * 64 + 65536 + 1), 0);
  assert.notEqual(codec.decoder_decode(decoder, 1000), 0);
  codec.decoder_destroy(decoder);
});

test("memory does not grow from frame to frame", () => {
  const codec = load();
  const frame = frames.find((f) => f.mask_crc32 !== undefined);
  const payload = payloadOf(frame);
  const decoder = codec.decoder_create(frame.width, frame.height);
  decode(codec, decoder, payload);
  const before = codec.memory.buffer.byteLength;
  for (let i = 0; i < 200; i++) assert.equal(decode(codec, decoder, payload), 0);
  assert.equal(codec.memory.buffer.byteLength, before);
});
