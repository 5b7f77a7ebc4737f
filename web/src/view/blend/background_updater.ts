// SPDX-License-Identifier: Apache-2.0
// Updates the sensors' background models on the graphics processor: `remember` adds a picture, `refresh` makes the
// drawable surfaces, `carve` removes background surfaces that the other sensors see through.
import * as THREE from 'three';
import type { SensorPictures } from '../sensor_pictures';
import { edgeShader, qualityShader, repairShader, smoothShader } from './clean_shader';
import { FullScreenPass, withoutHeadset } from './full_screen_pass';
import { backgroundShader, carveShader, rememberShader } from './memory_shader';
import { motionShader } from './motion_shader';
import type { BackgroundModel } from './background_model';

/** Another sensor whose view tests this sensor's background. */
export interface OtherSensor {
  pictures: SensorPictures;
  otherFromDepth: THREE.Matrix4;
}

function uniforms<Name extends string>(...names: Name[]): Record<Name, THREE.IUniform> {
  return Object.fromEntries(names.map((name) => [name, { value: null }])) as Record<Name, THREE.IUniform>;
}

export class BackgroundUpdater {
  private readonly rememberIn = uniforms('uDepth', 'uColor', 'uReadings', 'uMeanColor');
  private readonly repairIn = uniforms('uDepth_m', 'uStep');
  private readonly smoothIn = uniforms('uDepth_m', 'uCarved');
  private readonly edgeIn = uniforms('uDepth_m', 'uStep');
  private readonly qualityIn = uniforms('uDepth_m', 'uInRow', 'uRays', 'uStep');
  private readonly backgroundIn = uniforms('uDepth', 'uReadings', 'uLive_m', 'uCarved', 'uStep');
  private readonly motionIn = uniforms('uFlow', 'uLive_m', 'uBehind_m', 'uStep');
  private readonly carveIn = {
    ...uniforms('uReadings', 'uRays', 'uOtherDepth', 'uOtherFromDepth', 'uStep'),
    uOtherFocalCenter: { value: new THREE.Vector4() },
    uOtherRadial: { value: new THREE.Vector3() },
    uOtherTangential: { value: new THREE.Vector2() },
  };
  private readonly passes = {
    remember: new FullScreenPass(rememberShader, this.rememberIn),
    repair: new FullScreenPass(repairShader, this.repairIn),
    smooth: new FullScreenPass(smoothShader, this.smoothIn),
    edges: new FullScreenPass(edgeShader, this.edgeIn),
    quality: new FullScreenPass(qualityShader, this.qualityIn),
    background: new FullScreenPass(backgroundShader, this.backgroundIn),
    motion: new FullScreenPass(motionShader, this.motionIn),
    carve: new FullScreenPass(carveShader, this.carveIn, {
      blending: THREE.CustomBlending,
      blendEquation: THREE.MaxEquation,
      blendSrc: THREE.OneFactor,
      blendDst: THREE.OneFactor,
    }),
  };

  constructor(private readonly renderer: THREE.WebGLRenderer) {}

  /** Adds the sensor's new picture. Call it for every picture, drawn or not. */
  remember(memory: BackgroundModel): void {
    const { renderer, rememberIn } = this;
    withoutHeadset(renderer, () => {
      if (memory.isBlank) this.clear(memory.current.target);
      memory.isBlank = false;
      rememberIn.uDepth.value = memory.sensor.depth;
      rememberIn.uColor.value = memory.sensor.color;
      rememberIn.uReadings.value = memory.current.readings;
      rememberIn.uMeanColor.value = memory.current.meanColor;
      this.passes.remember.run(renderer, memory.spare.target);
    });
    memory.swap();
    memory.pictures++;
  }

  /** Prepares the surfaces for drawing. */
  refresh(memory: BackgroundModel): void {
    const { renderer, passes } = this;
    const { grids, current, sensor } = memory;
    for (const into of [this.repairIn, this.edgeIn, this.qualityIn, this.backgroundIn]) into.uStep.value = grids.step;
    this.repairIn.uDepth_m.value = current.newest;
    this.smoothIn.uDepth_m.value = grids.repaired.texture;
    this.smoothIn.uCarved.value = grids.carvedLive.texture;
    this.edgeIn.uDepth_m.value = this.qualityIn.uDepth_m.value = grids.live.texture;
    this.qualityIn.uInRow.value = grids.inRow.texture;
    this.qualityIn.uRays.value = sensor.rays;
    this.backgroundIn.uDepth.value = sensor.depth;
    this.backgroundIn.uReadings.value = current.readings;
    this.backgroundIn.uLive_m.value = grids.live.texture;
    this.backgroundIn.uCarved.value = grids.carved.texture;
    withoutHeadset(renderer, () => {
      if (!grids.isCarved) this.clear(grids.carved);
      grids.isCarved = true;
      passes.repair.run(renderer, grids.repaired);
      passes.smooth.run(renderer, grids.live);
      passes.edges.run(renderer, grids.inRow);
      passes.quality.run(renderer, grids.quality);
      passes.background.run(renderer, grids.background);
      if (sensor.moves) this.findMotion(memory);
    });
    memory.moves = sensor.moves;
  }

  private findMotion({ grids, sensor }: BackgroundModel): void {
    const { motionIn } = this;
    motionIn.uFlow.value = sensor.flow;
    motionIn.uLive_m.value = grids.live.texture;
    motionIn.uBehind_m.value = grids.background.texture;
    motionIn.uStep.value = grids.step;
    this.passes.motion.run(this.renderer, grids.motion);
  }

  /** Removes background that other sensors see through, until the next call. */
  carve(memory: BackgroundModel, others: readonly OtherSensor[]): void {
    this.carveInto(memory.grids.carved, memory.current.readings, memory, others);
    memory.grids.isCarved = true;
  }

  /** Removes what is live and other sensors see through, until the next call. Call it before each refresh. */
  carveLive(memory: BackgroundModel, others: readonly OtherSensor[]): void {
    const { grids, current } = memory;
    if (others.length === 0 && grids.isLiveCarved === false) return;
    this.carveInto(grids.carvedLive, current.newest, memory, others);
    grids.isLiveCarved = others.length > 0;
  }

  /** `depth_m`: in its first channel. */
  private carveInto(
    carved: THREE.WebGLRenderTarget,
    depth_m: THREE.Texture,
    { grids, sensor }: BackgroundModel,
    others: readonly OtherSensor[],
  ): void {
    const { renderer, carveIn } = this;
    carveIn.uReadings.value = depth_m;
    carveIn.uRays.value = sensor.rays;
    carveIn.uStep.value = grids.step;
    withoutHeadset(renderer, () => {
      this.clear(carved);
      for (const { pictures, otherFromDepth } of others) {
        const { fx, fy, cx, cy, k1, k2, k3, p1, p2 } = pictures.lens;
        carveIn.uOtherDepth.value = pictures.depth;
        carveIn.uOtherFromDepth.value = otherFromDepth;
        carveIn.uOtherFocalCenter.value.set(fx, fy, cx, cy);
        carveIn.uOtherRadial.value.set(k1, k2, k3);
        carveIn.uOtherTangential.value.set(p1, p2);
        this.passes.carve.run(renderer, carved);
      }
    });
  }

  private clear(target: THREE.WebGLRenderTarget): void {
    const { renderer } = this;
    const color = renderer.getClearColor(new THREE.Color());
    const alpha = renderer.getClearAlpha();
    renderer.setRenderTarget(target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear(true, false, false);
    renderer.setClearColor(color, alpha);
  }
}
