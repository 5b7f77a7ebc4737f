// SPDX-License-Identifier: Apache-2.0
// Where the messages of a room come from: a hub, live, or a recording.
import type { RoomClock } from '../clock/room_clock';
import type { Marks, Roster, UnseenSensors, ViewerPose, Voices, Welcome } from '../gen/control_pb';
import type { AudioHeader } from '../wire/audio_header';
import type { ControlMessage } from '../wire/control';
import type { FrameHeader } from '../wire/frame_header';
import type { ConnectionState, PlaybackCommand, PlaybackState } from './protocol';

export interface RoomEvents {
  connection(state: ConnectionState): void;
  welcome(welcome: Welcome): void;
  roster(roster: Roster): void;
  poses(poses: ViewerPose[]): void;
  marks(marks: Marks): void;
  /** Who shows everybody around; 0: nobody. */
  guide(viewer: number): void;
  /** A hidden frame is decoded, because later ones need it, and not shown. */
  frame(header: FrameHeader, payload: Uint8Array, isHidden?: boolean): void;
  /** The hub leaves out frames of these sensors, wholly or in part, because this viewer cannot see what they show. */
  unseen(sensors: UnseenSensors): void;
  /** The set has no more frames. */
  setEnded(setId: bigint): void;
  voices(voices: Voices): void;
  audio(header: AudioHeader, payload: Uint8Array): void;
  /** The connection ended; a new one follows. */
  disconnected(): void;
  /** Another moment of a recording follows. */
  rewound(): void;
  /** Audio that has not been heard yet is of another time than what follows. */
  silenced(): void;
  /** Of a recording: people who play it can hear this one as a viewer of this ID, if it may speak; 0: nobody can. */
  line(viewer: number, maySpeak: boolean): void;
  /** Of a recording. */
  playback(state: PlaybackState): void;
}

export interface RoomSource {
  readonly received_bytes: number;
  readonly clock: RoomClock;
  connect(): void;
  send(message: ControlMessage): void;
  /** Audio of this viewer. */
  sendAudio(page_ms: number, ends: boolean, payload: Uint8Array): void;
  rename(name: string): void;
  /** Of a recording. */
  control(command: PlaybackCommand): void;
}
