// SPDX-License-Identifier: Apache-2.0
// Placing the room in the wearer's own, which a headset with passthrough shows: the room's floor goes to the place on the
// own floor, or on a table, at which the hand points. It is kept by an anchor where the headset has such, also for the
// next time, else until the headset is taken off. Loaded when a headset is put on.
import * as THREE from 'three';
import type { Store } from '../storage';
import { keepPlaced, keptPlaced, type PlacedRoom } from './placed_room';
import { inWorld, standingOver, surfaceUnder, yawOf, type StandingPlace } from './standing_place';

const ring_m = { inner: 0.12, outer: 0.16, above: 0.01 };
const leastUp = 0.8; // of the normal of a surface on which a room can be put

/** What the placer needs of an active headset. `floor`: the wearer's own floor. */
export interface OwnRoom {
  readonly session: XRSession;
  readonly floor: XRReferenceSpace;
  readonly room: string;
}

function vector({ x, y, z }: DOMPointReadOnly): THREE.Vector3 {
  return new THREE.Vector3(x, y, z);
}

function turnOf({ x, y, z, w }: DOMPointReadOnly): THREE.Quaternion {
  return new THREE.Quaternion(x, y, z, w);
}

export class RoomPlacer {
  readonly root: THREE.Mesh<THREE.RingGeometry, THREE.MeshBasicMaterial>; // where the hand points
  isOn = false;
  private own: OwnRoom | undefined;
  private held: THREE.Vector3 | undefined; // the point of the room that goes where the hand points
  private isPutDown = false;
  private source: { input: XRInputSource; hits: XRHitTestSource | undefined } | undefined;
  private kept: { anchor: XRAnchor; placed: PlacedRoom } | undefined;

  constructor(private readonly store: Store) {
    const material = new THREE.MeshBasicMaterial({ color: 0x56b4e9, depthTest: false, side: THREE.DoubleSide });
    this.root = new THREE.Mesh(new THREE.RingGeometry(ring_m.inner, ring_m.outer, 48).rotateX(-Math.PI / 2), material);
    this.root.renderOrder = 8;
    this.root.visible = false;
  }

  /** The headset is on. The room comes back to where it was put the last time, if the headset knows that place. */
  entered(own: OwnRoom): void {
    this.own = own;
    const placed = keptPlaced(this.store, own.room);
    if (!placed) return;
    own.session.restorePersistentAnchor?.(placed.handle).then(
      (anchor) => this.own === own && (this.kept = { anchor, placed }),
      () => undefined, // the headset does not know the place any more
    );
  }

  left(): void {
    this.end();
    this.own = this.kept = undefined;
  }

  begin(): void {
    this.isOn = this.own !== undefined;
    this.isPutDown = false;
    this.held = undefined;
  }

  /** With the next picture. */
  putDown(): void {
    this.isPutDown = true;
  }

  /** The wearer has gone somewhere else in the room: it is not where it was put any more. */
  release(): void {
    this.kept = undefined;
  }

  /** Where the wearer's floor is in the room now, while it is being placed; undefined: as before. */
  place(frame: XRFrame, before: StandingPlace, hand: XRInputSource | undefined, turn_rad: number): StandingPlace | undefined {
    const target = hand && this.targetOf(frame, hand);
    this.root.visible = target !== undefined;
    if (!target) {
      this.isPutDown = false; // nowhere to put it
      return undefined;
    }
    this.held ??= inWorld(before, target).setY(0);
    const place = standingOver(this.held, target, before.yaw + turn_rad);
    this.root.position.copy(this.held).setY(ring_m.above);
    if (this.isPutDown) this.keep(frame, place, target);
    return place;
  }

  /** Where the wearer's floor is by the anchor; undefined: as before. */
  follow(frame: XRFrame): StandingPlace | undefined {
    const { own, kept } = this;
    if (!own || !kept || !frame.trackedAnchors?.has(kept.anchor)) return undefined;
    const pose = frame.getPose(kept.anchor.anchorSpace, own.floor)?.transform;
    if (!pose) return undefined;
    const { x, z, heading } = kept.placed;
    return standingOver(new THREE.Vector3(x, 0, z), vector(pose.position), heading - yawOf(turnOf(pose.orientation)));
  }

  private end(): void {
    this.isOn = this.isPutDown = this.root.visible = false;
    this.source?.hits?.cancel();
    this.source = undefined;
  }

  private keep(frame: XRFrame, { yaw }: StandingPlace, target: THREE.Vector3): void {
    const { own, held } = this;
    this.end();
    this.kept = undefined;
    if (!own || !held || !frame.createAnchor) return;
    const spot = new XRRigidTransform({ x: target.x, y: target.y, z: target.z });
    const placed = { handle: '', x: held.x, z: held.z, heading: yaw };
    frame.createAnchor(spot, own.floor).then(
      async (anchor) => {
        if (this.own !== own || this.isOn) return anchor.delete();
        this.kept = { anchor, placed };
        const before = keptPlaced(this.store, own.room)?.handle;
        const handle = await anchor.requestPersistentHandle?.();
        if (handle) keepPlaced(this.store, own.room, { ...placed, handle });
        if (handle && before) await own.session.deletePersistentAnchor?.(before); // headsets keep few
      },
    ).catch(() => undefined); // the headset keeps no anchors: the room stays until it is taken off
  }

  /** The surface at which the hand points, in the space of the own floor: a known one, else the floor. */
  private targetOf(frame: XRFrame, hand: XRInputSource): THREE.Vector3 | undefined {
    const { floor } = this.own!;
    const found = this.hitsOf(frame, hand).flatMap((hit) => hit.getPose(floor)?.transform ?? []);
    const flat = found.find(({ orientation }) => new THREE.Vector3(0, 1, 0).applyQuaternion(turnOf(orientation)).y > leastUp);
    if (flat) return vector(flat.position);
    if (found.length > 0) return undefined; // a wall
    const ray = frame.getPose(hand.targetRaySpace, floor)?.transform;
    return ray && surfaceUnder(vector(ray.position), new THREE.Vector3(0, 0, -1).applyQuaternion(turnOf(ray.orientation)));
  }

  private hitsOf(frame: XRFrame, input: XRInputSource): XRHitTestResult[] {
    if (this.source?.input !== input) this.askFor(input);
    const hits = this.source?.hits;
    try {
      return hits ? frame.getHitTestResults(hits) : [];
    } catch {
      return []; // it begins with the next picture
    }
  }

  private askFor(input: XRInputSource): void {
    this.source?.hits?.cancel();
    const source = { input, hits: undefined as XRHitTestSource | undefined };
    this.source = source;
    this.own!.session.requestHitTestSource?.({ space: input.targetRaySpace })?.then(
      (hits) => (this.source === source ? (source.hits = hits) : hits.cancel()),
      () => undefined, // the headset knows no surfaces but its floor
    );
  }
}
