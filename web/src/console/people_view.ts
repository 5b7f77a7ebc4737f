// SPDX-License-Identifier: Apache-2.0
// The console's people tab: the viewers, their picture quality, and, for admins, a way to remove a viewer.
import type { ViewerEntry } from '../gen/control_pb';
import { element } from '../panel/element';
import { milliseconds, perSecond } from '../panel/format';
import { consoleTexts, panelTexts } from '../texts';
import type { HubViewer } from './hub_api';

const texts = consoleTexts.people;

export type KnownViewer = Pick<HubViewer, 'id'> & Partial<HubViewer>;

export class PeopleView {
  readonly root = element('div', { class: 'people-table' });
  private readonly rows = element('tbody');
  private shown = '';

  constructor(private readonly sendAway: (viewer: number) => void) {
    const heads = [texts.name, texts.fps, texts.latency, texts.dropped].map((text) =>
      element('th', { scope: 'col' }, text),
    );
    const empty = element('td', { class: 'quiet' });
    this.root.append(element('table', {}, element('thead', {}, element('tr', {}, ...heads, empty)), this.rows));
  }

  /** `known`: the data that the hub reports to admins, and the page's data about itself. */
  show(viewers: readonly ViewerEntry[], known: readonly KnownViewer[], self: number | undefined): void {
    const rows = viewers.map(({ id, name }) => {
      const facts = known.find((viewer) => viewer.id === id);
      return { id, name: (name || panelTexts.person(id)) + (id === self ? texts.you : ''), facts };
    });
    const key = JSON.stringify(rows);
    if (key === this.shown) return;
    this.shown = key;
    const made = rows.map(({ id, name, facts }) =>
      element(
        'tr',
        {},
        element('th', { scope: 'row' }, name),
        element('td', {}, facts?.shown_fps === undefined ? '–' : `${perSecond(facts.shown_fps)} fps`),
        element('td', {}, milliseconds(facts?.latency_ms)),
        element('td', {}, facts?.sets_dropped === undefined ? '–' : String(facts.sets_dropped)),
        element('td', {}, facts?.sets_dropped !== undefined && id !== self ? this.wayOut(id, name) : undefined),
      ),
    );
    this.rows.replaceChildren(...made);
  }

  private wayOut(viewer: number, name: string): HTMLElement {
    const button = element(
      'button',
      { type: 'button', class: 'plain', 'aria-label': `${texts.sendAway}: ${name}` },
      texts.sendAway,
    );
    button.addEventListener('click', () => this.sendAway(viewer));
    return button;
  }
}
