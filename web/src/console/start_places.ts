// SPDX-License-Identifier: Apache-2.0
// Where people enter the room, in turn: the places that an admin has chosen by standing there.
import { element, setText } from '../panel/element';
import { consoleTexts } from '../console_texts';
import { direction, type ViewState } from '../view/view_state';
import type { StartPosition } from './hub_api';

const texts = consoleTexts.room.starts;
const most = 64;

function rounded(value: number, digits: number): number {
  return Number(value.toFixed(digits));
}

/** Where this view stands, with its height and direction. */
export function startAt({ position, yaw }: Pick<ViewState, 'position' | 'yaw'>): StartPosition {
  const { x, z } = direction({ yaw, pitch: 0 });
  const yaw_deg = (Math.atan2(-x, -z) * 180) / Math.PI; // within a turn
  const eye_height = Math.min(3, Math.max(0.3, position.y));
  return { x: rounded(position.x, 2), z: rounded(position.z, 2), eye_height: rounded(eye_height, 2), yaw_deg: rounded(yaw_deg, 0) };
}

export interface StartPlacesEvents {
  here(): Pick<ViewState, 'position' | 'yaw'>;
  /** All of them, from now on. */
  changed(places: StartPosition[]): void;
}

export class StartPlaces {
  private readonly list = element('ul', { class: 'starts' });
  private readonly add = element('button', { type: 'button', class: 'plain' }, texts.add);
  private readonly none = element('p', { class: 'note' }, texts.none);
  readonly root = element('section', { class: 'start-places' }, element('h3', {}, texts.title), this.none, this.list, this.add);
  private places: StartPosition[] = [];

  constructor(private readonly events: StartPlacesEvents) {
    this.add.addEventListener('click', () => events.changed([...this.places, startAt(events.here())]));
  }

  show(places: StartPosition[]): void {
    this.places = places;
    this.none.hidden = places.length > 0;
    this.add.disabled = places.length >= most;
    const hadFocus = this.list.contains(document.activeElement);
    this.list.replaceChildren(...places.map((place, i) => this.item(place, i)));
    if (hadFocus) this.add.focus(); // the button is gone
  }

  private item({ x, z, yaw_deg = 0 }: StartPosition, index: number): HTMLElement {
    const words = element('span');
    setText(words, texts.place(index + 1, x, z, yaw_deg));
    const remove = element('button', { type: 'button', class: 'plain', 'aria-label': texts.remove(index + 1) }, '×');
    remove.addEventListener('click', () => this.events.changed(this.places.filter((_, i) => i !== index)));
    return element('li', {}, words, remove);
  }
}
