// SPDX-License-Identifier: Apache-2.0
// roomcast_flow.wasm: how what one sensor shows moves. The exports are described in web/wasm/README.md.
import { flowChannels, flowSize, type FlowLens } from './scene_flow';

interface FlowExports {
  memory: WebAssembly.Memory;
  __wasm_call_ctors(): void;
  flow_create(width: number, height: number, fx: number, fy: number, cx: number, cy: number): number;
  flow_destroy(flow: number): void;
  flow_depth(flow: number): number;
  flow_take(flow: number, capture_us: number): number;
}

export class SceneFlowModule {
  private constructor(readonly exports: FlowExports) {}

  /** Rejects with an Error when the bytes are not the module with which this page was built. */
  static async load(bytes: BufferSource): Promise<SceneFlowModule> {
    const { instance } = await WebAssembly.instantiate(bytes);
    const exports = instance.exports as unknown as FlowExports;
    exports.__wasm_call_ctors();
    return new SceneFlowModule(exports);
  }
}

/** One sensor's motion. Its pictures are at most 4096 pixels wide and high; in larger ones nothing moves. */
export class SceneFlow {
  private readonly module: FlowExports;
  private readonly handle: number;

  constructor(
    module: SceneFlowModule,
    private readonly lens: FlowLens,
  ) {
    this.module = module.exports;
    const { width, height, fx, fy, cx, cy } = lens;
    this.handle = this.module.flow_create(width, height, fx, fy, cx, cy);
  }

  destroy(): void {
    this.module.flow_destroy(this.handle);
  }

  /**
   * Takes the sensor's next picture, millimetres, and its time. Returns the motion in it (scene_flow.ts), or undefined
   * while nothing moves: a view into the module's memory; copy it before the next call of the module.
   */
  take(depth_mm: Uint16Array, capture_ns: bigint): Float32Array | undefined {
    const { module, handle, lens } = this;
    if (handle === 0) return undefined;
    new Uint16Array(module.memory.buffer, module.flow_depth(handle), lens.width * lens.height).set(depth_mm);
    const field = module.flow_take(handle, Number(capture_ns / 1000n));
    if (field === 0) return undefined;
    const cells = flowSize(lens);
    return new Float32Array(module.memory.buffer, field, flowChannels * cells.width * cells.height);
  }
}
