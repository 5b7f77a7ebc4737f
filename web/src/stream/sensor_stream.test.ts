// SPDX-License-Identifier: Apache-2.0
// One sensor's stream on golden payloads: a key frame and three that follow, of 75x51 pixels, with colour.
import { existsSync, readFileSync } from 'node:fs';
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { CodecModule } from '../codec/codec_module';
import type { FrameHeader } from '../wire/frame_header';
import { BufferPool } from './buffer_pool';
import type { MotionFinder } from './motion_finder';
import type { ViewFrame } from './protocol';
import { SensorStream } from './sensor_stream';

const wasm = new URL('../../../build/wasm/roomcast_codec.wasm', import.meta.url);
const built = existsSync(wasm);
const reason = built ? '' : ' (skipped: build/wasm/roomcast_codec.wasm is not built)';
const grid = { width: 75, height: 51 };
const pixels = grid.width * grid.height;

const payloads = [0, 1, 2, 3].map(
  (n) => new Uint8Array(readFileSync(new URL(`../../../tests/golden/frame_color_${n}.bin`, import.meta.url))),
);
/** Headers as sent by the hub: base frames are 0 and 2, the others may be left out. */
const baseOf = [0, 0, 0, 2];

function headerOf(n: number): FrameHeader {
  return {
    key: n === 0,
    last: true,
    small: false,
    sensor: 5,
    layer: n % 2,
    codec: 1,
    seq: n,
    setId: BigInt(100 + n),
    capture_ns: BigInt(n) * 1_000_000n,
    clockError_us: 1500,
    baseSeq: baseOf[n]!,
    payloadLength: payloads[n]!.length,
    headerLength: 48,
  };
}

/** The required part of WebCodecs: returns grey pictures on demand. */
class FakeVideoDecoder {
  static last: FakeVideoDecoder;
  state = 'unconfigured';
  decodeQueueSize = 0;
  chunks: { type: string; timestamp: number }[] = [];
  constructor(readonly init: { output(frame: unknown): void; error(error: Error): void }) {
    FakeVideoDecoder.last = this;
  }
  configure(): void {
    this.state = 'configured';
  }
  decode(chunk: { type: string; timestamp: number }): void {
    this.chunks.push(chunk);
  }
  close(): void {
    this.state = 'closed';
  }
  async finish(): Promise<void> {
    for (const { timestamp } of this.chunks.splice(0)) this.init.output(greyFrame(timestamp));
    await vi.waitFor(() => {});
  }
}

function greyFrame(timestamp: number) {
  const [cw, ch] = [38, 26];
  return {
    timestamp,
    format: 'I420',
    visibleRect: grid,
    allocationSize: () => pixels + 2 * cw * ch,
    copyTo: async (bytes: Uint8Array) => {
      bytes.fill(128);
      return [
        { offset: 0, stride: grid.width },
        { offset: pixels, stride: cw },
        { offset: pixels + cw * ch, stride: cw },
      ];
    },
    close: () => {},
  };
}

let settled: (ViewFrame | undefined)[];
let keyRequests: number;

async function streamWith(color: boolean, motion: { make: MotionFinder['make'] } = { make: undefined }): Promise<SensorStream> {
  const codec = await CodecModule.load(readFileSync(wasm));
  const config = color ? { codec: 'vp09.00.10.08', codedWidth: grid.width, codedHeight: grid.height } : undefined;
  return new SensorStream(
    5,
    { ...grid, fx: 60, fy: 60, cx: 37, cy: 25 },
    { codec, color: config, buffers: new BufferPool(), motion },
    {
      decoded: () => {},
      settled: (_set, frame) => settled.push(frame),
      keyFrameNeeded: () => keyRequests++,
    },
  );
}

const seqs = () => settled.map((frame) => frame?.seq);

beforeEach(() => {
  settled = [];
  keyRequests = 0;
  vi.stubGlobal('VideoDecoder', FakeVideoDecoder);
  vi.stubGlobal(
    'EncodedVideoChunk',
    class {
      constructor(init: object) {
        Object.assign(this, init);
      }
    },
  );
});
afterEach(() => vi.unstubAllGlobals());

describe.skipIf(!built)(`a sensor's stream${reason}`, () => {
  test('without a colour decoder gives depth at once', async () => {
    const stream = await streamWith(false);
    payloads.forEach((payload, n) => stream.push(headerOf(n), payload));
    expect(seqs()).toEqual([0, 1, 2, 3]);
    expect(settled[3]).toMatchObject({ sensor: 5, setId: 103n, capture_ms: 3, captureError_ms: 1.5, rgba: undefined });
    expect(settled[0]!.depth_mm.length).toBe(pixels);
    expect(stream.traffic).toMatchObject({ frames: 4, skipped: 0, missed: 0, lastSeq: 3 });
  });

  test('asks for the motion of the frames that are shown, while it is wanted', async () => {
    const taken: bigint[] = [];
    const field = Float32Array.of(1, 2, 3, 4);
    const make = () => ({
      take: (depth_mm: Uint16Array, capture_ns: bigint) => {
        expect(depth_mm.length).toBe(pixels);
        return taken.push(capture_ns) > 1 ? field : undefined;
      },
      destroy: () => {},
    });
    const motion: { make: MotionFinder['make'] } = { make: undefined };
    const stream = await streamWith(false, motion);
    stream.push(headerOf(0), payloads[0]!);
    motion.make = make;
    stream.push(headerOf(1), payloads[1]!);
    stream.push(headerOf(2), payloads[2]!, true);
    stream.push(headerOf(3), payloads[3]!);
    expect(taken).toEqual([1_000_000n, 3_000_000n]);
    expect(settled.map((frame) => frame?.flow)).toEqual([undefined, undefined, field]);
    expect(settled[2]!.flow!.buffer).not.toBe(field.buffer);
  });

  test('holds a frame until its colour is there, and masks the colour', async () => {
    const stream = await streamWith(true);
    stream.push(headerOf(0), payloads[0]!);
    stream.push(headerOf(1), payloads[1]!);
    expect(settled).toEqual([]);
    expect(FakeVideoDecoder.last.chunks.map((chunk) => chunk.type)).toEqual(['key', 'delta']);
    await FakeVideoDecoder.last.finish();
    expect(seqs()).toEqual([0, 1]);
    const rgba = settled[0]!.rgba!;
    expect(rgba.length).toBe(4 * pixels);
    const alphas = new Set(rgba.filter((_, i) => i % 4 === 3));
    expect([...alphas].sort()).toEqual([0, 255]);
    expect([...rgba.subarray(0, 3)]).toEqual([130, 130, 130]);
  });

  test('that misses a base frame skips dependent frames and asks for a key frame', async () => {
    const stream = await streamWith(false);
    stream.push(headerOf(0), payloads[0]!);
    stream.push(headerOf(3), payloads[3]!);
    expect(seqs()).toEqual([0, undefined]);
    expect(keyRequests).toBe(1);
    expect(stream.traffic.skipped).toBe(1);
    expect(stream.traffic.missed).toBe(2);
  });

  test('misses no frame that the hub leaves out because nobody sees it', async () => {
    const stream = await streamWith(false);
    stream.push(headerOf(0), payloads[0]!);
    stream.expectGaps(true);
    stream.push(headerOf(3), payloads[3]!);
    stream.expectGaps(false);
    stream.push(headerOf(3), payloads[3]!);
    expect(stream.traffic.missed).toBe(0);
  });

  test('is held back no longer once the connection is a new one', async () => {
    const stream = await streamWith(false);
    stream.traffic.isHeldBack = true;
    stream.restart();
    expect(stream.traffic.isHeldBack).toBe(false);
  });

  test('counts what it misses of each rendition by itself', async () => {
    const stream = await streamWith(false);
    stream.push({ ...headerOf(0), seq: 10 }, payloads[0]!);
    stream.push({ ...headerOf(0), seq: 500, small: true }, payloads[0]!);
    expect(stream.traffic).toMatchObject({ missed: 0, isSmall: true });
    stream.push({ ...headerOf(0), seq: 502, small: true }, payloads[0]!);
    stream.push({ ...headerOf(0), seq: 900 }, payloads[0]!);
    expect(stream.traffic).toMatchObject({ missed: 1, isSmall: false });
  });

  test('with a damaged frame says so, asks for a key frame, and recovers with it', async () => {
    const stream = await streamWith(false);
    stream.push(headerOf(0), payloads[0]!.subarray(0, 100));
    expect(stream.traffic.problem).toMatch(/could not be decoded/);
    expect(keyRequests).toBe(1);
    stream.push(headerOf(1), payloads[1]!);
    expect(seqs()).toEqual([undefined, undefined]);
    stream.push(headerOf(0), payloads[0]!);
    expect(seqs().at(-1)).toBe(0);
    expect(stream.traffic.problem).toBe('');
  });

  test('of a codec of a later version is refused', async () => {
    const stream = await streamWith(false);
    stream.push({ ...headerOf(0), codec: 9 }, payloads[0]!);
    expect(stream.traffic.problem).toMatch(/Codec 9/);
  });

  test('with a failed colour decoder shows depth, asks for a key frame, and begins anew', async () => {
    const stream = await streamWith(true);
    stream.push(headerOf(0), payloads[0]!);
    const failed = FakeVideoDecoder.last;
    failed.init.error(new Error('out of memory'));
    expect(seqs()).toEqual([0]);
    expect(settled[0]!.rgba).toBeUndefined();
    expect(stream.traffic.problem).toMatch(/colour decoder gave up: out of memory/);
    expect(keyRequests).toBe(1);
    stream.push(headerOf(1), payloads[1]!);
    expect(seqs()).toEqual([0, undefined]);
    stream.push(headerOf(0), payloads[0]!);
    expect(FakeVideoDecoder.last).not.toBe(failed);
    await FakeVideoDecoder.last.finish();
    expect(settled.at(-1)!.rgba).toBeDefined();
  });

  test('of a lost connection completes waiting frames and begins with a key frame', async () => {
    const stream = await streamWith(true);
    stream.push(headerOf(0), payloads[0]!);
    stream.restart();
    expect(seqs()).toEqual([0]);
    stream.push(headerOf(2), payloads[2]!);
    expect(seqs()).toEqual([0, undefined]);
    stream.destroy();
  });
});
