// SPDX-License-Identifier: Apache-2.0
// A beam from the wearer's hand to the surface at which it points: shown to the others while the grip is held, and for
// measuring, where the trigger sets two points. Loaded when a headset is put on.
import * as THREE from 'three';
import { MarkKind } from '../gen/control_pb';
import { drawingOf, inMetres } from '../marks/mark_scene';
import type { NewMark, PlainBeam } from '../stream/protocol';
import { disposeTree } from '../view/dispose_tree';
import { IdPass } from '../view/id_pass';
import { beamOf, shine } from '../view/pointer_beam';
import type { Stage } from '../view/stage';

const farthest_m = 8; // where there is nothing to meet
const interval_ms = 50; // poses are sent no more often
const restPerPick = 3; // a slow machine spends no more than a quarter of its time on this

export interface HandLaserParts {
  stage: Stage;
  color(): number; // this viewer's own, as the others see it
  mayLeave(): boolean;
  /** For everybody. */
  leave(mark: NewMark): void;
}

export class HandLaser {
  readonly root = new THREE.Group();
  private measures = false;
  private beam: PlainBeam | undefined;
  private drawn: THREE.Group | undefined;
  private points: THREE.Vector3[] = []; // up to two
  private draft: THREE.Object3D | undefined;
  private next_ms = 0;

  constructor(private readonly parts: HandLaserParts) {}

  get isMeasuring(): boolean {
    return this.measures;
  }

  /** How far the two points are apart; empty before there are two. */
  get distance(): string {
    const [first, last] = this.points;
    return first && last ? inMetres(first.distanceTo(last)) : '';
  }

  get mayBeLeft(): boolean {
    return this.points.length === 2 && this.parts.mayLeave();
  }

  measure(isOn: boolean): void {
    this.measures = isOn;
    this.forgetPoints();
  }

  /** Once per picture, while a hand is to point: from where, and along which direction, one metre long. */
  update(now_ms: number, ray: readonly [THREE.Vector3, THREE.Vector3] | undefined): PlainBeam | undefined {
    if (!ray) this.beam = undefined;
    else if (!this.beam || now_ms >= this.next_ms) {
      const began_ms = performance.now();
      const [from, ahead] = ray;
      const to = new IdPass(this.parts.stage).pointAlong(from, ahead) ?? ahead.clone().multiplyScalar(farthest_m).add(from);
      this.beam = { from: { x: from.x, y: from.y, z: from.z }, to: { x: to.x, y: to.y, z: to.z } };
      this.next_ms = now_ms + Math.max(interval_ms, restPerPick * (performance.now() - began_ms));
    }
    this.show();
    return this.beam;
  }

  /** The trigger. False: it is not for measuring. */
  press(): boolean {
    if (!this.measures) return false;
    if (this.points.length === 2) this.forgetPoints();
    const to = this.beam?.to;
    if (to) this.points.push(new THREE.Vector3(to.x, to.y, to.z));
    this.drawDraft();
    return true;
  }

  leaveIt(): void {
    if (!this.mayBeLeft) return;
    this.parts.leave({ kind: MarkKind.DISTANCE, points: this.points.flatMap((point) => point.toArray()), text: '' });
    this.forgetPoints();
  }

  /** The wearer has taken the headset off. */
  left(): void {
    this.measure(false);
    this.beam = undefined;
    this.show();
  }

  private forgetPoints(): void {
    this.points = [];
    this.drawDraft();
  }

  private drawDraft(): void {
    if (this.draft) {
      this.root.remove(this.draft);
      disposeTree(this.draft);
    }
    const [first, last = first] = this.points;
    this.draft = undefined;
    if (!first || !last) return;
    const points = [...first.toArray(), ...last.toArray()];
    const kind = this.points.length === 2 ? MarkKind.DISTANCE : MarkKind.SKETCH;
    this.draft = drawingOf({ kind, points, text: '', colorRgb: this.parts.color() });
    this.root.add(this.draft);
  }

  private show(): void {
    if (this.beam && !this.drawn) this.root.add((this.drawn = beamOf(this.parts.color())));
    if (this.drawn) shine(this.drawn, this.beam);
  }
}
