// SPDX-License-Identifier: Apache-2.0
// The panel in the headset: a small tile in front of the wearer's waist, which says what is wrong, and a board that it
// opens: people, whom one hears, the microphone, leaving. What a study has to say comes before it. Loaded when a headset
// is put on.
import * as THREE from 'three';
import { problems } from '../panel/problems';
import { nameOf } from '../panel/people_list';
import type { RoomState } from '../room_state';
import type { Sound } from '../sound';
import { headsetPanelTexts as texts } from '../headset_texts';
import { Board } from './board';
import type { Comfort } from './comfort';
import type { HandLaser } from './hand_laser';
import type { Placer } from './headset';
import type { BoardButton, BoardSheet, SheetHolder } from './board_sheet';

export { HandLaser } from './hand_laser';
export { RoomPlacer } from './room_placer';

const board_m = { ahead: 1.4, below: 0.1 };
const tile_m = { ahead: 0.7, below: 0.5 };
const tileScale = 0.35;
const followAfter_m = 0.3;
const followAfter_rad = 0.6;
const replaceAfter_m = 1.5;
const replaceAfter_rad = 1.2;
const mostPeople = 8;
const mostTroubles = 3;

export interface HeadsetPanelParts {
  state: RoomState;
  hubAddress: string;
  sound: Pick<Sound, 'toggle' | 'isOn' | 'isSilenced' | 'silence' | 'mayBeHeard'>;
  sheets: SheetHolder;
  comfort: Comfort; // changed by the wearer
  comfortChanged(): void;
  placer: Pick<Placer, 'isOn'> & { begin(): void };
  seesOwnRoom(): boolean; // the wearer
  laser: Pick<HandLaser, 'isMeasuring' | 'measure' | 'distance' | 'mayBeLeft' | 'leaveIt'>;
  goToStart(): void;
  leave(): void;
}

/** Where a board was put, as the wearer stood then. */
class Spot {
  private at: THREE.Vector3 | undefined;
  private yaw = 0;

  forget(): void {
    this.at = undefined;
  }

  /** True when the wearer is elsewhere now, or looks elsewhere. */
  isLeft(head: THREE.Vector3, yaw: number, far_m: number, far_rad: number): boolean {
    const turned = Math.abs(Math.atan2(Math.sin(yaw - this.yaw), Math.cos(yaw - this.yaw)));
    if (this.at && this.at.distanceTo(head) < far_m && turned < far_rad) return false;
    this.at = head.clone();
    this.yaw = yaw;
    return true;
  }
}

export class HeadsetPanel {
  readonly root = new THREE.Group();
  private readonly board = new Board();
  private readonly tile = new Board(tileScale);
  private readonly boardSpot = new Spot();
  private readonly tileSpot = new Spot();
  private isOpen = false;
  private pointed: Board | undefined;

  constructor(private readonly parts: HeadsetPanelParts) {
    this.root.add(this.board.root, this.board.dot, this.tile.root, this.tile.dot);
  }

  /** For tests. */
  get content() {
    return { board: this.board.isShown ? this.board.content : null, tile: this.tile.isShown ? this.tile.content : null };
  }

  /** Call once per picture. */
  update(head: THREE.Vector3, yaw: number): void {
    const wasShown = this.board.isShown;
    const said = this.parts.sheets.sheet;
    this.board.show(this.isOpen ? this.menu() : said);
    this.tile.show(this.isOpen ? undefined : this.tileSheet());
    if (!wasShown) this.boardSpot.forget();
    if (this.board.isShown && this.boardSpot.isLeft(head, yaw, replaceAfter_m, replaceAfter_rad))
      this.board.placeBefore(head, yaw, board_m.ahead, board_m.below);
    if (this.tileSpot.isLeft(head, yaw, followAfter_m, followAfter_rad))
      this.tile.placeBefore(head, yaw, tile_m.ahead, tile_m.below);
  }

  /** True where the ray meets something that can be pressed, or would hide it. */
  point(from: THREE.Vector3, direction: THREE.Vector3): boolean {
    const boards = this.parts.placer.isOn ? [] : [this.tile, this.board]; // the room goes where the hand points
    [this.pointed] = boards.filter((board) => board.point(from, direction));
    return this.pointed !== undefined;
  }

  press(): void {
    this.pointed?.press();
  }

  /** The wearer has taken the headset off. */
  close(): void {
    this.isOpen = false;
    this.boardSpot.forget();
    this.tileSpot.forget();
  }

  private get troubles(): string[] {
    const { state, hubAddress } = this.parts;
    const { broken, connection, roster, status, unseen } = state;
    const found = problems({ broken, connection, roster, status, unseen, hubAddress }, state.roomTime_ms(), Date.now());
    return found.slice(0, mostTroubles).map(({ sentence }) => sentence);
  }

  private tileSheet(): BoardSheet {
    const { placer, laser } = this.parts;
    if (laser.isMeasuring) return this.measuringSheet();
    if (placer.isOn) return { title: '', words: [texts.placing], rows: [], press: () => undefined };
    const { bar } = this.parts.sheets;
    const buttons = [{ id: 'open', text: texts.open }, ...(bar?.rows.flatMap((row) => row.buttons) ?? [])];
    const words = [...this.troubles.slice(0, 1), ...(bar?.words ?? [])];
    const press = (id: string) => (id === 'open' ? void (this.isOpen = true) : bar?.press(id));
    return { title: '', words, rows: [{ buttons }], press };
  }

  private measuringSheet(): BoardSheet {
    const { laser } = this.parts;
    const buttons = [...(laser.mayBeLeft ? [{ id: 'leave', text: texts.leaveIt }] : []), { id: 'done', text: texts.measured }];
    const press = (id: string) => (id === 'leave' ? laser.leaveIt() : laser.measure(false));
    return { title: laser.distance, words: [texts.measuring], rows: [{ buttons }], press };
  }

  private menu(): BoardSheet {
    const { state, sound, comfort } = this.parts;
    const others = (state.roster?.viewers ?? []).filter(({ id }) => id !== state.welcome?.viewerId);
    const people: BoardButton[] = others.slice(0, mostPeople).map((viewer) => {
      const isSilenced = sound.isSilenced(viewer.id);
      return { id: `person ${viewer.id}`, text: texts.person(nameOf(viewer), isSilenced), isOn: !isSilenced };
    });
    const more = others.length > mostPeople ? [texts.more(others.length - mostPeople)] : [];
    const own: BoardButton[] = [
      ...(sound.mayBeHeard ? [{ id: 'microphone', text: texts.microphone(sound.isOn), isOn: sound.isOn }] : []),
      { id: 'measure', text: texts.measure },
      { id: 'start', text: texts.start },
      { id: 'leave', text: texts.leave },
      { id: 'close', text: texts.close },
    ];
    const comforts: BoardButton[] = this.parts.seesOwnRoom()
      ? [{ id: 'place', text: texts.place }]
      : [
          { id: 'narrow', text: texts.narrow, isOn: comfort.narrowsView },
          { id: 'seated', text: texts.seated, isOn: comfort.isSeated },
        ];
    return {
      title: state.welcome?.room ?? '',
      words: this.troubles,
      rows: [{ text: others.length > 0 ? texts.people : texts.alone, buttons: people }, ...more.map((text) => ({ text, buttons: [] })), { buttons: comforts }, { buttons: own }],
      press: (id) => this.pressed(id),
    };
  }

  private pressed(id: string): void {
    const { sound, comfort, goToStart, leave } = this.parts;
    if (id === 'narrow' || id === 'seated') {
      if (id === 'narrow') comfort.narrowsView = !comfort.narrowsView;
      else comfort.isSeated = !comfort.isSeated;
      return this.parts.comfortChanged();
    }
    if (id === 'place') this.parts.placer.begin();
    if (id === 'measure') this.parts.laser.measure(true);
    const person = /^person (\d+)$/.exec(id);
    if (person) {
      const viewer = Number(person[1]);
      sound.silence(viewer, !sound.isSilenced(viewer));
    } else if (id === 'microphone') void sound.toggle();
    else if (id === 'start') goToStart();
    else if (id === 'leave') leave();
    if (id !== 'microphone' && !person) this.isOpen = false;
  }
}
