// SPDX-License-Identifier: Apache-2.0
// The console's alignment tab: a map of the room, the agreement of each pair of sensors, the origin of each sensor's
// pose, advice for sensors without a pose, and placing a sensor by hand.
import { element } from '../panel/element';
import { KeyedList } from '../panel/keyed_list';
import { NudgeControls, type NudgeEvents } from '../panel/nudge_controls';
import type { RoomSensor } from '../room_roster';
import { consoleTexts as texts } from '../console_texts';
import { svg } from '../panel/svg';
import type { Pair } from './pair_watch';
import { PlaceRow } from './place_row';
import { drawMap, gapGrade, type MapPerson } from './room_map';

export class AlignmentView {
  readonly root = element('div', { class: 'alignment' });
  private readonly map = svg('svg', { class: 'map', role: 'img' });
  private readonly pairs = element('ul', { class: 'pairs' });
  private readonly places = element('ul', { class: 'places' });
  private readonly nudgeNote = element('p', { class: 'note' }, texts.nudgeNeedsAdmin);
  private readonly nudge: NudgeControls;
  private readonly list: KeyedList<RoomSensor, PlaceRow>;
  private entries: readonly RoomSensor[] = [];
  private mayNudge = false;

  constructor(nudge: NudgeEvents) {
    this.nudge = new NudgeControls(nudge);
    const none = element('li', { class: 'empty' }, texts.noSensors);
    this.list = new KeyedList(this.places, ({ id, name }) => `${id} ${name}`, (entry) => this.place(entry), none);
    this.map.addEventListener('click', ({ target }) => this.pressed(target as Element));
    this.root.append(
      this.map,
      element('p', { class: 'note' }, texts.mapHelp),
      element('h3', {}, texts.placesTitle),
      this.places,
      this.nudgeNote,
      element('h3', {}, texts.pairsTitle),
      element('p', { class: 'note' }, texts.pairsHelp),
      this.pairs,
    );
  }

  setMayNudge(may: boolean): void {
    this.mayNudge = may;
    this.nudgeNote.hidden = may;
  }

  show(entries: readonly RoomSensor[], pairs: readonly Pair[], people: readonly MapPerson[] = []): void {
    drawMap(this.map, entries, pairs, people);
    this.showPairs(entries, pairs);
    this.entries = entries;
    this.list.show(entries);
  }

  /** A sensor in the map: its row is shown. */
  private pressed(target: Element): void {
    const id = target.getAttribute('data-sensor');
    if (id === null) return;
    for (const row of this.list.shown) if (String(row.id) === id) row.point();
  }

  private place(entry: RoomSensor): PlaceRow {
    return new PlaceRow(entry, this.nudge, () => this.mayNudge, () => this.list.show(this.entries));
  }

  private showPairs(entries: readonly RoomSensor[], pairs: readonly Pair[]): void {
    const name = (id: number) => entries.find((entry) => entry.id === id)?.name ?? '';
    const items = pairs.map(({ a, b, gap_mm, points }) => {
      const pair = texts.pair(...([name(a), name(b)].sort() as [string, string]));
      const gap = element('span', { class: `gap ${gapGrade(gap_mm)}` }, texts.gap(gap_mm, points));
      return element('li', {}, element('span', {}, pair), gap);
    });
    this.pairs.replaceChildren(...(items.length > 0 ? items : [element('li', { class: 'empty' }, texts.noPairs)]));
  }
}
