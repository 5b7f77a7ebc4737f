// SPDX-License-Identifier: Apache-2.0
// An active headset: enters and leaves, moves the wearer through the room, and reports head and hand poses. All poses
// are in world coordinates: the session's reference space is offset by the wearer's place in the room.
import * as THREE from 'three';
import type { Body, PlainBeam, PlainPose } from '../stream/protocol';
import { throwArc } from './arc';
import { ArcView } from './arc_view';
import { liftOf, narrowed, type Comfort } from './comfort';
import { HandView } from './hand_view';
import type { HeadsetMode } from './offer';
import { movedTo, originOffset, turned, walked, yawOf, type StandingPlace } from './standing_place';
import { Sticks, type Stick } from './sticks';
import { ViewFrame } from './view_frame';

const walkSpeed_mPerS = 1.4;
const turnSpeed_radPerS = 1.2; // of the room, while it is being placed
const longestFrame_s = 0.1;

/** What can be pointed at and pressed in the headset, besides the floor. */
export interface Pressable {
  update(head: THREE.Vector3, yaw: number): void;
  /** True where the ray meets it. */
  point(from: THREE.Vector3, direction: THREE.Vector3): boolean;
  press(): void;
  /** The wearer has taken the headset off. */
  close(): void;
  /** For tests. */
  readonly content: unknown;
}

/** Puts the room somewhere in the wearer's own, which is seen around it (room_placer.ts). */
export interface Placer {
  readonly isOn: boolean;
  place(frame: XRFrame, before: StandingPlace, hand: XRInputSource | undefined, turn_rad: number): StandingPlace | undefined;
  follow(frame: XRFrame): StandingPlace | undefined;
  putDown(): void;
  release(): void;
  entered(own: { session: XRSession; floor: XRReferenceSpace; room: string }): void;
  left(): void;
}

/** A beam from a hand (hand_laser.ts). */
export interface Laser {
  readonly isMeasuring: boolean;
  update(now_ms: number, ray: readonly [THREE.Vector3, THREE.Vector3] | undefined): PlainBeam | undefined;
  press(): boolean;
  left(): void;
}

export interface HeadsetEvents {
  began(mode: HeadsetMode): void;
  moved(body: Body): void;
  ended(): void;
}

function plain({ position: p, orientation: o }: XRRigidTransform): PlainPose {
  return { x: p.x, y: p.y, z: p.z, qx: o.x, qy: o.y, qz: o.z, qw: o.w };
}

function stickOf({ gamepad }: XRInputSource): Stick | undefined {
  const axes = gamepad?.axes ?? [];
  return axes.length >= 4 ? { x: axes[2]!, y: axes[3]! } : undefined; // position of the stick in the "xr-standard" mapping
}

function jointsOf(frame: XRFrame, hand: XRHand, space: XRReferenceSpace): XRJointPose[] {
  const poses = [...hand.values()].map((joint) => frame.getJointPose?.(joint, space));
  return poses.filter((pose): pose is XRJointPose => pose !== undefined && pose !== null);
}

function sideOf({ handedness }: XRInputSource): 0 | 1 {
  return handedness === 'left' ? 0 : 1;
}

/** Where a hand is, and where it points. */
function rayOf({ position: p, orientation: o }: XRRigidTransform): [THREE.Vector3, THREE.Vector3] {
  const ahead = new THREE.Vector3(0, 0, -1).applyQuaternion(new THREE.Quaternion(o.x, o.y, o.z, o.w));
  return [new THREE.Vector3(p.x, p.y, p.z), ahead];
}

export class Headset {
  readonly root = new THREE.Group(); // to be added to the scene
  views: { eye: XREye; position: [number, number, number] }[] = []; // of the last picture
  panel: Pressable | undefined;
  placer: Placer | undefined;
  laser: Laser | undefined;
  selects = 0; // triggers pulled and pinches made, in this session
  private readonly hands = [new HandView(), new HandView()] as const;
  private readonly arc = new ArcView();
  private readonly frame = new ViewFrame();
  private narrow = 0; // how narrow the view is, 0 to 1
  private lift_m = 0; // of a seated wearer
  private wasSeated = false;
  private seesOwnRoom = false; // which stands still: nothing has to be hidden
  private sticks = new Sticks();
  private session: XRSession | undefined;
  private floor: XRReferenceSpace | undefined; // the wearer's physical floor
  private place: StandingPlace = { x: 0, y: 0, z: 0, yaw: 0 };
  private selecting: XRInputSource | undefined;
  private gripped: XRInputSource | undefined; // its hand points
  private target: THREE.Vector3 | undefined; // on the floor, while aiming
  private teleports: THREE.Vector3 | undefined; // teleport with the next picture, when the head pose is known
  private lastFrame_ms = 0;
  private onPanel: number | undefined; // the hand that points at the panel: 0 left, 1 right

  constructor(
    private readonly xr: THREE.WebXRManager,
    private readonly events: HeadsetEvents,
    private readonly comfort: Comfort,
  ) {
    this.root.add(this.frame.root, this.arc.root, ...this.hands.map((hand) => hand.root));
    this.root.visible = false;
  }

  /** The drawn shapes of the left and the right hand. */
  get drawnHands() {
    return this.hands.map((hand) => hand.shows);
  }

  /** How narrow the view is now, 0 to 1. */
  get narrowness(): number {
    return this.frame.root.visible ? this.narrow : 0;
  }

  get isOn(): boolean {
    return this.session !== undefined;
  }

  /** What is around the wearer: undefined unless it is seen. */
  get ownRoom(): { session: XRSession; floor: XRReferenceSpace } | undefined {
    const { session, floor } = this;
    return session && floor && this.seesOwnRoom ? { session, floor } : undefined;
  }

  /** The wearer's own floor in the room. */
  get standing(): StandingPlace {
    return this.place;
  }

  /** The wearer enters at `at`, with heading `yaw`. Rejects with the browser's reason. */
  async enter(mode: HeadsetMode, at: THREE.Vector3, yaw: number): Promise<void> {
    const session = await navigator.xr!.requestSession(mode, {
      requiredFeatures: ['local-floor'],
      optionalFeatures: ['bounded-floor', 'hand-tracking', 'hit-test', 'anchors'],
    });
    session.addEventListener('end', () => this.end());
    session.addEventListener('selectstart', ({ inputSource }) => this.selectWith(inputSource));
    session.addEventListener('selectend', () => this.letGo());
    session.addEventListener('select', () => this.selects++);
    session.addEventListener('squeezestart', ({ inputSource }) => (this.gripped = inputSource));
    session.addEventListener('squeezeend', () => (this.gripped = undefined));
    await this.xr.setSession(session);
    this.session = session;
    this.selects = 0;
    this.sticks = new Sticks();
    this.narrow = this.lift_m = 0;
    this.wasSeated = false;
    this.seesOwnRoom = mode === 'immersive-ar';
    this.floor = this.xr.getReferenceSpace()!;
    this.standAt({ x: at.x, y: 0, z: at.z, yaw });
    this.root.visible = true;
    this.events.began(mode);
  }

  /** To another place on the floor; with the next picture, when the head's pose is known. */
  goTo(at: THREE.Vector3): void {
    this.teleports = at.clone().setY(0);
  }

  async leave(): Promise<void> {
    await this.session?.end();
  }

  /** Call once per picture of the headset. */
  update(now_ms: number, frame: XRFrame): void {
    const space = this.xr.getReferenceSpace();
    const viewer = space && frame.getViewerPose(space);
    if (!space || !viewer || !this.session) return;
    this.views = viewer.views.map(({ eye, transform: { position: p } }) => ({ eye, position: [p.x, p.y, p.z] }));
    const seconds = Math.min(longestFrame_s, Math.max(0, (now_ms - this.lastFrame_ms) / 1000));
    this.lastFrame_ms = now_ms;
    const tracked = this.showHands(frame, space);
    this.showPanel(viewer.transform, tracked);
    this.sit(viewer.transform);
    const isPlaced = this.placeRoom(frame, seconds);
    const isMoved = !isPlaced && this.move(viewer.transform, tracked, seconds);
    this.narrow = narrowed(this.narrow, isMoved && this.comfort.narrowsView && !this.seesOwnRoom, seconds);
    this.frame.show(this.narrow, viewer.transform);
    const [left, right] = tracked.map((pose) => pose && plain(pose));
    const pointer = this.laser?.update(now_ms, this.pointingRay(tracked));
    this.events.moved({ head: plain(viewer.transform), leftHand: left, rightHand: right, pointer });
  }

  private selectWith(source: XRInputSource): void {
    if (this.onPanel === sideOf(source)) this.panel?.press();
    else if (this.placer?.isOn) this.placer.putDown();
    else if (this.laser?.press()) return;
    else this.selecting = source;
  }

  /** Of the hand that is to point, unless it points at the panel. */
  private pointingRay(hands: (XRRigidTransform | undefined)[]): [THREE.Vector3, THREE.Vector3] | undefined {
    const gripped = this.gripped && hands[sideOf(this.gripped)];
    const hand = gripped ?? (this.laser?.isMeasuring ? (hands[1] ?? hands[0]) : undefined);
    return hand && this.onPanel === undefined && !this.placer?.isOn ? rayOf(hand) : undefined;
  }

  private showPanel({ position: p, orientation: o }: XRRigidTransform, hands: (XRRigidTransform | undefined)[]): void {
    const { panel } = this;
    if (!panel) return;
    panel.update(new THREE.Vector3(p.x, p.y, p.z), yawOf(new THREE.Quaternion(o.x, o.y, o.z, o.w)));
    this.onPanel = [1, 0].find((side) => {
      const hand = hands[side];
      return hand && panel.point(...rayOf(hand));
    });
  }

  private showHands(frame: XRFrame, space: XRReferenceSpace): (XRRigidTransform | undefined)[] {
    const found: (XRRigidTransform | undefined)[] = [undefined, undefined];
    this.hands.forEach((hand) => hand.hide());
    for (const source of this.session!.inputSources) {
      const side = sideOf(source);
      const pose = frame.getPose(source.targetRaySpace, space)?.transform;
      if (!pose) continue;
      found[side] = pose;
      const joints = source.hand ? jointsOf(frame, source.hand, space) : [];
      if (joints.length > 0) this.hands[side].showJoints(joints);
      else this.hands[side].showController(pose);
    }
    return found;
  }

  /** True while the wearer chooses a place for the room. Else it stays where it was put. */
  private placeRoom(frame: XRFrame, seconds: number): boolean {
    const { placer } = this;
    if (!placer || !this.seesOwnRoom) return false;
    const isOn = placer.isOn;
    const hands = [...this.session!.inputSources].filter(({ handedness }) => handedness !== 'none');
    const hand = hands.find(({ handedness }) => handedness === 'right') ?? hands[0];
    const turn = hand ? (stickOf(hand)?.x ?? 0) : 0;
    const turn_rad = Math.abs(turn) < 0.2 ? 0 : turn * turnSpeed_radPerS * seconds;
    const place = isOn ? placer.place(frame, this.place, hand, turn_rad) : placer.follow(frame);
    if (place) this.standAt(place);
    return isOn;
  }

  /** Lifts who has said that he sits, from where his eyes are then; puts him down again when he stands. */
  private sit({ position }: XRRigidTransform): void {
    if (this.comfort.isSeated === this.wasSeated) return;
    this.wasSeated = this.comfort.isSeated;
    const eyes_m = position.y - this.place.y - this.lift_m;
    this.lift_m = this.wasSeated && !this.seesOwnRoom ? liftOf(eyes_m) : 0; // the own floor stays where it is
    this.standAt(this.place);
  }

  /** True while a stick walks the wearer smoothly. */
  private move(head: XRRigidTransform, hands: (XRRigidTransform | undefined)[], seconds: number): boolean {
    const sticks = [...this.session!.inputSources].map((source) => ({
      side: source.handedness,
      stick: stickOf(source),
    }));
    const stick = (side: XRHandedness) => sticks.find((entry) => entry.side === side)?.stick;
    const wishes = this.sticks.read(stick('left'), stick('right'));
    const at = new THREE.Vector3(head.position.x, head.position.y, head.position.z);
    const { x, y, z, w } = head.orientation;
    const step_m = walkSpeed_mPerS * seconds;
    if (wishes.turn_rad !== 0) this.goOn(turned(this.place, at, wishes.turn_rad));
    if (wishes.right !== 0 || wishes.forward !== 0) {
      const yaw = yawOf(new THREE.Quaternion(x, y, z, w));
      this.goOn(walked(this.place, yaw, wishes.right * step_m, wishes.forward * step_m));
    }
    const aiming = wishes.aims ? hands[1] : this.selecting && hands[sideOf(this.selecting)];
    if (aiming) this.aim(aiming);
    if (wishes.letsGo) this.letGo();
    if (this.teleports) this.goOn(movedTo(this.place, at, this.teleports));
    this.teleports = undefined;
    return wishes.right !== 0 || wishes.forward !== 0;
  }

  private aim(hand: XRRigidTransform): void {
    const arc = throwArc(...rayOf(hand));
    this.target = arc.at(-1);
    this.arc.show(arc);
  }

  private letGo(): void {
    this.selecting = undefined;
    this.teleports = this.target;
    this.target = undefined;
    this.arc.hide();
  }

  /** To another place in the room. */
  private goOn(place: StandingPlace): void {
    this.placer?.release();
    this.standAt(place);
  }

  private standAt(place: StandingPlace): void {
    this.place = place;
    const { position: p, orientation: o } = originOffset({ ...place, y: place.y + this.lift_m });
    const offset = new XRRigidTransform({ x: p.x, y: p.y, z: p.z }, { x: o.x, y: o.y, z: o.z, w: o.w });
    this.xr.setReferenceSpace(this.floor!.getOffsetReferenceSpace(offset));
  }

  private end(): void {
    this.session = this.floor = this.selecting = this.gripped = this.target = this.teleports = undefined;
    this.placer?.left();
    this.laser?.left();
    this.views = [];
    this.root.visible = false;
    this.arc.hide();
    this.frame.hide();
    this.events.ended();
  }
}
