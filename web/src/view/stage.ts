// SPDX-License-Identifier: Apache-2.0
// The canvas: draws the room when something has changed, at most one picture ahead of the graphics processor, and as
// finely as the graphics processor permits. An active headset decides when to draw.
import * as THREE from 'three';
import type { RoomRoster } from '../room_roster';
import type { DecodedModel } from '../model/model_worker';
import type { ViewAngles, ViewFrame } from '../stream/protocol';
import type { DrawMode } from './draw_mode';
import { whenDrawn } from './gpu_fence';
import { QualityLadder, type QualityChoice } from './quality_ladder';
import { RoomScene } from './room_scene';
import { drawsInSoftware } from './software_drawing';
import { orientation, type ViewState } from './view_state';

export const verticalField_deg = 60;
const near_m = 0.05;
const far_m = 100;
const highestPixelRatio = 2;
const headsetHalfAngle = 1.22; // 70 degrees

export interface StageEvents {
  /** Once per screen refresh, before drawing. `frame` is set while a headset is active. */
  refresh(now_ms: number, frame: XRFrame | undefined): void;
  /** A picture is on the screen; `withFrames` when it was the first with the frames last passed to `show`. */
  drawn(withFrames: boolean): void;
  /** The browser has taken the graphics context away, as phones do when one changes the app. */
  lost(): void;
  /** It has given a new one. */
  restored(): void;
}

export class Stage {
  readonly renderer: THREE.WebGLRenderer;
  readonly camera = new THREE.PerspectiveCamera(verticalField_deg, 1, near_m, far_m);
  readonly room: RoomScene;
  readonly ladder: QualityLadder;
  pictures = 0; // drawn so far
  draw_ms = 0; // duration of the last one
  private changed = true;
  private drawing = false;
  private newFrames = false;
  private lastRefresh_ms = 0;

  /** Throws when the browser has no WebGL 2. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly events: StageEvents,
  ) {
    this.renderer = new THREE.WebGLRenderer({
      canvas,
      antialias: false,
      alpha: true,
      powerPreference: 'high-performance',
    });
    this.ladder = new QualityLadder(drawsInSoftware(this.renderer.getContext() as WebGL2RenderingContext));
    this.room = new RoomScene(this.renderer);
    new ResizeObserver(() => this.touch()).observe(canvas);
    canvas.addEventListener('webglcontextlost', () => events.lost());
    canvas.addEventListener('webglcontextrestored', () => this.restore()); // after the renderer's own listener
    this.renderer.setAnimationLoop((now_ms, frame) => this.refresh(now_ms, frame));
  }

  get quality() {
    return this.ladder.quality;
  }

  /** Something has changed: draws at the next screen refresh. */
  touch(): void {
    this.changed = true;
  }

  look(view: ViewState): void {
    this.camera.position.copy(view.position);
    this.camera.quaternion.copy(orientation(view));
    this.touch();
  }

  setBackground(background: THREE.Color): void {
    this.room.setBackground(background);
    this.touch();
  }

  choose(quality: QualityChoice): void {
    this.ladder.choose(quality);
    this.touch();
  }

  setMode(mode: DrawMode): void {
    this.room.setMode(mode);
    this.touch();
  }

  setConnected(connected: boolean): void {
    this.room.setConnected(connected);
    this.touch();
  }

  setVisible(sensor: string, visible: boolean): void {
    this.room.setVisible(sensor, visible);
    this.touch();
  }

  isVisible(sensor: number): boolean {
    return this.room.placed.get(sensor)?.wanted ?? true;
  }

  follow(roster: RoomRoster, self: number): void {
    this.room.follow(roster, self);
    this.touch();
  }

  /** The angles of this viewer's view. A headset has a cone that is wider than the view of either eye. */
  get viewAngles(): ViewAngles {
    if (this.renderer.xr.isPresenting) return { halfAngle: headsetHalfAngle, halfWidth: 0, halfHeight: 0 };
    const { fov, aspect } = this.camera;
    const halfHeight = THREE.MathUtils.degToRad(fov) / 2;
    const [top, side] = [Math.tan(halfHeight), Math.tan(halfHeight) * aspect];
    return { halfAngle: Math.atan(Math.hypot(top, side)), halfWidth: Math.atan(side), halfHeight };
  }

  clear(sensors: readonly number[]): void {
    this.room.clear(sensors);
    this.touch();
  }

  /** The hub's model of what stands still, or what has changed of it. */
  showModel(model: DecodedModel): void {
    this.room.model.take(model);
    this.touch();
  }

  /** The pixels belong to the stage until `drawn(true)`. */
  show(frames: readonly ViewFrame[]): void {
    this.room.show(frames);
    this.newFrames = true;
    this.touch();
  }

  /**
   * The room as a PNG of the canvas's size in device pixels, however coarsely it is drawn at the moment. Null where that
   * is not possible: in a headset, without a graphics context.
   */
  async snapshot(): Promise<Blob | null> {
    if (this.renderer.xr.isPresenting || this.renderer.getContext().isContextLost()) return null;
    this.render(Math.min(highestPixelRatio, window.devicePixelRatio));
    this.touch();
    return new Promise((resolve) => this.canvas.toBlob(resolve, 'image/png')); // takes the pixels before it returns
  }

  private restore(): void {
    this.room.restore();
    this.touch();
    this.events.restored();
  }

  private refresh(now_ms: number, frame: XRFrame | undefined): void {
    this.events.refresh(now_ms, frame);
    if (this.room.avatars.animate((now_ms - this.lastRefresh_ms) / 1000)) this.touch();
    this.lastRefresh_ms = now_ms;
    if (this.renderer.xr.isPresenting || (this.changed && !this.drawing)) this.draw();
  }

  private draw(): void {
    const withFrames = this.newFrames;
    const began_ms = performance.now();
    this.changed = this.newFrames = false;
    this.render(this.ladder.quality.pixelRatio * Math.min(highestPixelRatio, window.devicePixelRatio));
    if (this.drawing) return this.finish(withFrames); // a headset does not wait; the picture in progress is measured
    this.drawing = true;
    whenDrawn(this.renderer.getContext() as WebGL2RenderingContext, () => {
      this.drawing = false;
      const now_ms = performance.now();
      this.draw_ms = now_ms - began_ms;
      if (this.ladder.judge(this.draw_ms, now_ms)) this.touch();
      this.finish(withFrames);
    });
  }

  /** `ratio`: device pixels drawn for each CSS pixel. */
  private render(ratio: number): void {
    this.fit(ratio);
    const { width, height } = this.targetSize();
    this.room.avatars.hideAt(this.camera.position);
    this.room.render(this.camera, width, height);
  }

  private finish(withFrames: boolean): void {
    this.pictures++;
    this.events.drawn(withFrames);
  }

  /** Adapts canvas, camera and grids to the current size and quality. */
  private fit(ratio: number): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!this.renderer.xr.isPresenting) this.fitCanvas(width, height, ratio);
    const halfField = THREE.MathUtils.degToRad(verticalField_deg) / 2;
    const pixelsPerUnit = (this.targetSize().height || height * ratio) / (2 * Math.tan(halfField));
    this.room.setQuality(this.ladder.quality, this.camera.position, pixelsPerUnit);
  }

  private fitCanvas(width: number, height: number, ratio: number): void {
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    const size = this.renderer.getSize(new THREE.Vector2());
    if (size.x !== width || size.y !== height) this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
  }

  /** Size of the render target, device pixels: the headset's picture of both eyes, or the canvas. */
  private targetSize(): { width: number; height: number } {
    const target = this.renderer.getRenderTarget();
    if (target) return target;
    const { x: width, y: height } = this.renderer.getDrawingBufferSize(new THREE.Vector2());
    return { width, height };
  }
}
