// SPDX-License-Identifier: Apache-2.0
// <roomcast-view src="https://hub.example.org/?room=lab">: a live room in a page.

export interface RoomcastState {
  /** `refused`: the hub cannot be reached, or does not let this site show the room. */
  phase: 'loading' | 'connecting' | 'joined' | 'waiting' | 'broken' | 'refused';
  /** What is wrong, in English, or empty. */
  sentence: string;
  /** The room needs a token, or another one. */
  needsToken: boolean;
  room: string;
  people: number;
  /** Online. */
  sensors: number;
  /** Names of places that people have named for everybody. */
  places: string[];
  /** Nobody is heard here. */
  muted: boolean;
}

export type Point = [x: number, y: number, z: number];

export declare class RoomcastView extends HTMLElement {
  /** The room's address; it names the room and holds no token. */
  src: string;
  /** A token for the room, if it needs one. It is no attribute, and goes to the hub of `src` alone. */
  token: string;
  muted: boolean;
  /** Where one stands at first, and goes when it changes: a place that somebody has named for everybody. */
  place: string;
  readonly state: RoomcastState;
  /** Smoothly to where `at` is, looking at `look`; metres, the room's world. */
  goTo(at: Point, look: Point): void;
}

declare global {
  interface HTMLElementTagNameMap {
    'roomcast-view': RoomcastView;
  }
  interface HTMLElementEventMap {
    'roomcast-state': CustomEvent<RoomcastState>;
  }
}
