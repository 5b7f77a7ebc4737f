// SPDX-License-Identifier: Apache-2.0
// The drawn scene: the sensors' surfaces, blended or separate, the floor's grid, the other viewers. Follows the roster
// and receives pictures; `render` draws the view of a camera.
import * as THREE from 'three';
import type { RoomRoster, RoomSensor } from '../room_roster';
import type { ViewFrame } from '../stream/protocol';
import { Avatars } from './avatars';
import { bestSensors } from './best_sensors';
import { BackgroundUpdater } from './blend/background_updater';
import { ModelLayer } from './blend/model_layer';
import { canBlend, RoomBlend } from './blend/room_blend';
import type { Drawing, DrawMode } from './draw_mode';
import { lateSensors } from './late_sensors';
import { PlacedSensor, type SurfacesDrawn } from './placed_sensor';
import type { Quality } from './quality_ladder';
import { floorGrid } from './room_marks';
import { aheadOf_s, shownInstant_ms } from './shown_instant';

const carveEvery = 8; // pictures of a sensor
export const darkBackground = new THREE.Color('#181a1e'); // as in room_renderer.h
export const lightBackground = new THREE.Color('#e9edf2');

export class RoomScene {
  readonly scene = new THREE.Scene();
  readonly avatars = new Avatars();
  readonly placed = new Map<number, PlacedSensor>();
  readonly model = new ModelLayer(); // what stands still, as the hub knows it
  private readonly hidden = new Set<string>(); // names of sensors that the user has switched off
  readonly mixes: boolean; // whether this browser can blend surfaces
  private readonly keeper: BackgroundUpdater | undefined;
  private readonly blend: RoomBlend | undefined;
  private background = darkBackground;
  private grid = floorGrid(darkBackground);
  private mode: DrawMode = 'mesh';
  private wishesBlend = false; // also where this browser cannot
  private mayMix = true; // the machine is fast enough for blending
  private connected = true;
  private passthrough = false;

  constructor(private readonly renderer: THREE.WebGLRenderer) {
    this.mixes = canBlend(renderer);
    this.keeper = this.mixes ? new BackgroundUpdater(renderer) : undefined;
    this.blend = this.mixes ? new RoomBlend(renderer, this.model) : undefined;
    this.scene.background = darkBackground;
    this.scene.add(this.grid, this.avatars.root);
    if (this.blend) this.scene.add(this.blend.picture);
  }

  get drawMode(): DrawMode {
    return this.mode;
  }

  /** `blend` and `still` become `mesh` where this browser cannot blend. */
  setMode(mode: DrawMode): void {
    this.wishesBlend = mode === 'blend';
    this.mode = (mode === 'blend' || mode === 'still') && !this.mixes ? 'mesh' : mode;
    this.applyModeToAll();
  }

  /** True while surfaces are blended. */
  get isMixing(): boolean {
    return this.mode === 'still' || (this.mode === 'blend' && this.mayMix);
  }

  /** How the sensors' surfaces are drawn. */
  get surfaces(): SurfacesDrawn {
    if (this.mode === 'still') return 'hidden';
    return this.isMixing ? 'mixed' : 'apart';
  }

  /** Whether the model fills what separate surfaces leave empty: where the blend was chosen, and is not possible. */
  private get fillsBehind(): boolean {
    return this.wishesBlend && !this.isMixing && !this.model.isEmpty;
  }

  /** How the room is drawn now: the sensors that are, and those that would be if the machine were faster. */
  get drawing(): Drawing {
    const wanted = [...this.placed.values()].filter((placed) => placed.wanted && placed.pictures.hasPicture);
    const shown = wanted.filter(({ chosen }) => chosen).length;
    return { mode: this.mode, mixes: this.isMixing, shown, wanted: wanted.length };
  }

  private applyModeToAll(): void {
    this.placed.forEach((placed) => this.applyMode(placed));
    if (this.blend) this.blend.picture.visible = this.isMixing;
  }

  setBackground(background: THREE.Color): void {
    this.scene.remove(this.grid);
    this.grid.geometry.dispose();
    (this.grid.material as THREE.Material).dispose();
    this.grid = floorGrid(background);
    this.background = background;
    this.scene.background = this.passthrough ? null : background;
    this.scene.add(this.grid);
  }

  get isPassthrough(): boolean {
    return this.passthrough;
  }

  /** With passthrough, pixels that no sensor sees stay empty and show the viewer's own room. */
  setPassthrough(passthrough: boolean): void {
    this.passthrough = passthrough;
    this.scene.background = passthrough ? null : this.background;
    this.blend?.setFill(!passthrough);
  }

  /** Without a connection every picture counts as old. */
  setConnected(connected: boolean): void {
    this.connected = connected;
    this.placed.forEach((placed) => placed.follow(placed.entry, connected));
  }

  /** By its name, also for a sensor that comes later. */
  setVisible(sensor: string, visible: boolean): void {
    if (visible) this.hidden.delete(sensor);
    else this.hidden.add(sensor);
    for (const placed of this.placed.values()) {
      placed.wanted = !this.hidden.has(placed.entry.name);
      this.applyMode(placed);
    }
  }

  follow(roster: RoomRoster, self: number): void {
    const listed = new Map(roster.sensors.map((entry) => [entry.id, entry]));
    for (const [id, placed] of this.placed) {
      const entry = listed.get(id);
      if (entry && sameSensor(entry, placed.entry)) {
        placed.follow(entry, this.connected);
        this.applyMode(placed);
      } else this.remove(id, placed);
    }
    for (const entry of roster.sensors) {
      if (!this.placed.has(entry.id)) this.add(entry);
    }
    this.avatars.follow(roster.viewers.filter((viewer) => viewer.id !== self));
  }

  /** The graphics context is new: what it held is gone, and each sensor is drawn again from its next picture on. */
  restore(): void {
    for (const [id, placed] of [...this.placed]) {
      this.remove(id, placed);
      this.add(placed.entry);
    }
  }

  /** The pixels are read until the next picture has been drawn. */
  show(frames: readonly ViewFrame[]): void {
    for (const frame of frames) {
      const placed = this.placed.get(frame.sensor);
      const lens = placed?.pictures.lens;
      if (!placed || lens?.width !== frame.width || lens.height !== frame.height) continue;
      placed.pictures.show(frame, this.renderer);
      if (placed.memory && this.isMixing && !placed.isApart) this.keeper!.remember(placed.memory);
      placed.isStale = true;
      placed.capture_ms = frame.capture_ms;
      this.applyMode(placed);
    }
    this.markLate();
  }

  private markLate(): void {
    const late = lateSensors([...this.placed.values()]);
    for (const placed of this.placed.values()) {
      if (late.has(placed) || placed.isLate) placed.isStale = true;
      placed.isLate = late.has(placed);
    }
  }

  /** What moves would stay where it was: of these sensors, only the background that they have seen is drawn. */
  clear(sensors: readonly number[]): void {
    for (const sensor of sensors) {
      const placed = this.placed.get(sensor);
      if (!placed?.pictures.hasPicture) continue;
      placed.pictures.clear(this.renderer);
      placed.capture_ms = undefined;
    }
  }

  /** Sets the detail and the drawn sensors: those that are most useful from `eye`. */
  setQuality({ step, sensors, mixes }: Quality, eye: THREE.Vector3, pixelsPerUnit: number): void {
    if (mixes !== this.mayMix) {
      this.mayMix = mixes;
      this.applyModeToAll();
    }
    const poses = new Map([...this.placed].map(([id, { worldFromDepth }]) => [id, worldFromDepth]));
    const best = bestSensors(poses, eye, sensors);
    for (const [id, placed] of this.placed) {
      placed.setStep(step);
      placed.surface.setPixelsPerUnit(pixelsPerUnit);
      if (placed.chosen === best.has(id)) continue;
      placed.chosen = best.has(id);
      this.applyMode(placed);
    }
  }

  /** Draws into the renderer's target, `width` x `height` device pixels. */
  render(camera: THREE.PerspectiveCamera, width: number, height: number): void {
    const seen = [...this.placed.values()].some(({ pictures, isApart }) => pictures.hasPicture && !isApart);
    const mixesSomething = this.isMixing && ((seen && this.mode !== 'still') || !this.model.isEmpty);
    const filled = mixesSomething || this.fillsBehind;
    this.grid.visible = !this.passthrough && !filled;
    if (this.isMixing) {
      this.refreshMemories();
      this.bringToOneInstant();
      this.blend!.mix(camera, width, height);
    }
    this.renderer.render(this.scene, camera);
    if (this.fillsBehind) this.renderBehind(this.model.scene, camera);
  }

  /** Adds to the picture what is behind all that it shows. */
  private renderBehind(scene: THREE.Scene, camera: THREE.PerspectiveCamera): void {
    const { autoClear } = this.renderer;
    this.renderer.autoClear = false;
    this.renderer.render(scene, camera);
    this.renderer.autoClear = autoClear;
  }

  private refreshMemories(): void {
    for (const placed of this.placed.values()) {
      const { memory, layers } = placed;
      if (!memory || placed.isApart || !placed.isStale || memory.pictures === 0) continue;
      placed.isStale = false;
      if (memory.pictures % carveEvery === 0) this.keeper!.carve(memory, this.othersOf(placed));
      this.keeper!.carveLive(memory, placed.isLate ? this.othersOf(placed).filter(({ isLate }) => !isLate) : []);
      this.keeper!.refresh(memory);
      layers.forEach((layer) => layer.refresh());
    }
  }

  private bringToOneInstant(): void {
    const together = [...this.placed.values()].filter(({ isApart }) => !isApart);
    const instant_ms = shownInstant_ms(together.flatMap(({ capture_ms }) => capture_ms ?? []));
    for (const { layers, capture_ms } of together) {
      layers.forEach((layer) => layer.setAhead(aheadOf_s(capture_ms, instant_ms)));
    }
  }

  private othersOf(placed: PlacedSensor) {
    const others = [...this.placed.values()].filter(
      (other) => other !== placed && other.pictures.hasPicture && !other.isApart,
    );
    return others.map(({ pictures, worldFromDepth, isLate }) => ({
      pictures,
      isLate,
      otherFromDepth: worldFromDepth.clone().invert().multiply(placed.worldFromDepth),
    }));
  }

  private add(entry: RoomSensor): void {
    const placed = new PlacedSensor(entry, this.mixes);
    placed.wanted = !this.hidden.has(entry.name);
    this.scene.add(placed.surface.root, placed.mark);
    placed.layers.forEach((layer) => this.blend!.add(layer));
    this.placed.set(entry.id, placed);
    placed.follow(entry, this.connected);
    this.applyMode(placed);
  }

  private remove(id: number, placed: PlacedSensor): void {
    this.placed.delete(id);
    this.scene.remove(placed.surface.root, placed.mark);
    placed.layers.forEach((layer) => this.blend!.remove(layer));
    placed.dispose();
  }

  private applyMode(placed: PlacedSensor): void {
    placed.surface.setKind(this.mode === 'points' ? 'points' : 'mesh');
    placed.updateVisible(this.surfaces);
  }
}

/** After a restart a hub may assign ids to sensors in another order, and a sensor may come back with another camera. */
function sameSensor(a: RoomSensor, b: RoomSensor): boolean {
  const [p, q] = [a.calibration!.depth!, b.calibration!.depth!];
  const fields = ['width', 'height', 'fx', 'fy', 'cx', 'cy', 'k1', 'k2', 'k3', 'p1', 'p2'] as const;
  return a.name === b.name && fields.every((field) => p[field] === q[field]);
}
