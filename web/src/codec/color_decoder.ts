// SPDX-License-Identifier: Apache-2.0
// Decodes one sensor's colour: VP9 frames through WebCodecs, returned as planes in memory. docs/spec/codec.md §3.1.
// Each frame is returned under the number with which it was submitted. After `onFailure` the decoder is closed; a new
// one must begin with a key frame.
import type { YcbcrPlanes } from './color_conversion';

const maxFramesInside = 32; // more means that the decoder has stalled

export interface ColorDecoderEvents {
  /** `planes` is valid during the call. */
  onPlanes(number: number, planes: YcbcrPlanes): void;
  onFailure(sentence: string): void;
}

function configFor(width: number, height: number, acceleration: HardwareAcceleration): VideoDecoderConfig {
  return {
    codec: 'vp09.00.10.08',
    codedWidth: width,
    codedHeight: height,
    hardwareAcceleration: acceleration,
    optimizeForLatency: true,
  };
}

/**
 * The decoder configuration for pictures of this size, or undefined when the browser has none. Software is preferred:
 * the pictures are small, and software frames need not be copied from the graphics card.
 */
export async function colorDecoderConfig(width: number, height: number): Promise<VideoDecoderConfig | undefined> {
  if (typeof VideoDecoder === 'undefined') return undefined;
  for (const acceleration of ['prefer-software', 'no-preference'] as const) {
    const config = configFor(width, height, acceleration);
    if ((await VideoDecoder.isConfigSupported(config)).supported) return config;
  }
  return undefined;
}

function planesOf(bytes: Uint8Array, format: VideoPixelFormat, layout: PlaneLayout[], scale: 1 | 2): YcbcrPlanes {
  const [y, second, third] = layout as [PlaneLayout, PlaneLayout, PlaneLayout];
  if (format === 'I420') return { bytes, y, cb: second, cr: third, chromaStep: 1, scale };
  return { bytes, y, cb: second, cr: { offset: second.offset + 1, stride: second.stride }, chromaStep: 2, scale };
}

export class ColorDecoder {
  private readonly decoder: VideoDecoder;
  private readonly scratch: Uint8Array<ArrayBuffer>[] = [];
  private closed = false;

  constructor(
    private readonly config: VideoDecoderConfig,
    private readonly events: ColorDecoderEvents,
  ) {
    this.decoder = new VideoDecoder({
      output: (frame) => void this.read(frame),
      error: (error) => this.fail(error.message),
    });
    this.decoder.configure(config);
  }

  /** `number` increases; it is the chunk's time stamp, which WebCodecs passes through. */
  decode(number: number, key: boolean, vp9: Uint8Array): void {
    if (this.closed) return;
    if (this.decoder.decodeQueueSize > maxFramesInside) return this.fail('it has stalled');
    try {
      this.decoder.decode(new EncodedVideoChunk({ type: key ? 'key' : 'delta', timestamp: number, data: vp9 }));
    } catch (error) {
      this.fail((error as Error).message);
    }
  }

  close(): void {
    if (this.closed) return;
    this.closed = true;
    if (this.decoder.state !== 'closed') this.decoder.close();
  }

  private fail(reason: string): void {
    if (this.closed) return;
    this.close();
    this.events.onFailure(`The colour decoder gave up: ${reason}.`);
  }

  private async read(frame: VideoFrame): Promise<void> {
    try {
      const format = this.check(frame);
      const bytes = this.scratchOf(frame.allocationSize());
      const layout = await frame.copyTo(bytes);
      if (!this.closed) this.events.onPlanes(frame.timestamp, planesOf(bytes, format, layout, this.scaleOf(frame)));
      this.scratch.push(bytes);
    } catch (error) {
      this.fail((error as Error).message);
    } finally {
      frame.close();
    }
  }

  private scratchOf(size: number): Uint8Array<ArrayBuffer> {
    const bytes = this.scratch.pop();
    return bytes?.length === size ? bytes : new Uint8Array(size);
  }

  private check(frame: VideoFrame): VideoPixelFormat {
    if (frame.format !== 'I420' && frame.format !== 'NV12') {
      throw new Error(`pictures in the format ${frame.format} are not understood`);
    }
    this.scaleOf(frame);
    return frame.format;
  }

  /** Colour has the depth grid's resolution, or twice that. */
  private scaleOf(frame: VideoFrame): 1 | 2 {
    const { width, height } = frame.visibleRect!;
    const { codedWidth, codedHeight } = this.config;
    for (const scale of [1, 2] as const) {
      if (width === scale * codedWidth! && height === scale * codedHeight!) return scale;
    }
    throw new Error(`a picture is ${width}x${height}`);
  }
}
