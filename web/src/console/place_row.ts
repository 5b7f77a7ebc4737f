// SPDX-License-Identifier: Apache-2.0
// A sensor in the console's alignment tab: where its pose comes from, what is said about it, and the button with which
// it is moved by hand, where that has an effect.
import { element, setText } from '../panel/element';
import type { Row } from '../panel/keyed_list';
import type { NudgeControls } from '../panel/nudge_controls';
import { isDoubtful } from '../panel/placement_tag';
import type { RoomSensor } from '../room_roster';
import { mayBeProposed, type SensorPose } from '../sensor_pose';
import { consoleTexts as texts } from '../console_texts';

function placeOf({ state, source, expectedErrorMm }: SensorPose): string {
  if (state === 'moved') return texts.moved;
  if (state === 'none') return texts.unplaced;
  if (source === 'given') return texts.given;
  if (state === 'unverified') return texts.unverified;
  return texts.placed(expectedErrorMm);
}

function notesOn(pose: SensorPose, mayNudge: boolean): string[] {
  const said = [pose.note];
  if (isDoubtful(pose)) said.push(texts.advice);
  if (mayNudge && !mayBeProposed(pose)) said.push(texts.fixed);
  return said.filter((text) => text !== '');
}

export class PlaceRow implements Row<RoomSensor> {
  readonly root: HTMLElement;
  private readonly place = element('span');
  private readonly button = element('button', { type: 'button', class: 'plain' });
  private readonly notes = element('div');
  private shown = '';

  readonly id: number;

  constructor(
    { id, name }: RoomSensor,
    private readonly nudge: NudgeControls,
    private readonly mayNudge: () => boolean,
    changed: () => void,
  ) {
    const line = element('div', { class: 'line' }, element('strong', {}, name), this.place, this.button);
    this.id = id;
    this.root = element('li', { tabindex: '-1' }, line, this.notes);
    this.button.addEventListener('click', () => {
      const begins = nudge.moving !== id;
      nudge.choose(begins ? id : undefined);
      changed();
      if (begins) nudge.focus();
    });
  }

  /** Shows the row and takes the focus there. */
  point(): void {
    this.root.scrollIntoView({ block: 'nearest' });
    this.root.focus();
  }

  update({ id, pose }: RoomSensor): void {
    const { nudge, root, button } = this;
    const offered = this.mayNudge() && mayBeProposed(pose);
    if (!offered && nudge.moving === id) nudge.choose(undefined);
    const moving = nudge.moving === id;
    setText(this.place, placeOf(pose));
    root.className = isDoubtful(pose) ? 'doubtful' : '';
    button.hidden = !offered;
    button.setAttribute('aria-pressed', String(moving));
    setText(button, moving ? texts.moving : texts.move);
    if (moving && nudge.root.parentElement !== root) root.append(nudge.root);
    this.sayWhy(pose, moving);
  }

  private sayWhy(pose: SensorPose, moving: boolean): void {
    const said = notesOn(pose, this.mayNudge());
    const key = JSON.stringify([pose, said]);
    if (key === this.shown) return;
    this.shown = key;
    this.notes.replaceChildren(...said.map((text) => element('p', { class: 'note' }, text)));
    if (moving) this.nudge.answered();
  }
}
