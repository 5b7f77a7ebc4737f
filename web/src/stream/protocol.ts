// SPDX-License-Identifier: Apache-2.0
// Messages between the page and its worker. The worker owns socket, clock and decoders; the page draws. Pixel arrays
// are transferred, not copied, and return to the worker after drawing.
import type { Access } from '../access';
import type { MarkKind, Marks, Pose, ViewerPose, Voices, Welcome } from '../gen/control_pb';
import type { RoomRoster } from '../room_roster';

export interface ViewFrame {
  sensor: number;
  seq: number;
  setId: bigint;
  capture_ms: number; // room time
  captureError_ms: number | undefined; // the sender's bound; undefined if unknown
  width: number;
  height: number;
  depth_mm: Uint16Array<ArrayBuffer>; // 0 = no reading
  flow: Float32Array<ArrayBuffer> | undefined; // how it moves, by cells (codec/scene_flow.ts); undefined while nothing does, or nobody wants it
  rgba: Uint8Array<ArrayBuffer> | undefined; // alpha 255 where the colour camera saw the surface, else 0; undefined without colour
}

/** The buffers that hold the frame's pixels. */
export function buffersOf({ depth_mm, flow, rgba }: ViewFrame): ArrayBuffer[] {
  return [depth_mm, flow, rgba].flatMap((pixels) => (pixels ? [pixels.buffer] : []));
}

export type ConnectionPhase = 'connecting' | 'joined' | 'waiting';

export interface ConnectionState {
  phase: ConnectionPhase;
  sentence: string; // the problem, or empty
  reload: boolean; // only reloading the page can help
  needsToken: boolean; // a token, or another one, will help
  ended: boolean; // the hub will refuse again, so the page does not try again by itself
  retryAt_ms: number | undefined; // by Date.now, while waiting to reconnect
  openedAt_ms: number | undefined; // page time when this connection's socket was requested
}

export const initialState: ConnectionState = {
  phase: 'connecting',
  sentence: '',
  reload: false,
  needsToken: false,
  ended: false,
  retryAt_ms: undefined,
  openedAt_ms: undefined,
};

/** Counts since the start of the worker. */
export interface SensorTraffic {
  sensor: number;
  frames: number; // decoded
  bytes: number; // received, decoded or not
  skipped: number; // not decodable, or only with a missing frame
  missed: number; // never arrived, by sequence number: left out on the way
  lastSeq: number | undefined;
  lastSetId: bigint | undefined;
  lastCapture_ms: number | undefined;
  isHeldBack: boolean; // that line does not take even all small renditions: only key frames of this one come
  isSmall: boolean; // its newest frame is of its small rendition: this viewer's line takes no more
  problem: string; // reason why its frames are not shown properly, or empty
}

export interface DecodedRecord {
  sensor: number;
  seq: number;
  setId: bigint;
  capture_ns: bigint;
  depthCrc32: number; // of the depth as little-endian u16
}

/** Page time is performance.timeOrigin + performance.now(): the same scale in the page and in its worker. */
export interface Status {
  clock: { roomFromPage_ms: number; error_ms: number } | undefined;
  received_bytes: number; // all messages
  sensors: SensorTraffic[];
  decoded: DecodedRecord[]; // since the last status; empty unless requested
  colorProblem: string; // reason why colour cannot be decoded here, or empty
}

/** What is done to all that comes from the hub, in a study. */
export interface Handicap {
  latency_ms: number; // added
  fps: number; // frame sets a second at most; 0: all
}

/** What a person wants of the recording that is played; what is left out stays as it is. */
export interface PlaybackCommand {
  seek_s?: number;
  paused?: boolean;
  speed?: number;
  loops?: boolean;
  isTogether?: boolean; // with others, whom one hears
}

export interface PlaybackState {
  name: string;
  began_at: number; // seconds since 1970
  length_s: number;
  position_s: number;
  paused: boolean;
  speed: number;
  loops: boolean;
  isWaiting: boolean; // for the hub
  isDamaged: boolean; // something is missing at the position
  voices: boolean; // people are heard in it
  seeks: number; // that have been carried out: frames that come after this are of the last one
  moment: readonly { sensor: number; seq: number }[]; // the frames that show the moment that was sought
}

export type FromWorker =
  | { kind: 'connection'; state: ConnectionState }
  | { kind: 'welcome'; welcome: Welcome }
  | { kind: 'roster'; roster: RoomRoster }
  | { kind: 'poses'; poses: ViewerPose[] }
  | { kind: 'voices'; voices: Voices }
  | { kind: 'spoken' } // audio has come, and there is no voice worker yet
  | { kind: 'marks'; marks: Marks }
  | { kind: 'guide'; viewer: number } // 0: nobody
  | { kind: 'playback'; state: PlaybackState }
  | { kind: 'line'; viewer: number; maySpeak: boolean } // to the others who play the recording; 0: there is none
  | { kind: 'unseen'; paused: number[] } // sensors that send nothing, as their surfaces are not in view
  | { kind: 'frames'; setId: bigint; frames: ViewFrame[]; decodedAt_ms: number }
  | { kind: 'status'; status: Status }
  | { kind: 'broken'; sentence: string }; // the worker cannot continue

export interface StartOptions {
  socketUrl: string;
  room: string;
  name: string;
  record: boolean; // fill Status.decoded
  hears: boolean; // ask the hub for audio
  access: Access;
  authorKey: Uint8Array; // of this viewer's marks
  playback?: { recording: string; from_s: number } | undefined; // instead of the live room
}

/** A mark to leave. `points`: x, y, z of each; metres, world. */
export interface NewMark {
  kind: MarkKind;
  points: number[];
  text: string;
}

export type ToWorker =
  | { kind: 'start'; options: StartOptions }
  | { kind: 'shown'; buffers: ArrayBuffer[] } // the frames of the last `frames` message have been drawn
  | { kind: 'pose'; body: Body }
  | { kind: 'nudge'; sensor: number; worldFromDepth: number[] }
  | { kind: 'voice'; port: MessagePort } // to the voice worker
  | { kind: 'mark'; mark: NewMark }
  | { kind: 'removeMarks'; ids: number[] }
  | { kind: 'guide'; on: boolean }
  | { kind: 'playback'; command: PlaybackCommand }
  | { kind: 'handicap'; handicap: Handicap }
  | { kind: 'rename'; name: string } // joins again
  | { kind: 'motion'; isWanted: boolean } // frames are to come with their flow
  | { kind: 'stats'; lastSetId: bigint; shownFps: number; latency_ms: number };

/** A Pose without the fields added by Protobuf. */
export type PlainPose = Pick<Pose, 'x' | 'y' | 'z' | 'qx' | 'qy' | 'qz' | 'qw'>;

/** From the hand to the point pointed at; metres, world. */
export interface PlainBeam {
  from: { x: number; y: number; z: number };
  to: { x: number; y: number; z: number };
}

/** This viewer's pose. Hands are undefined while they are not tracked, the pointer while it is off. */
export interface Body {
  head: PlainPose;
  leftHand: PlainPose | undefined;
  rightHand: PlainPose | undefined;
  pointer?: PlainBeam | undefined;
  /** Absent: the hub is to send all. */
  view?: ViewAngles | undefined;
}

/** How far one sees from the head's -z axis, radians: at most, to either side, and up and down; 0: no less than at most. */
export interface ViewAngles {
  halfAngle: number;
  halfWidth: number;
  halfHeight: number;
}

export function pageTime_ms(): number {
  return performance.timeOrigin + performance.now();
}
