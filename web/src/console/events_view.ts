// SPDX-License-Identifier: Apache-2.0
// The console's events tab: who came and went, who was refused and why, what admins changed.
import { consoleTexts } from '../console_texts';
import { eventTexts as texts } from '../event_texts';
import { element, setText } from '../panel/element';
import { choice, labelled } from '../panel/form';
import { KeyedList, type Row } from '../panel/keyed_list';
import { EventLog, eventsCsv, eventText, type EventFilter, type HubEvent } from './events';
import type { HubApi } from './hub_api';

const mostPages = 8; // at once

export class EventsView {
  readonly root = element('div', { class: 'events' });
  private readonly trouble = element('p', { class: 'trouble', role: 'alert' });
  private readonly rows = element('ul', { class: 'event-list' });
  private readonly empty = element('li', { class: 'empty' }, texts.none);
  private readonly filter = choice<EventFilter>(texts.filters, 'all');
  private readonly list: KeyedList<HubEvent>;
  private readonly log = new EventLog();
  private isAsking = false;

  constructor(
    private readonly api: HubApi,
    private readonly room: () => string,
  ) {
    this.list = new KeyedList(this.rows, ({ id }) => String(id), () => eventRow(), this.empty);
    this.filter.addEventListener('change', () => this.show());
    const tools = element(
      'div',
      { class: 'event-tools' },
      labelled(texts.filter, this.filter),
      this.saveButton(texts.csv, 'csv', 'text/csv', eventsCsv),
      this.saveButton(texts.json, 'json', 'application/json', (events) => JSON.stringify(events, null, 2)),
    );
    this.root.append(tools, this.trouble, this.rows, element('p', { class: 'note' }, texts.kept));
    this.show();
  }

  async refresh(): Promise<void> {
    if (this.isAsking) return;
    this.isAsking = true;
    try {
      await this.fetchNew();
      setText(this.trouble, '');
    } catch (error) {
      setText(this.trouble, consoleTexts.failed((error as Error).message));
    }
    this.isAsking = false;
  }

  private async fetchNew(): Promise<void> {
    for (let page = 0; page < mostPages; page++) {
      const before = this.log.newest;
      const { events, newest } = await this.api.events(this.room(), before);
      this.log.take(events, newest);
      if (events.length > 0 || newest < before) this.show();
      if (this.log.newest >= newest) return;
    }
  }

  private get chosen(): HubEvent[] {
    return this.log.list(this.filter.value as EventFilter);
  }

  private show(): void {
    setText(this.empty, this.filter.value === 'all' ? texts.none : texts.noneOfThese);
    this.list.show(this.chosen);
  }

  private saveButton(text: string, ending: string, type: string, write: (events: HubEvent[]) => string): HTMLElement {
    const button = element('button', { type: 'button', class: 'plain' }, text);
    button.addEventListener('click', () => {
      const href = URL.createObjectURL(new Blob([write(this.chosen.reverse())], { type }));
      element('a', { href, download: `${this.room()}-events.${ending}` }).click();
      setTimeout(() => URL.revokeObjectURL(href), 10_000);
    });
    return button;
  }
}

function eventRow(): Row<HubEvent> {
  const [time, what, where] = [element('time'), element('span', { class: 'what' }), element('span', { class: 'note' })];
  const root = element('li', {}, time, what, where);
  const update = (event: HubEvent) => {
    const at = new Date(1000 * event.at);
    time.dateTime = at.toISOString();
    setText(time, at.toLocaleString('en-GB', { day: 'numeric', month: 'short', hour: '2-digit', minute: '2-digit', second: '2-digit' }));
    setText(what, eventText(event));
    setText(where, event.peer);
    root.classList.toggle('bad', /refused$|sent_away|lost_place/.test(event.kind));
  };
  return { root, update };
}
