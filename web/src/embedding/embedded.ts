// SPDX-License-Identifier: Apache-2.0
// The page's side of a frame: tells the page around it what the room is like, and does what that one asks.
import { lookFrom } from '../view/view_state';
import type { Marking } from '../marking';
import type { RoomPlaces } from '../room_places';
import type { RoomState } from '../room_state';
import type { Sound } from '../sound';
import type { Standpoint } from '../standpoint';
import { drawModes, type DrawMode } from '../view/draw_mode';
import { isWithinLimits } from '../view/view_address';
import { Vector3 } from 'three';
import { portMessage, readyMessage, toRoom, type EmbedState, type FromRoom, type ToRoom } from './messages';

const tellEvery_ms = 250;

export interface EmbeddedParts {
  state: RoomState;
  sound: Pick<Sound, 'hearOthers' | 'hears'>;
  standpoint: Pick<Standpoint, 'goToView'>;
  marking: Pick<Marking, 'places'>;
  places: Pick<RoomPlaces, 'goToNamed'>;
  setMode(mode: DrawMode): void;
}

export class Embedded {
  private port: MessagePort | undefined;
  private told = '';

  constructor(private readonly parts: EmbeddedParts) {}

  begin(): void {
    window.addEventListener('message', (event) => {
      const [port] = event.ports;
      if (event.source === window.parent && event.data === portMessage && port) this.speakOver(port);
    });
    window.parent.postMessage(readyMessage, '*'); // the hub's policy says who may be around this page
    setInterval(() => this.tell(), tellEvery_ms);
  }

  private speakOver(port: MessagePort): void {
    this.port?.close();
    this.port = port;
    port.onmessage = ({ data }) => {
      const command = toRoom(data);
      if (command) this.obey(command);
    };
    this.told = '';
    this.tell();
  }

  private obey(command: ToRoom): void {
    const { sound, standpoint, places, setMode } = this.parts;
    if (command.kind === 'mute') sound.hearOthers(!command.muted);
    else if (command.kind === 'place') places.goToNamed(command.name);
    else if (command.kind === 'mode') drawModes.filter((mode) => mode === command.mode).forEach(setMode);
    else {
      const [at, look] = [new Vector3(...command.at), new Vector3(...command.look)];
      if (isWithinLimits(at) && isWithinLimits(look)) standpoint.goToView(lookFrom(at, look));
    }
    this.tell();
  }

  private tell(): void {
    const state = this.state;
    const text = JSON.stringify(state);
    if (!this.port || text === this.told) return;
    this.told = text;
    this.port.postMessage({ kind: 'state', state } satisfies FromRoom);
  }

  private get state(): EmbedState {
    const { state, sound, marking } = this.parts;
    const { broken, connection, welcome, roster } = state;
    return {
      phase: broken ? 'broken' : connection.phase,
      sentence: broken || connection.sentence,
      needsToken: connection.needsToken,
      room: welcome?.room ?? '',
      people: roster?.viewers.length ?? 0,
      sensors: state.onlineSensors.length,
      places: marking.places.map(({ text }) => text),
      muted: !sound.hears,
    };
  }
}
