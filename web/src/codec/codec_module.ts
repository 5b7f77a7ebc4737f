// SPDX-License-Identifier: Apache-2.0
// roomcast_codec.wasm: decodes depth and colour mask of a payload, locates its VP9 frame, and tells how what it shows moves. The exports are described
// in web/wasm/README.md, the payload in docs/spec/codec.md. Depth is u16 millimetres, 0 = no reading.

import { flowChannels, flowSize, type FlowLens } from './scene_flow';

interface CodecExports {
  memory: WebAssembly.Memory;
  __wasm_call_ctors(): void;
  decoder_create(width: number, height: number): number;
  decoder_destroy(decoder: number): void;
  decoder_input(decoder: number, length: number): number;
  decoder_decode(decoder: number, length: number): number;
  decoder_depth(decoder: number): number;
  decoder_mask(decoder: number): number;
  decoder_color_offset(decoder: number): number;
  decoder_color_length(decoder: number): number;
  decoder_color_is_key(decoder: number): number;
  decoder_error(decoder: number): number;
  decoder_error_length(decoder: number): number;
  flow_create(width: number, height: number, fx: number, fy: number, cx: number, cy: number): number;
  flow_destroy(flow: number): void;
  flow_take(flow: number, depth: number, capture_us: number): number;
}

const codeUnsupported = 2;

/** A payload that cannot be decoded. */
export class PayloadError extends Error {
  constructor(
    sentence: string,
    readonly ofLaterVersion: boolean,
  ) {
    super(sentence);
    this.name = 'PayloadError';
  }
}

/** Views into the module's memory and the payload; copy them before the next call of the module. */
export interface DecodedPayload {
  depth_mm: Uint16Array;
  flow?: Float32Array; // scene_flow.ts; absent while nothing moves
  color?: { vp9: Uint8Array; key: boolean; seen: Uint8Array }; // seen: 255 where the colour is valid
}

export class CodecModule {
  private constructor(readonly exports: CodecExports) {}

  /** Rejects with an Error when the bytes are not the module with which this page was built. */
  static async load(bytes: BufferSource): Promise<CodecModule> {
    const { instance } = await WebAssembly.instantiate(bytes);
    const exports = instance.exports as unknown as CodecExports;
    exports.__wasm_call_ctors();
    return new CodecModule(exports);
  }
}

/** One sensor's decoder. The depth grid is 16 to 4096 pixels wide and high. */
export class PayloadDecoder {
  private readonly codec: CodecExports;
  private readonly handle: number;
  private readonly flow: number;

  constructor(
    module: CodecModule,
    private readonly lens: FlowLens,
  ) {
    this.codec = module.exports;
    const { width, height, fx, fy, cx, cy } = lens;
    this.handle = this.codec.decoder_create(width, height);
    this.flow = this.codec.flow_create(width, height, fx, fy, cx, cy);
    if (this.handle === 0) throw new PayloadError(`A depth grid of ${width}x${height} cannot be decoded.`, false);
  }

  destroy(): void {
    this.codec.decoder_destroy(this.handle);
    this.codec.flow_destroy(this.flow);
  }


  /**
   * With the times at which frames were captured, also tells how what they show moves. Throws PayloadError; the decoder can
   * continue with any later frame.
   */
  decode(payload: Uint8Array, capture_ns?: bigint): DecodedPayload {
    const { codec, handle } = this;
    const input = codec.decoder_input(handle, payload.length);
    if (input === 0) throw new PayloadError('A frame is longer than any of its size can be.', false);
    new Uint8Array(codec.memory.buffer, input, payload.length).set(payload);
    const code = codec.decoder_decode(handle, payload.length);
    if (code !== 0) throw new PayloadError(this.reason(), code === codeUnsupported);
    // May grow the module's memory, which ends all views of it.
    const flow =
      capture_ns === undefined ? 0 : codec.flow_take(this.flow, codec.decoder_depth(handle), Number(capture_ns / 1000n));
    const pixels = this.lens.width * this.lens.height;
    const decoded: DecodedPayload = {
      depth_mm: new Uint16Array(codec.memory.buffer, codec.decoder_depth(handle), pixels),
    };
    if (flow !== 0) {
      const cells = flowSize(this.lens);
      decoded.flow = new Float32Array(codec.memory.buffer, flow, flowChannels * cells.width * cells.height);
    }
    const mask = codec.decoder_mask(handle);
    if (mask !== 0) {
      const start = codec.decoder_color_offset(handle);
      decoded.color = {
        vp9: payload.subarray(start, start + codec.decoder_color_length(handle)),
        key: codec.decoder_color_is_key(handle) !== 0,
        seen: new Uint8Array(codec.memory.buffer, mask, pixels),
      };
    }
    return decoded;
  }

  private reason(): string {
    const { codec, handle } = this;
    const text = new Uint8Array(codec.memory.buffer, codec.decoder_error(handle), codec.decoder_error_length(handle));
    return new TextDecoder().decode(text);
  }
}
