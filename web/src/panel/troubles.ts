// SPDX-License-Identifier: Apache-2.0
// The problems on the screen, and the same for screen readers: announced when they change, without the numbers that
// change by the second.
import { element, setText } from './element';
import { panelTexts as texts } from '../texts';
import type { Problem } from './problems';

export class Troubles {
  readonly root = element('ul', { class: 'troubles', 'aria-label': texts.wrong, hidden: '' });
  readonly announced = element('p', { class: 'announced', 'aria-live': 'polite' });
  private counts: HTMLElement[] = [];
  private shown = '';

  show(found: readonly Problem[]): void {
    const key = JSON.stringify(found.map(({ severity, sentence }) => [severity, sentence]));
    if (key !== this.shown) this.rebuild(found);
    this.shown = key;
    found.forEach(({ count }, i) => setText(this.counts[i]!, count ? ` ${count}` : ''));
  }

  private rebuild(found: readonly Problem[]): void {
    this.counts = found.map(() => element('span'));
    this.root.replaceChildren(
      ...found.map(({ severity, sentence }, i) => element('li', { class: severity }, sentence, this.counts[i])),
    );
    this.root.hidden = found.length === 0;
    setText(this.announced, found.map(({ sentence }) => sentence).join(' '));
  }
}
