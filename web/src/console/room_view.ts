// SPDX-License-Identifier: Apache-2.0
// The console's room tab: the room's settings, the hub's other rooms, and opening a new room.
import { AskingButton } from '../panel/asking_button';
import { element, setText } from '../panel/element';
import { consoleTexts } from '../console_texts';
import { panelTexts } from '../texts';
import { checkbox, choice, labelled, numberField, submit, textField } from '../panel/form';
import type { HubApi, HubRoom, StartPosition, Who } from './hub_api';
import { StartPlaces, type StartPlacesEvents } from './start_places';

const texts = consoleTexts.room;
const longestName = 64;
const mostViewers = 2048;
const mostSensors = 32;
const mostUplink_mbit = 1000;
const longestSites = 2048; // characters, of all

export class RoomView {
  readonly root = element('div', { class: 'room-settings' });
  private readonly said = element('p', { class: 'note', role: 'status' });
  private readonly form = element('form');
  private readonly rooms = element('ul', { class: 'rooms' });
  private readonly newName = textField(longestName);
  private readonly closing = element('p', { class: 'closing' });
  private readonly starts: StartPlaces;
  private closes = ''; // the room that the button closes

  constructor(
    private readonly api: HubApi,
    private readonly room: () => string,
    here: StartPlacesEvents['here'],
  ) {
    this.starts = new StartPlaces({ here, changed: (places) => void this.trying(() => this.setStarts(places)) });
    const opening = element('form', { class: 'opening' }, labelled(texts.newRoom, this.newName), submit(texts.open));
    opening.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.trying(() => this.open());
    });
    this.root.append(this.form, this.said, this.starts.root, element('h3', {}, texts.rooms), this.rooms, opening, this.closing);
  }

  async refresh(): Promise<void> {
    await this.trying(async () => {
      const room = await this.api.room(this.room());
      this.showSettings(room);
      this.starts.show(room.start_positions ?? []);
      this.offerClosing(room.name);
      this.showRooms(await this.api.rooms());
    });
  }

  private showSettings(room: HubRoom): void {
    const title = textField(longestName, room.title);
    const maxViewers = numberField(1, mostViewers, room.max_viewers);
    const maxSensors = numberField(1, mostSensors, room.max_sensors ?? mostSensors);
    const uplink = numberField(0, mostUplink_mbit, room.uplink_mbit ?? 0);
    uplink.step = 'any';
    const recordVoices = checkbox(room.record_voices ?? false);
    const listed = checkbox(room.listed ?? true);
    const embedFrom = textField(longestSites, room.embed_from?.join(' '));
    const rights = (['view', 'speak', 'mark', 'send', 'record', 'export'] as const).map((right) => ({
      right,
      field: choice<Who>(texts.who, room[right] ?? 'anyone'),
    }));
    this.form.replaceChildren(
      labelled(texts.title, title),
      labelled(texts.maxViewers, maxViewers),
      labelled(texts.maxSensors, maxSensors),
      ...(room.uplink_mbit === undefined ? [] : [labelled(texts.uplink, uplink)]),
      ...rights.map(({ right, field }) => labelled(texts[right], field)),
      labelled(texts.recordVoices, recordVoices, 'field box'),
      labelled(texts.listed, listed, 'field box'),
      labelled(texts.embedFrom, embedFrom, 'field long'),
      submit(texts.save),
    );
    this.form.onsubmit = (event) => {
      event.preventDefault();
      void this.trying(async () => {
        await this.api.changeRoom(this.room(), {
          title: title.value,
          max_viewers: Number(maxViewers.value),
          max_sensors: Number(maxSensors.value),
          listed: listed.checked,
          embed_from: embedFrom.value.split(/[\s,]+/).filter((site) => site !== ''),
          ...(room.uplink_mbit !== undefined && { uplink_mbit: Number(uplink.value) }),
          ...(room.record_voices !== undefined && { record_voices: recordVoices.checked }),
          ...Object.fromEntries(rights.map(({ right, field }) => [right, field.value as Who])),
        });
        setText(this.said, texts.saved);
      });
    };
  }

  private async setStarts(places: StartPosition[]): Promise<void> {
    const { start_positions = [] } = await this.api.changeRoom(this.room(), { start_positions: places });
    this.starts.show(start_positions);
    setText(this.said, texts.starts.changed);
  }

  private offerClosing(name: string): void {
    if (name === this.closes) return;
    this.closes = name;
    const asked = { label: texts.close, question: texts.reallyClose, of: name };
    const button = new AskingButton(asked, () => void this.trying(() => this.api.closeRoom(name)));
    this.closing.replaceChildren(button.root, element('span', { class: 'note' }, texts.closeHelp));
  }

  private async open(): Promise<void> {
    await this.api.openRoom({ name: this.newName.value });
    this.newName.value = '';
    this.showRooms(await this.api.rooms());
  }

  private showRooms(rooms: readonly HubRoom[]): void {
    const items = rooms.map(({ name, title, sensors, viewers }) => {
      const link = element('a', { href: `?room=${encodeURIComponent(name)}` }, title || name);
      if (name === this.room()) link.setAttribute('aria-current', 'page');
      return element('li', {}, link, element('span', { class: 'note' }, panelTexts.inRoom(sensors, viewers)));
    });
    this.rooms.replaceChildren(...items);
  }

  private async trying(what: () => Promise<void>): Promise<void> {
    try {
      await what();
    } catch (error) {
      setText(this.said, consoleTexts.failed((error as Error).message));
    }
  }
}
