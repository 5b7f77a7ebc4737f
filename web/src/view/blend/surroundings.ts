// SPDX-License-Identifier: Apache-2.0
// Colours for pixels that no sensor sees: the picture at half its size, with every gap filled from coarser and coarser
// levels (push-pull, Gortler et al. 1996).
import * as THREE from 'three';
import { growShader, shrinkShader } from './blend_shader';
import { FullScreenPass, withoutHeadset } from './full_screen_pass';

const mostLevels = 10; // a pixel of the coarsest level covers 1024 pixels

function levelOf(width: number, height: number): THREE.WebGLRenderTarget {
  const level = new THREE.WebGLRenderTarget(width, height, { type: THREE.HalfFloatType, depthBuffer: false });
  level.texture.minFilter = level.texture.magFilter = THREE.LinearFilter;
  return level;
}

interface Level {
  shrunk: THREE.WebGLRenderTarget;
  grown: THREE.WebGLRenderTarget;
}

export class Surroundings {
  private levels: Level[] = [];
  private readonly shrinkIn = {
    uFiner: { value: null as THREE.Texture | null },
    uDepth: { value: null as THREE.Texture | null },
    uFromPicture: { value: true },
    uMetresFromDepth: { value: new THREE.Vector2() },
  };
  private readonly growIn = {
    uLevel: { value: null as THREE.Texture | null },
    uCoarser: { value: null as THREE.Texture | null },
  };
  private readonly shrink = new FullScreenPass(shrinkShader, this.shrinkIn);
  private readonly grow = new FullScreenPass(growShader, this.growIn);

  get texture(): THREE.Texture {
    return this.levels[0]!.grown.texture;
  }

  setSize(width: number, height: number): void {
    this.levels.forEach(({ shrunk, grown }) => [shrunk, grown].forEach((level) => level.dispose()));
    this.levels = [];
    while (this.levels.length < mostLevels && Math.max(width, height) > 1) {
      width = Math.ceil(width / 2);
      height = Math.ceil(height / 2);
      this.levels.push({ shrunk: levelOf(width, height), grown: levelOf(width, height) });
    }
  }

  /** `metresFromDepth`: metres = y / (x - depth). */
  find(renderer: THREE.WebGLRenderer, picture: THREE.WebGLRenderTarget, metresFromDepth: THREE.Vector2): void {
    const { shrinkIn, growIn, levels } = this;
    shrinkIn.uDepth.value = picture.depthTexture;
    shrinkIn.uMetresFromDepth.value = metresFromDepth;
    withoutHeadset(renderer, () => {
      levels.forEach(({ shrunk }, i) => {
        shrinkIn.uFromPicture.value = i === 0;
        shrinkIn.uFiner.value = i === 0 ? picture.texture : levels[i - 1]!.shrunk.texture;
        this.shrink.run(renderer, shrunk);
      });
      for (let i = levels.length - 1; i >= 0; i--) {
        growIn.uLevel.value = levels[i]!.shrunk.texture;
        growIn.uCoarser.value = i + 1 < levels.length ? levels[i + 1]!.grown.texture : levels[i]!.shrunk.texture;
        this.grow.run(renderer, levels[i]!.grown);
      }
    });
  }
}
