// SPDX-License-Identifier: Apache-2.0
// The console's people tab: the viewers, their picture quality, and, for admins, a way to remove a viewer.
import type { ViewerEntry } from '../gen/control_pb';
import { AskingButton } from '../panel/asking_button';
import { element, setText } from '../panel/element';
import { milliseconds, perSecond } from '../panel/format';
import { KeyedList, type Row } from '../panel/keyed_list';
import { consoleTexts } from '../console_texts';
import { panelTexts } from '../texts';
import type { HubViewer } from './hub_api';

const texts = consoleTexts.people;

export type KnownViewer = Pick<HubViewer, 'id'> & Partial<HubViewer>;

interface Person {
  id: number;
  name: string;
  isSelf: boolean;
  facts: KnownViewer | undefined;
}

export interface PeopleEvents {
  sendAway(viewer: number): void;
  mute(viewer: number, muted: boolean): void;
}

export class PeopleView {
  readonly root = element('div', { class: 'people-table' });
  private readonly rows = element('tbody');
  private readonly list: KeyedList<Person>;

  constructor(private readonly events: PeopleEvents) {
    const heads = [texts.name, texts.fps, texts.latency, texts.dropped].map((text) =>
      element('th', { scope: 'col' }, text),
    );
    const empty = element('td', { class: 'quiet' });
    this.root.append(element('table', {}, element('thead', {}, element('tr', {}, ...heads, empty)), this.rows));
    this.list = new KeyedList(this.rows, ({ id }) => String(id), (person) => this.row(person));
  }

  /** `viewers`: in the room; who plays a recording of it is added. `known`: the data that the hub reports to admins, and the page's data about itself. */
  show(viewers: readonly ViewerEntry[], known: readonly KnownViewer[], self: number | undefined): void {
    const players = known.flatMap(({ id, name = '', plays }) =>
      plays === undefined ? [] : [{ id, name: texts.plays(name || panelTexts.person(id), plays) }],
    );
    const people = [...viewers, ...players].map(({ id, name }) => {
      const isSelf = id === self;
      const facts = known.find((viewer) => viewer.id === id);
      return { id, name: (name || panelTexts.person(id)) + (isSelf ? texts.you : ''), isSelf, facts };
    });
    this.list.show(people);
  }

  private row({ id, name: first }: Person): Row<Person> {
    const name = element('th', { scope: 'row' });
    const [fps, latency, dropped] = [element('td'), element('td'), element('td')];
    const wayOut = this.wayOut(id, first);
    const mute = this.mute(id, first);
    const root = element('tr', {}, name, fps, latency, dropped, element('td', {}, mute, wayOut));
    const update = (person: Person) => {
      const { shown_fps, latency_ms, sets_dropped } = person.facts ?? {};
      setText(name, person.name);
      setText(fps, shown_fps === undefined ? '–' : `${perSecond(shown_fps)} fps`);
      setText(latency, milliseconds(latency_ms));
      setText(dropped, sets_dropped === undefined ? '–' : String(sets_dropped));
      wayOut.hidden = sets_dropped === undefined || person.isSelf;
      mute.hidden = wayOut.hidden || !person.facts?.may_speak;
      mute.setAttribute('aria-pressed', String(person.facts?.muted ?? false));
    };
    return { root, update };
  }

  private wayOut(viewer: number, name: string): HTMLElement {
    const asked = { label: texts.sendAway, question: texts.reallySendAway, of: name };
    return new AskingButton(asked, () => this.events.sendAway(viewer)).root;
  }

  /** A switch: pressed while the person is muted. */
  private mute(viewer: number, name: string): HTMLElement {
    const button = element(
      'button',
      { type: 'button', class: 'plain mute', 'aria-label': `${texts.mute}: ${name}`, 'aria-pressed': 'false' },
      texts.mute,
    );
    button.addEventListener('click', () => this.events.mute(viewer, button.getAttribute('aria-pressed') !== 'true'));
    return button;
  }
}
