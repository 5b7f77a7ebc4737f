// SPDX-License-Identifier: Apache-2.0
// Says on the room whom one follows, or that everybody follows, with a button to stop, and why that has ended.
import { guideTexts } from '../mark_texts';
import { followTexts as texts } from '../texts';
import { element, setText } from './element';

const shown_ms = 8000; // the reason for the end

export class FollowNote {
  private readonly words = element('p', { role: 'status' });
  private readonly stop = element('button', { type: 'button', class: 'plain' }, texts.stop);
  private hides: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly root: HTMLElement,
    stop: () => void,
  ) {
    this.stop.addEventListener('click', stop);
    this.root.append(this.words, this.stop);
    this.show('', false);
  }

  following(name: string): void {
    this.show(texts.following(name), true);
  }

  /** The person shows everybody around. */
  guided(name: string): void {
    this.show(guideTexts.guided(name), true);
  }

  /** This viewer does. */
  guiding(): void {
    this.show(guideTexts.guiding, true);
  }

  /** `sentence` may be empty. */
  ended(sentence: string): void {
    this.show(sentence, false);
    if (sentence) this.hides = setTimeout(() => this.show('', false), shown_ms);
  }

  /** The region stays in the document, so that screen readers announce what comes into it. */
  private show(sentence: string, canStop: boolean): void {
    clearTimeout(this.hides);
    this.root.classList.toggle('empty', sentence === '');
    this.stop.hidden = !canStop;
    setText(this.words, sentence);
  }
}
