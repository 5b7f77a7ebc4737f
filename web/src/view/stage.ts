// SPDX-License-Identifier: Apache-2.0
// The drawn room: canvas, camera, surfaces, avatars. Draws when something has changed, never more than one picture ahead of
// the graphics processor, and as finely as that one keeps up with.
import * as THREE from 'three';
import type { Roster, SensorEntry } from '../gen/control_pb';
import type { ViewFrame } from '../stream/protocol';
import { Avatars } from './avatars';
import { whenDrawn } from './gpu_fence';
import { QualityLadder } from './quality_ladder';
import { floorGrid, sensorMark } from './room_marks';
import { sensorColor } from './sensor_color';
import { SensorSurface, type DrawMode } from './sensor_surface';
import { orientation, type ViewState } from './view_state';

const background = new THREE.Color('#10141a');
const verticalField_deg = 60;
const near_m = 0.05;
const far_m = 100;
const highestPixelRatio = 2;

interface Placed {
  entry: SensorEntry;
  surface: SensorSurface;
  mark: THREE.LineSegments;
  wanted: boolean; // the person has not switched it off
}

export interface StageEvents {
  /** Once per screen refresh, before drawing. */
  refresh(now_ms: number): void;
  /** A picture is on the screen; `withFrames` when it was the first to show the frames last given to `show`. */
  drawn(withFrames: boolean): void;
}

export class Stage {
  readonly scene = new THREE.Scene();
  readonly camera = new THREE.PerspectiveCamera(verticalField_deg, 1, near_m, far_m);
  readonly avatars = new Avatars();
  readonly renderer: THREE.WebGLRenderer;
  readonly placed = new Map<number, Placed>();
  pictures = 0; // drawn so far
  draw_ms = 0; // how long the last one took
  private readonly ladder = new QualityLadder();
  private mode: DrawMode = 'mesh';
  private connected = true;
  private changed = true;
  private drawing = false;
  private newFrames = false;
  private lastRefresh_ms = 0;

  /** Throws when the browser has no WebGL 2. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly events: StageEvents,
  ) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: false, powerPreference: 'high-performance' });
    this.scene.background = background;
    this.scene.add(floorGrid(background), this.avatars.root);
    new ResizeObserver(() => this.touch()).observe(canvas);
    requestAnimationFrame((now) => this.refresh(now));
  }

  get quality() {
    return this.ladder.quality;
  }

  /** Something is different: draw at the next screen refresh. */
  touch(): void {
    this.changed = true;
  }

  look(view: ViewState): void {
    this.camera.position.copy(view.position);
    this.camera.quaternion.copy(orientation(view));
    this.touch();
  }

  setMode(mode: DrawMode): void {
    this.mode = mode;
    this.placed.forEach(({ surface }) => surface.setMode(mode));
    this.touch();
  }

  /** Without a connection every picture is an old one. */
  setConnected(connected: boolean): void {
    if (connected === this.connected) return;
    this.connected = connected;
    this.placed.forEach((placed) => this.replace(placed, placed.entry));
    this.touch();
  }

  setVisible(sensor: number, visible: boolean): void {
    const placed = this.placed.get(sensor);
    if (!placed) return;
    placed.wanted = visible;
    this.updateVisible(placed);
    this.touch();
  }

  isVisible(sensor: number): boolean {
    return this.placed.get(sensor)?.wanted ?? true;
  }

  follow(roster: Roster, self: number): void {
    const listed = new Map(roster.sensors.map((entry) => [entry.id, entry]));
    for (const [id, placed] of this.placed) {
      const entry = listed.get(id);
      if (entry && sameSensor(entry, placed.entry)) this.replace(placed, entry);
      else this.remove(id, placed);
    }
    for (const entry of roster.sensors) {
      if (!this.placed.has(entry.id)) this.add(entry);
    }
    this.avatars.follow(roster.viewers.filter((viewer) => viewer.id !== self));
    this.touch();
  }

  /** The pixels belong to the stage until `drawn(true)`. */
  show(frames: readonly ViewFrame[]): void {
    for (const frame of frames) {
      const placed = this.placed.get(frame.sensor);
      if (!placed || placed.surface.width !== frame.width || placed.surface.height !== frame.height) continue;
      placed.surface.show(frame);
      placed.surface.upload(this.renderer);
      this.updateVisible(placed);
    }
    this.newFrames = true;
    this.touch();
  }

  private add(entry: SensorEntry): void {
    const surface = new SensorSurface(entry);
    const mark = sensorMark(sensorColor(entry.id));
    mark.matrixAutoUpdate = false;
    const placed = { entry, surface, mark, wanted: true };
    surface.setMode(this.mode);
    this.scene.add(surface.root, mark);
    this.placed.set(entry.id, placed);
    this.replace(placed, entry);
  }

  private replace(placed: Placed, entry: SensorEntry): void {
    placed.entry = entry;
    placed.surface.follow(entry, this.connected);
    placed.mark.matrix.copy(placed.surface.root.matrix);
    placed.mark.matrixWorldNeedsUpdate = true;
  }

  private remove(id: number, { surface, mark }: Placed): void {
    this.placed.delete(id);
    this.scene.remove(surface.root, mark);
    surface.dispose();
    mark.geometry.dispose();
    (mark.material as THREE.Material).dispose();
  }

  private updateVisible({ surface, mark, wanted }: Placed): void {
    surface.root.visible = wanted && surface.hasPicture;
    mark.visible = wanted;
  }

  private refresh(now_ms: number): void {
    requestAnimationFrame((now) => this.refresh(now));
    this.events.refresh(now_ms);
    if (this.avatars.animate((now_ms - this.lastRefresh_ms) / 1000)) this.touch();
    this.lastRefresh_ms = now_ms;
    if (this.changed && !this.drawing) this.draw();
  }

  private draw(): void {
    const withFrames = this.newFrames;
    const began_ms = performance.now();
    this.changed = this.newFrames = false;
    this.drawing = true;
    this.fit();
    this.renderer.render(this.scene, this.camera);
    whenDrawn(this.renderer.getContext() as WebGL2RenderingContext, () => {
      this.drawing = false;
      this.pictures++;
      const now_ms = performance.now();
      this.draw_ms = now_ms - began_ms;
      if (this.ladder.judge(this.draw_ms, now_ms)) this.touch();
      this.events.drawn(withFrames);
    });
  }

  /** Canvas, camera and grids to the present size and quality. */
  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const { step, pixelRatio } = this.ladder.quality;
    const ratio = pixelRatio * Math.min(highestPixelRatio, window.devicePixelRatio);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    const size = this.renderer.getSize(new THREE.Vector2());
    if (size.x !== width || size.y !== height) this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    const halfField = THREE.MathUtils.degToRad(verticalField_deg) / 2;
    const pixelsPerUnit = (height * ratio) / (2 * Math.tan(halfField));
    for (const { surface } of this.placed.values()) {
      surface.setStep(step);
      surface.setPixelsPerUnit(pixelsPerUnit);
    }
  }
}

/** A hub that was started again may give ids to sensors in another order; a sensor may come back with another camera. */
function sameSensor(a: SensorEntry, b: SensorEntry): boolean {
  const [p, q] = [a.calibration!.depth!, b.calibration!.depth!];
  const fields = ['width', 'height', 'fx', 'fy', 'cx', 'cy', 'k1', 'k2', 'k3', 'p1', 'p2'] as const;
  return a.name === b.name && fields.every((field) => p[field] === q[field]);
}
