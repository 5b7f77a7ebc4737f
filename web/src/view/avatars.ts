// SPDX-License-Identifier: Apache-2.0
// Draws the other viewers: a head with a visor and the name above it, tracked hands with pointing rays, and the beam of
// the laser pointer. Part frames are x right, y up, -z forward. Poses arrive 20 times a second and are interpolated.
import * as THREE from 'three';
import type { Pose, ViewerEntry, ViewerPose } from '../gen/control_pb';
import { disposeTree } from './dispose_tree';
import { beamOf, shine } from './pointer_beam';
import { pointerRay } from './pointer_ray';

const easing_perS = 14;
const arrived_m = 1e-4;
const arrived_rad = 1e-3;
const pointer_m = 1.5;
const inTheEye_m = 0.25;
const labelWidth_m = 0.64;
const labelHeight_m = 0.12;
const quietLabel = 0xffffff;
const speakingLabel = 0x7dff9b;
const speakingScale = 1.25; // not by colour alone

interface Part {
  object: THREE.Object3D;
  position: THREE.Vector3;
  rotation: THREE.Quaternion;
  placed: boolean;
}

interface Avatar {
  root: THREE.Group;
  body: THREE.Group; // head and hands
  name: string;
  color: number;
  label: THREE.Sprite;
  speaks: boolean;
  head: Part;
  hands: [Part, Part];
  beam: THREE.Group;
}

function partOf(object: THREE.Object3D): Part {
  object.visible = false;
  return { object, position: new THREE.Vector3(), rotation: new THREE.Quaternion(), placed: false };
}

function aim(part: Part, pose: Pose | undefined): void {
  part.object.visible = pose !== undefined;
  if (!pose) {
    part.placed = false;
    return;
  }
  part.position.set(pose.x, pose.y, pose.z);
  part.rotation.set(pose.qx, pose.qy, pose.qz, pose.qw).normalize();
  if (part.placed) return;
  part.object.position.copy(part.position);
  part.object.quaternion.copy(part.rotation);
  part.placed = true;
}

/** Returns true while the part is still moving. */
function ease({ object, position, rotation }: Part, share: number): boolean {
  if (!object.visible) return false;
  const near = object.position.distanceTo(position) < arrived_m && object.quaternion.angleTo(rotation) < arrived_rad;
  if (near) return false;
  object.position.lerp(position, share);
  object.quaternion.slerp(rotation, share);
  return true;
}

function labelOf(name: string): THREE.Sprite {
  const canvas = document.createElement('canvas');
  canvas.width = 512;
  canvas.height = 96;
  const paint = canvas.getContext('2d')!;
  paint.font = '600 44px system-ui, sans-serif';
  const width = Math.min(500, paint.measureText(name).width + 48);
  paint.fillStyle = 'rgba(13, 17, 23, 0.72)';
  paint.beginPath();
  paint.roundRect(256 - width / 2, 12, width, 72, 36);
  paint.fill();
  paint.fillStyle = '#f2f5f8';
  paint.textAlign = 'center';
  paint.textBaseline = 'middle';
  paint.fillText(name, 256, 50, 470);
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map: texture, transparent: true, depthWrite: false }));
  sprite.scale.set(labelWidth_m, labelHeight_m, 1);
  sprite.position.y = 0.27;
  return sprite;
}

function headOf(color: number): THREE.Group {
  const head = new THREE.Group();
  const skull = new THREE.Mesh(new THREE.SphereGeometry(0.115, 24, 16), new THREE.MeshLambertMaterial({ color }));
  skull.scale.set(0.88, 1.12, 1);
  const visor = new THREE.Mesh(
    new THREE.SphereGeometry(0.1, 20, 12),
    new THREE.MeshLambertMaterial({ color: 0x11151a }),
  );
  visor.scale.set(0.86, 0.42, 0.7);
  visor.position.set(0, 0.02, -0.062);
  head.add(skull, visor);
  return head;
}

/** A hand with a ray that shows its pointing direction. */
function handOf(color: number): THREE.Group {
  const hand = new THREE.Group();
  const fist = new THREE.Mesh(new THREE.SphereGeometry(0.045, 16, 12), new THREE.MeshLambertMaterial({ color }));
  hand.add(fist, pointerRay(pointer_m, color));
  return hand;
}

export class Avatars {
  readonly root = new THREE.Group();
  private readonly byViewer = new Map<number, Avatar>();

  constructor() {
    const light = new THREE.DirectionalLight(0xffffff, 1.6);
    light.position.set(1, 3, 2);
    this.root.add(new THREE.HemisphereLight(0xffffff, 0x8090a0, 1.8), light);
  }

  /** `viewers` without this page's own viewer. */
  follow(viewers: readonly ViewerEntry[]): void {
    const present = new Map(viewers.map((viewer) => [viewer.id, viewer]));
    for (const [id, avatar] of this.byViewer) {
      const viewer = present.get(id);
      if (viewer && viewer.name === avatar.name && viewer.colorRgb === avatar.color) continue;
      this.byViewer.delete(id);
      this.root.remove(avatar.root);
      disposeTree(avatar.root);
    }
    for (const viewer of viewers) {
      if (!this.byViewer.has(viewer.id)) this.add(viewer);
    }
  }

  /** False when none of the poses belongs to a shown viewer. */
  move(poses: readonly ViewerPose[]): boolean {
    let moved = false;
    for (const { viewerId, head, leftHand, rightHand, pointer } of poses) {
      const avatar = this.byViewer.get(viewerId);
      if (!avatar) continue;
      moved = true;
      aim(avatar.head, head);
      aim(avatar.hands[0], leftHand);
      aim(avatar.hands[1], rightHand);
      shine(avatar.beam, pointer);
    }
    return moved;
  }

  /** Marks the names of those who speak. False: nothing has changed. */
  speak(speaking: ReadonlySet<number>): boolean {
    let changed = false;
    for (const [id, avatar] of this.byViewer) {
      const speaks = speaking.has(id);
      if (speaks === avatar.speaks) continue;
      changed = true;
      avatar.speaks = speaks;
      const scale = speaks ? speakingScale : 1;
      avatar.label.scale.set(scale * labelWidth_m, scale * labelHeight_m, 1);
      avatar.label.material.color.set(speaks ? speakingLabel : quietLabel);
    }
    return changed;
  }

  /** Returns true while a viewer is still moving, so that the page must draw again. */
  animate(seconds: number): boolean {
    const share = 1 - Math.exp(-easing_perS * seconds);
    let moving = false;
    for (const { head, hands } of this.byViewer.values()) {
      for (const part of [head, ...hands]) moving = ease(part, share) || moving;
    }
    return moving;
  }

  /** Somebody who stands where the eye is would fill the picture from within: only what they point at is drawn. */
  hideAt(eye: THREE.Vector3): void {
    for (const { body, head } of this.byViewer.values()) {
      body.visible = head.object.position.distanceTo(eye) >= inTheEye_m;
    }
  }

  get shown(): number[] {
    return [...this.byViewer].filter(([, avatar]) => avatar.head.object.visible).map(([id]) => id);
  }

  private add({ id, name, colorRgb: color }: ViewerEntry): void {
    const head = headOf(color);
    const label = () => labelOf(name || `viewer ${id}`);
    const ownLabel = label();
    head.add(ownLabel);
    const hands: [Part, Part] = [partOf(handOf(color)), partOf(handOf(color))];
    const beam = beamOf(color, label());
    const groups = { root: new THREE.Group(), body: new THREE.Group() };
    const avatar = { ...groups, name, color, label: ownLabel, speaks: false, head: partOf(head), hands, beam };
    avatar.body.add(head, hands[0].object, hands[1].object);
    avatar.root.add(avatar.body, beam);
    this.byViewer.set(id, avatar);
    this.root.add(avatar.root);
  }
}
