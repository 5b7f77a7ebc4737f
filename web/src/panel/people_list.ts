// SPDX-License-Identifier: Apache-2.0
// The people in the panel: name and colour, and a button to see what somebody sees.
import type { ViewerEntry } from '../gen/control_pb';
import { panelTexts as texts, voiceTexts } from '../texts';
import { element, setText } from './element';
import { KeyedList, type Row } from './keyed_list';

interface Person {
  viewer: ViewerEntry;
  isSelf: boolean;
  isFollowed: boolean;
  speaks: boolean;
  isMuted: boolean; // by an admin
}

/** Viewers by their ids. */
export interface ShownVoices {
  speaking: ReadonlySet<number>;
  muted: ReadonlySet<number>;
}

/** Undefined while nobody's volume can be set. */
export type VolumeSlider = (speaker: number, name: string) => HTMLElement | undefined;

export function nameOf({ id, name }: Pick<ViewerEntry, 'id' | 'name'>): string {
  return name || texts.person(id);
}

function recordingOf({ records, recordsVoices }: ViewerEntry): string {
  if (!records) return '';
  return recordsVoices ? voiceTexts.recordsVoices : voiceTexts.records;
}

export class PeopleList {
  readonly root = element('ul', { class: 'people' });
  private readonly list = new KeyedList<Person>(this.root, ({ viewer }) => String(viewer.id), (person) => this.row(person));

  /** `follow` is called with the id of a person whose button was pressed, also to stop. */
  constructor(
    private readonly follow: (viewer: number) => void,
    private readonly volumeSlider: VolumeSlider,
  ) {}

  show(
    viewers: readonly ViewerEntry[],
    self: number | undefined,
    followed: number | undefined,
    { speaking, muted }: ShownVoices,
  ): void {
    const people = viewers.filter(({ relays }) => !relays); // other hubs are not people
    this.list.show(
      people.map((viewer) => {
        const { id } = viewer;
        const voice = { speaks: speaking.has(id), isMuted: muted.has(id) };
        return { viewer, isSelf: id === self, isFollowed: id === followed, ...voice };
      }),
    );
  }

  private row({ viewer: { id } }: Person): Row<Person> {
    const swatch = element('span', { class: 'swatch round', 'aria-hidden': 'true' });
    const name = element('span', { class: 'name' });
    const button = element('button', { type: 'button', class: 'plain follow' }, texts.follow);
    button.addEventListener('click', () => this.follow(id));
    const tag = element('span', { class: 'voice-tag' });
    const root = element('li', {}, swatch, name, tag, button);
    let slider: HTMLElement | undefined;
    const update = ({ viewer, isSelf, isFollowed, speaks, isMuted }: Person) => {
      swatch.style.background = `#${viewer.colorRgb.toString(16).padStart(6, '0')}`;
      setText(name, isSelf ? texts.you(nameOf(viewer)) : nameOf(viewer));
      button.hidden = isSelf || viewer.records; // a recorder stands nowhere
      button.setAttribute('aria-label', texts.followWhom(nameOf(viewer)));
      button.setAttribute('aria-pressed', String(isFollowed));
      setText(tag, isMuted ? voiceTexts.isMuted : speaks ? voiceTexts.speaks : recordingOf(viewer));
      root.classList.toggle('speaks', speaks);
      if (slider || isSelf || viewer.records) return;
      slider = this.volumeSlider(id, nameOf(viewer));
      if (slider) button.before(slider);
    };
    return { root, update };
  }
}
