// SPDX-License-Identifier: Apache-2.0
// One sensor's frames: wire messages in, drawable frames out. Depth and mask are decoded at once, in wasm; colour comes
// back later from WebCodecs, and the frame is passed on when both are complete. A decoder that misses a frame requests
// a key frame.
import { rgbaFromYcbcr, type YcbcrPlanes } from '../codec/color_conversion';
import { ColorDecoder } from '../codec/color_decoder';
import { PayloadDecoder, PayloadError, type CodecModule, type DecodedPayload } from '../codec/codec_module';
import type { FlowLens } from '../codec/scene_flow';
import { unknownClockError_us, type FrameHeader } from '../wire/frame_header';
import type { BufferPool } from './buffer_pool';
import { FrameChain } from './frame_chain';
import type { MotionFinder, SensorMotion } from './motion_finder';
import { buffersOf, type SensorTraffic, type ViewFrame } from './protocol';

export interface SensorStreamEvents {
  /** `depth_mm` is valid during the call. */
  decoded(header: FrameHeader, depth_mm: Uint16Array): void;
  /** Called exactly once per `push` that is not hidden; undefined when the frame cannot be shown at all. */
  settled(setId: bigint, frame: ViewFrame | undefined): void;
  keyFrameNeeded(sensor: number): void;
}

export interface SensorStreamParts {
  codec: CodecModule;
  color: VideoDecoderConfig | undefined; // undefined: no colour on this browser
  buffers: BufferPool;
  motion: Pick<MotionFinder, 'make'>;
}

interface AwaitsColor {
  frame: ViewFrame;
  seen: Uint8Array<ArrayBuffer>;
}

const codecSections = 1;
const lensFields = ['width', 'height', 'fx', 'fy', 'cx', 'cy'] as const;

export class SensorStream {
  readonly traffic: SensorTraffic;
  private readonly chain = new FrameChain();
  private readonly payloads: PayloadDecoder;
  private motion: SensorMotion | undefined; // undefined until it is wanted
  private readonly awaitsColor = new Map<number, AwaitsColor>();
  private colors: ColorDecoder | undefined;
  private chunks = 0;
  private newestSeq: number | undefined; // highest received, of the rendition that comes
  private hasGaps = false; // the hub leaves frames out

  constructor(
    readonly sensor: number,
    private readonly lens: FlowLens,
    private readonly parts: SensorStreamParts,
    private readonly events: SensorStreamEvents,
  ) {
    this.payloads = new PayloadDecoder(parts.codec, lens.width, lens.height);
    this.traffic = {
      sensor,
      frames: 0,
      bytes: 0,
      skipped: 0,
      missed: 0,
      lastSeq: undefined,
      lastSetId: undefined,
      lastCapture_ms: undefined,
      isHeldBack: false,
      isSmall: false,
      problem: '',
    };
  }

  /** A hidden frame is decoded only because later ones need it. */
  push(header: FrameHeader, payload: Uint8Array, isHidden = false): void {
    this.followRendition(header.small);
    if (isHidden) this.newestSeq = header.seq;
    else this.countMissed(header.seq);
    this.traffic.bytes += header.headerLength + payload.length;
    if (!this.chain.mayDecode(header)) return isHidden ? undefined : this.skip(header);
    let decoded: DecodedPayload;
    try {
      decoded = this.decode(header, payload);
    } catch (error) {
      if (!(error instanceof PayloadError)) throw error;
      return this.giveUp(header, error.message, isHidden);
    }
    this.chain.advance(header);
    if (isHidden) return this.decodeHiddenColor(decoded);
    this.count(header);
    this.events.decoded(header, decoded.depth_mm);
    this.settleOrDecodeColor(this.frameOf(header, decoded), decoded);
  }

  /** Frames that the hub leaves out, because they show nothing that is seen, are not missed. */
  expectGaps(hasGaps: boolean): void {
    this.hasGaps = hasGaps;
    this.newestSeq = undefined;
  }

  /** The connection was lost: the next one begins with a key frame. Pending frames are settled. */
  restart(): void {
    this.closeColor();
    this.chain.lose();
    this.expectGaps(false);
    this.traffic.isHeldBack = false;
  }

  /** Another moment of a recording follows, which begins with a key frame. The colour decoder stays: a new one takes long. */
  rewind(): void {
    this.dropAwaited(false);
    this.chain.lose();
    this.newestSeq = undefined;
  }

  destroy(): void {
    this.closeColor();
    this.payloads.destroy();
    this.motion?.destroy();
  }

  /** False: another sensor has taken this one's place. */
  hasLens(lens: FlowLens): boolean {
    return lensFields.every((field) => this.lens[field] === lens[field]);
  }

  private decode(header: FrameHeader, payload: Uint8Array): DecodedPayload {
    if (header.codec !== codecSections)
      throw new PayloadError(`Codec ${header.codec} is not known to this page.`, true);
    return this.payloads.decode(payload);
  }

  private skip(header: FrameHeader): void {
    this.traffic.skipped++;
    this.events.keyFrameNeeded(this.sensor);
    this.events.settled(header.setId, undefined);
  }

  private giveUp(header: FrameHeader, reason: string, isHidden: boolean): void {
    this.traffic.problem = `A frame could not be decoded: ${reason}`;
    this.chain.lose();
    if (!isHidden) this.skip(header);
  }

  /** Each rendition is numbered by itself. */
  private followRendition(isSmall: boolean): void {
    if (isSmall !== this.traffic.isSmall) this.newestSeq = undefined;
    this.traffic.isSmall = isSmall;
  }

  /** A sensor that reconnects counts from 0 again. */
  private countMissed(seq: number): void {
    if (!this.hasGaps && this.newestSeq !== undefined && seq > this.newestSeq) this.traffic.missed += seq - this.newestSeq - 1;
    this.newestSeq = seq;
  }

  private count(header: FrameHeader): void {
    this.traffic.frames++;
    this.traffic.lastSeq = header.seq;
    this.traffic.lastSetId = header.setId;
    this.traffic.lastCapture_ms = Number(header.capture_ns) / 1e6;
    if (header.key) this.traffic.problem = '';
  }

  private frameOf(header: FrameHeader, decoded: DecodedPayload): ViewFrame {
    const depth_mm = new Uint16Array(this.parts.buffers.take(decoded.depth_mm.byteLength));
    depth_mm.set(decoded.depth_mm);
    const { clockError_us } = header;
    const { width, height } = this.lens;
    return {
      sensor: this.sensor,
      seq: header.seq,
      setId: header.setId,
      capture_ms: Number(header.capture_ns) / 1e6,
      captureError_ms: clockError_us === unknownClockError_us ? undefined : clockError_us / 1000,
      width,
      height,
      depth_mm,
      flow: this.flowOf(depth_mm, header.capture_ns),
      rgba: undefined,
    };
  }

  private flowOf(depth_mm: Uint16Array, capture_ns: bigint): Float32Array<ArrayBuffer> | undefined {
    const { make } = this.parts.motion;
    if (!make) return undefined;
    this.motion ??= make(this.lens);
    const flow = this.motion.take(depth_mm, capture_ns);
    if (!flow) return undefined;
    const copy = new Float32Array(this.parts.buffers.take(flow.byteLength));
    copy.set(flow);
    return copy;
  }

  private settleOrDecodeColor(frame: ViewFrame, { color }: DecodedPayload): void {
    if (color?.key && !this.colors) this.openColor();
    if (!color || !this.colors) return this.events.settled(frame.setId, frame);
    const seen = new Uint8Array(this.parts.buffers.take(color.seen.length));
    seen.set(color.seen);
    const chunk = this.chunks++;
    this.awaitsColor.set(chunk, { frame, seen });
    this.colors.decode(chunk, color.key, color.vp9);
  }

  /** Nobody waits for the picture. */
  private decodeHiddenColor({ color }: DecodedPayload): void {
    if (color?.key && !this.colors) this.openColor();
    if (color && this.colors) this.colors.decode(this.chunks++, color.key, color.vp9);
  }

  private openColor(): void {
    if (!this.parts.color) return;
    this.colors = new ColorDecoder(this.parts.color, {
      onPlanes: (chunk, planes) => this.finish(chunk, planes),
      onFailure: (sentence) => this.loseColor(sentence),
    });
  }

  private finish(chunk: number, planes: YcbcrPlanes): void {
    const waiting = this.awaitsColor.get(chunk);
    if (!waiting) return;
    this.awaitsColor.delete(chunk);
    const { frame, seen } = waiting;
    frame.rgba = new Uint8Array(this.parts.buffers.take(4 * seen.length));
    rgbaFromYcbcr(planes, seen, frame.width, frame.height, frame.rgba);
    this.parts.buffers.giveBack(seen.buffer);
    this.events.settled(frame.setId, frame);
  }

  private loseColor(sentence: string): void {
    this.traffic.problem = sentence;
    this.restart();
    this.events.keyFrameNeeded(this.sensor);
  }

  private closeColor(): void {
    this.colors?.close();
    this.colors = undefined;
    this.dropAwaited(true);
  }

  /** Frames that wait for colour are shown without it, or not at all. */
  private dropAwaited(areShown: boolean): void {
    for (const { frame, seen } of this.awaitsColor.values()) {
      this.parts.buffers.giveBack(seen.buffer);
      if (!areShown) buffersOf(frame).forEach((buffer) => this.parts.buffers.giveBack(buffer));
      this.events.settled(frame.setId, areShown ? frame : undefined);
    }
    this.awaitsColor.clear();
  }
}
