// SPDX-License-Identifier: Apache-2.0
// How finely the room is drawn: as finely as this machine can keep up with, or as one chooses; and what that is now. The
// choice is stored in this browser.
import { keptIn } from '../storage';
import { qualityTexts as texts } from '../texts';
import type { Drawing } from '../view/draw_mode';
import { qualityChoices, type Quality, type QualityChoice } from '../view/quality_ladder';
import { drawingFacts } from './drawing_facts';
import { drawingNote } from './drawing_note';
import { element, setText } from './element';
import { choice, labelled } from './form';

const storeKey = 'roomcast.quality';

export class QualityMenu {
  private readonly store = keptIn(() => localStorage).store;
  private readonly menu = choice<QualityChoice>(texts.choices, this.kept());
  private readonly facts = element('p', { class: 'drawing facts' });
  private readonly note = element('p', { class: 'drawing', hidden: '' });
  readonly root = element('div', { class: 'quality' }, labelled(texts.title, this.menu), this.facts, this.note);

  constructor(chosen: (quality: QualityChoice) => void) {
    this.menu.addEventListener('change', () => {
      this.store.setItem(storeKey, this.menu.value);
      chosen(this.chosen);
    });
  }

  get chosen(): QualityChoice {
    return this.menu.value as QualityChoice;
  }

  /** For this page alone. */
  set(quality: QualityChoice): void {
    this.menu.value = quality;
  }

  show(drawing: Drawing, quality: Quality): void {
    setText(this.facts, drawingFacts(drawing, quality));
    setText(this.note, drawingNote(drawing, this.chosen === 'auto'));
    this.note.hidden = this.note.textContent === '';
  }

  private kept(): QualityChoice {
    const kept = this.store.getItem(storeKey);
    return qualityChoices.find((each) => each === kept) ?? 'auto';
  }
}
