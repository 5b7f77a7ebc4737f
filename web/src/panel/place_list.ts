// SPDX-License-Identifier: Apache-2.0
// Places to go to by one press: from above, what each sensor sees, those that somebody has named for everybody, and
// those that are named in this browser only.
import type { Mark } from '../gen/control_pb';
import type { Place } from '../own_places';
import type { RoomSensor } from '../room_roster';
import { placesTexts as texts } from '../texts';
import { element, setText } from './element';
import { labelled, textField } from './form';
import { KeyedList, type Row } from './keyed_list';

const longest = 64;

export interface PlaceEvents {
  fromAbove(): void;
  asSensor(sensor: number): void;
  goToPlace(place: Place): void;
  /** Names where one stands now; false if that is not possible. */
  keep(name: string): boolean;
  forget(place: Place): void;
  goToMark(place: Mark): void;
  /** As `keep`, for everybody. */
  keepForAll(name: string): boolean;
  removeForAll(place: Mark): void;
}

export interface RoomPlaces {
  places: readonly Mark[]; // of kind PLACE
  mayMark: boolean;
  mayRemove(place: Mark): boolean;
}

function plain(text: string): HTMLButtonElement {
  return element('button', { type: 'button', class: 'plain' }, text);
}

export class PlaceList {
  readonly root: HTMLElement;
  private readonly roomList = element('ul', { class: 'own-places' });
  private readonly ofRoom: KeyedList<Mark>;
  private readonly forAll = plain(texts.keepForAll);
  private mayRemove: (place: Mark) => boolean = () => false;
  private readonly list = element('ul', { class: 'own-places' });
  private readonly own: KeyedList<Place>;
  private readonly sensorList = element('div', { class: 'buttons' });
  private readonly ofSensors: KeyedList<RoomSensor>;
  private readonly field = textField(longest);
  private readonly said = element('p', { role: 'status' });

  constructor(private readonly events: PlaceEvents) {
    this.own = new KeyedList<Place>(this.list, ({ name }) => name, (place) => this.row(place));
    this.ofRoom = new KeyedList<Mark>(this.roomList, ({ id }) => String(id), (place) => this.roomRow(place));
    this.ofSensors = new KeyedList<RoomSensor>(this.sensorList, ({ id }) => String(id), (sensor) => this.sensorRow(sensor));
    const above = plain(texts.fromAbove);
    above.addEventListener('click', () => events.fromAbove());
    const keep = element('button', { class: 'plain' }, texts.keep);
    const form = element('form', {}, labelled(texts.name, this.field), keep, this.forAll);
    this.forAll.addEventListener('click', () => this.keepForAll());
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.keep();
    });
    const title = element('summary', {}, texts.title);
    this.root = element('details', { class: 'help place-list' }, title, above, this.sensorList, this.roomList, this.list, form);
    this.root.append(this.said);
  }

  show(sensors: readonly RoomSensor[], places: readonly Place[], room: RoomPlaces): void {
    this.mayRemove = room.mayRemove;
    this.forAll.hidden = !room.mayMark;
    this.ofRoom.show(room.places);
    this.ofSensors.show([...sensors].sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true })));
    this.own.show(places);
  }

  private keep(): void {
    const name = this.field.value;
    const kept = this.events.keep(name);
    setText(this.said, kept ? texts.kept(name.trim()) : texts.notKept);
    if (kept) this.field.value = '';
  }

  private keepForAll(): void {
    const name = this.field.value;
    const kept = this.events.keepForAll(name);
    setText(this.said, kept ? texts.keptForAll(name.trim()) : texts.notKeptForAll);
    if (kept) this.field.value = '';
  }

  private roomRow(place: Mark): Row<Mark> {
    const go = plain(place.text);
    if (place.author) go.append(element('small', {}, texts.by(place.author)));
    go.addEventListener('click', () => this.events.goToMark(place));
    const remove = element('button', { type: 'button', class: 'plain', 'aria-label': texts.remove(place.text) }, '×');
    remove.addEventListener('click', () => {
      this.field.focus();
      this.events.removeForAll(place);
    });
    return { root: element('li', {}, go, remove), update: (now) => (remove.hidden = !this.mayRemove(now)) };
  }

  private sensorRow({ id }: RoomSensor): Row<RoomSensor> {
    const root = plain('');
    root.addEventListener('click', () => this.events.asSensor(id));
    return { root, update: ({ name }) => setText(root, texts.asSensor(name)) };
  }

  private row({ name }: Place): Row<Place> {
    let place: Place;
    const go = plain(name);
    go.addEventListener('click', () => this.events.goToPlace(place));
    const forget = element('button', { type: 'button', class: 'plain', 'aria-label': texts.forget(name) }, '×');
    forget.addEventListener('click', () => {
      this.field.focus();
      this.events.forget(place);
    });
    return { root: element('li', {}, go, forget), update: (now) => void (place = now) };
  }
}
