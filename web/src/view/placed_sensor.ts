// SPDX-License-Identifier: Apache-2.0
// A sensor in the drawn room: its pictures, its unblended surface, its background model with the blended layers, and
// the mark at its position.
import * as THREE from 'three';
import type { RoomSensor } from '../room_roster';
import { isPlaced } from '../sensor_pose';
import { BlendLayer } from './blend/blend_layer';
import { BackgroundModel } from './blend/background_model';
import { sensorMark } from './room_marks';
import { sensorColor } from './sensor_color';
import { SensorPictures } from './sensor_pictures';
import { SensorSurface } from './sensor_surface';

/** Sensors' surfaces are blended, drawn each for itself, or not drawn. */
export type SurfacesDrawn = 'mixed' | 'apart' | 'hidden';

export class PlacedSensor {
  readonly pictures: SensorPictures;
  readonly surface: SensorSurface;
  readonly memory: BackgroundModel | undefined; // undefined where surfaces cannot be blended
  readonly layers: BlendLayer[];
  readonly mark: THREE.LineSegments;
  readonly worldFromDepth = new THREE.Matrix4();
  wanted = true; // not switched off by the user
  chosen = true; // within the number of sensors that the machine can draw
  isLate = false; // its newest picture is old beside those of the others
  capture_ms: number | undefined; // room time of its newest picture; undefined before it, and while it is paused
  isStale = true; // the layers do not show the memory's newest data yet

  constructor(
    public entry: RoomSensor,
    mixes: boolean,
  ) {
    this.pictures = new SensorPictures(entry.calibration!.depth!);
    this.surface = new SensorSurface(this.pictures);
    this.memory = mixes ? new BackgroundModel(this.pictures) : undefined;
    this.layers = this.memory
      ? (['live', 'backs', 'background'] as const).map((kind) => new BlendLayer(this.memory!, kind))
      : [];
    this.mark = sensorMark(sensorColor(entry.id));
    this.mark.matrixAutoUpdate = false;
  }

  /** True when its pose has changed. */
  follow(entry: RoomSensor, connected: boolean): boolean {
    const before = this.worldFromDepth.clone();
    if (entry.pose.state === 'moved' && this.entry.pose.state !== 'moved') this.memory?.forget();
    this.entry = entry;
    this.worldFromDepth.set(...(entry.pose.worldFromDepth as Parameters<THREE.Matrix4['set']>));
    const live = entry.online && connected ? 1 : 0;
    this.surface.place(this.worldFromDepth, live);
    this.layers.forEach((layer) => layer.place(this.worldFromDepth, live));
    this.mark.matrix.copy(this.worldFromDepth);
    this.mark.matrixWorldNeedsUpdate = true;
    return !before.equals(this.worldFromDepth);
  }

  /** Its pose is unknown: the sensor is drawn next to the room and does not affect other sensors' surfaces. */
  get isApart(): boolean {
    return !isPlaced(this.entry.pose);
  }

  updateVisible(how: SurfacesDrawn): void {
    const mixed = how === 'mixed' && !this.isApart;
    const drawn = this.wanted && this.chosen && this.pictures.hasPicture && how !== 'hidden';
    this.surface.root.visible = drawn && !mixed;
    this.layers.forEach((layer) => layer.setVisible(drawn && mixed));
    this.mark.visible = this.wanted;
  }

  setStep(step: number): void {
    this.surface.setStep(step);
    if (this.memory?.setStep(step)) this.isStale = true;
  }

  dispose(): void {
    this.pictures.dispose();
    this.surface.dispose();
    this.memory?.dispose();
    this.mark.geometry.dispose();
    (this.mark.material as THREE.Material).dispose();
  }
}
