// SPDX-License-Identifier: Apache-2.0
// The console's alignment tab: a map of the room, the agreement of each pair of sensors, the origin of each sensor's
// pose, advice for sensors without a pose, and placing a sensor by hand.
import { element, setText } from '../panel/element';
import { NudgeControls, type NudgeEvents } from '../panel/nudge_controls';
import { isDoubtful } from '../panel/placement_tag';
import type { RoomSensor } from '../room_roster';
import type { SensorPose } from '../sensor_pose';
import { consoleTexts as texts } from '../texts';
import { svg } from '../panel/svg';
import type { Pair } from './pair_watch';
import { drawMap, gapGrade } from './room_map';

function placeOf({ state, source, expectedErrorMm }: SensorPose): string {
  if (state === 'moved') return texts.moved;
  if (state === 'none') return texts.unplaced;
  if (source === 'given') return texts.given;
  if (state === 'unverified') return texts.unverified;
  return texts.placed(expectedErrorMm);
}

export class AlignmentView {
  readonly root = element('div', { class: 'alignment' });
  private readonly map = svg('svg', { class: 'map', role: 'img' });
  private readonly pairs = element('ul', { class: 'pairs' });
  private readonly places = element('ul', { class: 'places' });
  private readonly nudgeNote = element('p', { class: 'note' }, texts.nudgeNeedsAdmin);
  private readonly nudge: NudgeControls;
  private mayNudge = false;
  private shown = '';

  constructor(nudge: NudgeEvents) {
    this.nudge = new NudgeControls(nudge);
    this.root.append(
      this.map,
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
    this.shown = '';
  }

  show(entries: readonly RoomSensor[], pairs: readonly Pair[]): void {
    drawMap(this.map, entries, pairs);
    this.showPairs(entries, pairs);
    const facts = entries.map((entry) => [entry.id, entry.name, placeOf(entry.pose), entry.pose.note, entry.online]);
    const key = JSON.stringify([facts, this.nudge.moving]);
    if (key === this.shown) return;
    this.shown = key;
    const items = entries.map((entry) => this.place(entry, () => this.show(entries, pairs)));
    this.places.replaceChildren(...(items.length > 0 ? items : [element('li', { class: 'empty' }, texts.noSensors)]));
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

  private place(entry: RoomSensor, again: () => void): HTMLElement {
    const moving = this.nudge.moving === entry.id;
    const line = element(
      'div',
      { class: 'line' },
      element('strong', {}, entry.name),
      element('span', {}, placeOf(entry.pose)),
    );
    if (this.mayNudge) {
      const button = element('button', { type: 'button', class: 'plain', 'aria-pressed': String(moving) });
      setText(button, moving ? texts.moving : texts.move);
      button.addEventListener('click', () => {
        this.nudge.choose(moving ? undefined : entry.id);
        again();
      });
      line.append(button);
    }
    const said = isDoubtful(entry.pose) ? [entry.pose.note, texts.advice] : [entry.pose.note];
    const notes = said.filter((text) => text !== '').map((text) => element('p', { class: 'note' }, text));
    const item = element('li', { class: isDoubtful(entry.pose) ? 'doubtful' : '' }, line, ...notes);
    if (moving) item.append(this.nudge.root);
    return item;
  }
}
