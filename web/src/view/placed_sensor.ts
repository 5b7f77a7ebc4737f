// SPDX-License-Identifier: Apache-2.0
// A sensor of the room as it is drawn: its pictures, the surface that shows them alone, what it remembers and its
// layers among the mixed ones, and the mark where it stands.
import * as THREE from 'three';
import { Placement, type SensorEntry } from '../gen/control_pb';
import { BlendLayer } from './blend/blend_layer';
import { BackgroundModel } from './blend/background_model';
import { sensorMark } from './room_marks';
import { sensorColor } from './sensor_color';
import { SensorPictures } from './sensor_pictures';
import { SensorSurface } from './sensor_surface';

export class PlacedSensor {
  readonly pictures: SensorPictures;
  readonly surface: SensorSurface;
  readonly memory: BackgroundModel | undefined; // undefined where surfaces cannot be mixed
  readonly layers: BlendLayer[];
  readonly mark: THREE.LineSegments;
  readonly worldFromDepth = new THREE.Matrix4();
  wanted = true; // the person has not switched it off
  chosen = true; // among those that the machine has time for
  isStale = true; // the memory has something that the layers do not show yet

  constructor(
    public entry: SensorEntry,
    mixes: boolean,
  ) {
    this.pictures = new SensorPictures(entry.calibration!.depth!);
    this.surface = new SensorSurface(this.pictures);
    this.memory = mixes ? new BackgroundModel(this.pictures) : undefined;
    this.layers = this.memory
      ? (['live', 'background'] as const).map((kind) => new BlendLayer(this.memory!, kind))
      : [];
    this.mark = sensorMark(sensorColor(entry.id));
    this.mark.matrixAutoUpdate = false;
  }

  /** True when it stands elsewhere now. */
  follow(entry: SensorEntry, connected: boolean): boolean {
    const before = this.worldFromDepth.clone();
    if (entry.moved && !this.entry.moved) this.memory?.forget();
    this.entry = entry;
    this.worldFromDepth.set(...(entry.worldFromDepth as Parameters<THREE.Matrix4['set']>));
    const live = entry.online && connected ? 1 : 0;
    this.surface.place(this.worldFromDepth, live);
    this.layers.forEach((layer) => layer.place(this.worldFromDepth, live));
    this.mark.matrix.copy(this.worldFromDepth);
    this.mark.matrixWorldNeedsUpdate = true;
    return !before.equals(this.worldFromDepth);
  }

  /** Nobody knows where it stands: it is shown beside the room, and takes no part in what others show. */
  get isApart(): boolean {
    return this.entry.placement === Placement.UNPLACED;
  }

  updateVisible(mixing: boolean): void {
    const mixed = mixing && !this.isApart;
    const drawn = this.wanted && this.chosen && this.pictures.hasPicture;
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
