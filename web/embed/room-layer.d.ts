// SPDX-License-Identifier: Apache-2.0
// A room as a layer of another three.js scene.
import type { Camera, Group, WebGLRenderer } from 'three';

export interface RoomLayerOptions {
  /** The hub's address, "https://hub.example.org". Its configuration lists this site in `access.origins`. */
  hub: string;
  room: string;
  token?: string;
  /** This viewer's, as the room's people see it. */
  name?: string;
  mode?: 'mesh' | 'points';
  /** Every `step`-th reading of each sensor is drawn; 1 (all) without it. */
  step?: number;
  /** Something of `state` has changed. */
  onState?: (state: RoomLayerState) => void;
}

export interface RoomLayerState {
  phase: 'connecting' | 'joined' | 'waiting' | 'broken';
  /** What is wrong, in English, or empty. */
  sentence: string;
  /** Online. */
  sensors: string[];
  people: number;
  /** Frame sets that have been put into the scene. */
  sets: number;
}

/** Metres, y up, floor at y = 0. Move, turn and scale it like any object. */
export declare class RoomLayer extends Group {
  constructor(options: RoomLayerOptions);
  readonly state: RoomLayerState;
  /** Call before each picture: puts the newest frames into the scene. */
  update(renderer: WebGLRenderer, camera: Camera): void;
  /** Leaves the room and frees what it holds. */
  dispose(): void;
}
