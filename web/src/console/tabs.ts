// SPDX-License-Identifier: Apache-2.0
// Tabs per the ARIA authoring practices: arrow keys switch tabs, one panel is shown.
import { element } from '../panel/element';

export interface Tab {
  id: string;
  label: string;
  content: HTMLElement;
}

export class Tabs {
  readonly root = element('div', { class: 'tabs' });
  private readonly list = element('div', { role: 'tablist' });
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private chosen = '';

  constructor(
    private readonly tabs: readonly Tab[],
    private readonly changed: (id: string) => void,
  ) {
    this.root.append(this.list);
    for (const tab of tabs) this.add(tab);
    this.choose(tabs[0]!.id);
  }

  get current(): string {
    return this.chosen;
  }

  setOffered(id: string, offered: boolean): void {
    this.buttons.get(id)!.hidden = !offered;
    if (!offered && this.chosen === id) this.choose(this.tabs[0]!.id);
  }

  choose(id: string): void {
    this.chosen = id;
    for (const { id: each, content } of this.tabs) {
      const button = this.buttons.get(each)!;
      const chosen = each === id;
      button.setAttribute('aria-selected', String(chosen));
      button.tabIndex = chosen ? 0 : -1;
      content.hidden = !chosen;
    }
    this.changed(id);
  }

  private add({ id, label, content }: Tab): void {
    const button = element(
      'button',
      { type: 'button', role: 'tab', id: `tab-${id}`, 'aria-controls': `tabpanel-${id}` },
      label,
    );
    button.addEventListener('click', () => this.choose(id));
    button.addEventListener('keydown', (event) => this.keyDown(event));
    content.id = `tabpanel-${id}`;
    content.setAttribute('role', 'tabpanel');
    content.tabIndex = 0; // it scrolls, and some have no control that could be reached
    content.setAttribute('aria-labelledby', `tab-${id}`);
    this.buttons.set(id, button);
    this.list.append(button);
    this.root.append(content);
  }

  private keyDown(event: KeyboardEvent): void {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.code];
    if (!step) return;
    event.preventDefault();
    const offered = this.tabs.filter(({ id }) => !this.buttons.get(id)!.hidden);
    const now = offered.findIndex(({ id }) => id === this.chosen);
    const next = offered[(now + step + offered.length) % offered.length]!;
    this.choose(next.id);
    this.buttons.get(next.id)!.focus();
  }
}
