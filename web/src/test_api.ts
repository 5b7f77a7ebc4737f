// SPDX-License-Identifier: Apache-2.0
// window.roomcast: the interface for tests. Described in web/README.md. All results are plain JSON: 64-bit numbers are
// strings. Pixels are CSS pixels of the canvas, from the top left.
import { Vector3 } from 'three';
import type { Mark, Pose } from './gen/control_pb';
import type { LazyPlayback } from './lazy_playback';
import type { RoomState } from './room_state';
import type { Sound } from './sound';
import { crc32 } from './stream/crc32';
import { IdPass, nothing } from './view/id_pass';
import type { Navigation } from './view/navigation';
import { takePicture } from './view/picture';
import type { DrawMode } from './view/draw_mode';
import type { Stage } from './view/stage';
import { lookFrom } from './view/view_state';
import type { Headset } from './xr/headset';

export interface TestApiParts {
  stage: Stage;
  state: RoomState;
  navigation: Navigation;
  headset: Headset;
  marks(): readonly Mark[];
  setMode(mode: DrawMode): void;
  sound: Sound;
  playback: LazyPlayback;
}

type Triple = [number, number, number];

declare global {
  interface Window {
    roomcast: TestApi;
  }
}

export class TestApi {
  constructor(private readonly parts: TestApiParts) {}

  state() {
    const { state, stage } = this.parts;
    const { connection, status } = state;
    const since = (at_ms: number | undefined) =>
      at_ms === undefined || connection.openedAt_ms === undefined ? null : at_ms - connection.openedAt_ms;
    return {
      phase: state.broken ? 'broken' : connection.phase,
      sentence: state.broken || connection.sentence,
      room: state.welcome?.room ?? null,
      viewerId: state.welcome?.viewerId ?? null,
      viewers: (state.roster?.viewers ?? []).map(({ id, name }) => ({ id, name })),
      avatars: stage.room.avatars.shown,
      shownSets: state.shownSets,
      lastShownSet: state.lastShownSet.toString(),
      pictures: stage.pictures,
      shownFps: state.shownFps,
      bytesPerSecond: state.bytesPerSecond,
      latency_ms: state.latency_ms ?? null,
      clockError_ms: status?.clock?.error_ms ?? null,
      draw_ms: stage.draw_ms,
      mode: stage.room.drawMode,
      modelTriangles: stage.room.model.triangles,
      quality: stage.quality,
      /** On the graphics processor; a steady increase would be a leak. */
      kept: { ...stage.renderer.info.memory },
      /** From requesting the socket until every online sensor was decoded, and drawn. */
      firstDecoded_ms: since(state.firstDecodedAt_ms),
      firstShown_ms: since(state.firstShownAt_ms),
    };
  }

  sensors() {
    const { state, stage } = this.parts;
    return (state.roster?.sensors ?? []).map(({ id, name, online, pose }) => {
      const traffic = state.status?.sensors.find((counts) => counts.sensor === id);
      const shown = state.shownSeqs.get(id);
      return {
        id,
        name,
        online,
        source: pose.source,
        worldFromDepth: [...pose.worldFromDepth],
        /** The drawn position, which differs while the sensor is moved by hand. */
        drawnAt: stage.room.placed.get(id)?.worldFromDepth.elements.slice(12, 15) ?? null,
        visible: stage.isVisible(id),
        frames: traffic?.frames ?? 0,
        skipped: traffic?.skipped ?? 0,
        bytes: traffic?.bytes ?? 0,
        problem: traffic?.problem ?? '',
        lastSeq: traffic?.lastSeq ?? null,
        lastSetId: traffic?.lastSetId?.toString() ?? null,
        shownSeq: shown?.seq ?? null,
        shownSetId: shown?.setId.toString() ?? null,
        fps: state.sensorFps(id),
      };
    });
  }

  /** The last 100 decoded frames of a sensor; only with ?record=1. The CRC is of the depth as little-endian u16. */
  decodedFrames(sensor: number) {
    return (this.parts.state.records.get(sensor) ?? []).map(({ seq, setId, capture_ns, depthCrc32 }) => ({
      seq,
      setId: setId.toString(),
      captureNs: capture_ns.toString(),
      depthCrc32,
    }));
  }

  /**
   * An active headset: the eyes' positions in the last picture, its direction, tracked hands, number of selects so far, how narrow the
   * view is.
   */
  headset() {
    const { headset, state, stage } = this.parts;
    const { head, leftHand, rightHand } = state.body ?? {};
    return {
      on: headset.isOn,
      presenting: stage.renderer.xr.isPresenting,
      views: headset.views,
      head: head ?? null,
      hands: [leftHand ?? null, rightHand ?? null],
      drawnHands: headset.drawnHands,
      passthrough: stage.room.isPassthrough,
      selects: headset.selects,
      narrowness: headset.narrowness,
      standing: headset.standing,
      places: headset.placer?.isOn ?? false,
      panel: headset.panel?.content ?? null,
    };
  }

  /** Last received head and hand poses of the other viewers, and the points that they point at. */
  otherPoses() {
    return [...this.parts.state.poses.values()].map(({ viewerId, head, leftHand, rightHand, pointer }) => ({
      viewerId,
      head: plain(head),
      hands: [plain(leftHand), plain(rightHand)],
      pointsAt: pointer?.to ? [pointer.to.x, pointer.to.y, pointer.to.z] : null,
    }));
  }

  /** Null before the voice module is loaded. */
  voice() {
    return this.parts.sound.figures;
  }

  /** State of the recording that is played, and how long the last seek took; null in a live room. */
  playback() {
    return this.parts.playback.figures;
  }

  /** The room's marks as they were received, oldest first. */
  marks() {
    return this.parts.marks().map(({ id, kind, points, text, author }) => ({ id, kind, points, text, author }));
  }

  setView(at: Triple, look: Triple): void {
    this.parts.navigation.set(lookFrom(new Vector3(...at), new Vector3(...look)));
  }

  view() {
    const { position, yaw, pitch } = this.parts.navigation.current;
    return { position: position.toArray(), yaw, pitch };
  }

  setMode(mode: DrawMode): void {
    this.parts.setMode(mode);
  }

  setVisible(sensor: number, visible: boolean): void {
    const entry = this.parts.state.roster?.sensors.find(({ id }) => id === sensor);
    if (entry) this.parts.stage.setVisible(entry.name, visible);
  }

  /** The colour at a pixel as the room is drawn now, and the sensor whose surface is frontmost there (or null). */
  pixel(x: number, y: number) {
    const { rgba, width } = takePicture(this.parts.stage);
    const at = y * width + x;
    const id = new IdPass(this.parts.stage).draw().ids[at]!;
    return { rgba: [...rgba.subarray(4 * at, 4 * at + 4)], sensor: id === nothing ? null : id };
  }

  /** The room as it is drawn now; not JSON. */
  picture() {
    return takePicture(this.parts.stage);
  }

  /** CRC-32 of the room's pixels as it is drawn now. */
  pictureCrc32(): number {
    return crc32(takePicture(this.parts.stage).rgba);
  }

  /**
   * For each sensor: the number of pixels that its surface would cover alone, how many of those no other sensor covers,
   * its number of pixels in the complete picture, and its own pixel deepest inside the area that only it covers.
   */
  coverage() {
    const pass = new IdPass(this.parts.stage);
    const all = pass.draw();
    const sensors = [...this.parts.stage.room.placed.keys()];
    const alone = new Map(sensors.map((id) => [id, pass.draw(id).ids]));
    return sensors.map((id) => {
      const others = sensors.filter((other) => other !== id).map((other) => alone.get(other)!);
      const own = Uint8Array.from(alone.get(id)!, (at, i) =>
        Number(at === id && others.every((ids) => ids[i] === nothing)),
      );
      return {
        id,
        alone: count(alone.get(id)!, id),
        only: count(own, 1),
        inFront: count(all.ids, id),
        example: innermost(own, all.width),
      };
    });
  }
}

function plain(pose: Pose | undefined) {
  if (!pose) return null;
  const { x, y, z, qx, qy, qz, qw } = pose;
  return { x, y, z, qx, qy, qz, qw };
}

function count(values: ArrayLike<number>, wanted: number): number {
  return Array.from(values).reduce((sum, value) => sum + Number(value === wanted), 0);
}

/** The middle of the largest square of ones (dynamic programming over its lower right corner); null without any. */
function innermost(ones: Uint8Array, width: number): [number, number] | null {
  const side = new Uint16Array(ones.length);
  let best = 0;
  for (let i = 0; i < side.length; i++) {
    if (!ones[i]) continue;
    const inside = i % width > 0 && i >= width;
    side[i] = inside ? 1 + Math.min(side[i - 1]!, side[i - width]!, side[i - width - 1]!) : 1;
    if (side[i]! > side[best]!) best = i;
  }
  if (!side[best]) return null;
  const half = side[best]! >> 1;
  return [(best % width) - half, Math.floor(best / width) - half];
}
