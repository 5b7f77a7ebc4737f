// SPDX-License-Identifier: Apache-2.0
// How what sensors show moves, while the page draws it. The module is loaded when the page first asks, which is after the
// first picture (wanted_motion.ts). Where it cannot be loaded, the room is drawn without motion.
import type { FlowLens } from '../codec/scene_flow';

/** One sensor's motion (codec/scene_flow_module.ts). */
export interface SensorMotion {
  take(depth_mm: Uint16Array, capture_ns: bigint): Float32Array | undefined;
  destroy(): void;
}

type OfLens = (lens: FlowLens) => SensorMotion;

async function loadModule(): Promise<OfLens> {
  const { loadSceneFlow, SceneFlow } = await import('../codec/load_scene_flow');
  const module = await loadSceneFlow();
  return (lens) => new SceneFlow(module, lens);
}

export class MotionFinder {
  private isWanted = false;
  private isAsked = false;
  private ofLens: OfLens | undefined;

  constructor(private readonly load: () => Promise<OfLens> = loadModule) {}

  want(isWanted: boolean): void {
    this.isWanted = isWanted;
    if (!isWanted || this.isAsked) return;
    this.isAsked = true;
    this.load().then(
      (ofLens) => (this.ofLens = ofLens),
      () => undefined, // the room is drawn without motion
    );
  }

  /** Makes a sensor's motion; undefined while nobody wants it, or it is not loaded. */
  get make(): OfLens | undefined {
    return this.isWanted ? this.ofLens : undefined;
  }
}
