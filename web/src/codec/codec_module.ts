// SPDX-License-Identifier: Apache-2.0
// roomcast_codec.wasm: decodes depth and colour mask of a payload and locates its VP9 frame. The exports are described
// in web/wasm/README.md, the payload in docs/spec/codec.md. Depth is u16 millimetres, 0 = no reading.

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

/** One sensor's decoder. `width` x `height` of the depth grid, 16 to 4096 each. */
export class PayloadDecoder {
  private readonly codec: CodecExports;
  private readonly handle: number;

  constructor(
    module: CodecModule,
    private readonly width: number,
    private readonly height: number,
  ) {
    this.codec = module.exports;
    this.handle = this.codec.decoder_create(width, height);
    if (this.handle === 0) throw new PayloadError(`A depth grid of ${width}x${height} cannot be decoded.`, false);
  }

  destroy(): void {
    this.codec.decoder_destroy(this.handle);
  }

  /** Throws PayloadError; the decoder can continue with any later frame. */
  decode(payload: Uint8Array): DecodedPayload {
    const { codec, handle } = this;
    const input = codec.decoder_input(handle, payload.length);
    if (input === 0) throw new PayloadError('A frame is longer than any of its size can be.', false);
    new Uint8Array(codec.memory.buffer, input, payload.length).set(payload);
    const code = codec.decoder_decode(handle, payload.length);
    if (code !== 0) throw new PayloadError(this.reason(), code === codeUnsupported);
    const pixels = this.width * this.height;
    const decoded: DecodedPayload = {
      depth_mm: new Uint16Array(codec.memory.buffer, codec.decoder_depth(handle), pixels),
    };
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
