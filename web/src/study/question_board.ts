// SPDX-License-Identifier: Apache-2.0
// A questionnaire in the headset: one question at a time on a board, with the answers of the form on the screen. What has
// to be typed in words is typed there.
import type { BoardButton, BoardRow, BoardSheet } from '../xr/board_sheet';
import type { Item } from './study_plan';
import { studyTexts as texts } from './study_texts';

export interface AnswerField {
  value(): number | string; // '': none
  set(value: number | string): void;
}

export interface BoardQuestion {
  item: Item;
  field: AnswerField;
}

const longestNumber = 12; // digits
const erase = '⌫';
const keys = ['123', '456', '789', '-0.'];

export class QuestionBoard {
  private index = 0;
  private trouble = '';
  private readonly drafts = new Map<Item, string>(); // of numbers

  /** `finish` ends the questionnaire, or says the number of the question that is not answered yet. */
  constructor(
    private readonly head: { title: string; intro: string },
    private readonly questions: readonly BoardQuestion[],
    private readonly finish: () => number | undefined,
  ) {}

  get sheet(): BoardSheet {
    const { item } = this.current;
    const intro = this.index === 0 && this.head.intro ? [this.head.intro] : [];
    const words = [...intro, texts.questionOf(this.index + 1, this.questions.length), ...(this.trouble ? [this.trouble] : [])];
    const optional = item.required ? [] : [{ text: texts.optional, buttons: [] }];
    const rows = [{ text: item.text, buttons: [] }, ...optional, ...this.answers(), { buttons: this.ways }];
    return { title: this.head.title, words, rows, press: (id) => this.press(id) };
  }

  private get current(): BoardQuestion {
    return this.questions[this.index]!;
  }

  private get ways(): BoardButton[] {
    const isLast = this.index === this.questions.length - 1;
    const back = this.index > 0 ? [{ id: 'back', text: texts.back }] : [];
    return [...back, { id: 'next', text: isLast ? texts.next : texts.nextQuestion }];
  }

  private answers(): BoardRow[] {
    const { item, field } = this.current;
    const chosen = field.value();
    const option = (value: number | string, text: string) => ({ id: `answer ${value}`, text, isOn: chosen === value });
    switch (item.kind) {
      case 'scale': {
        const { labels, points } = item;
        const isNamed = labels.length === points;
        const numbers = Array.from({ length: points }, (_, i) => option(i + 1, isNamed ? labels[i]! : String(i + 1)));
        const [low, high] = labels;
        const ends = !isNamed && low && high ? [{ text: texts.ends(low, points, high), buttons: [] }] : [];
        return isNamed ? numbers.map((button) => ({ buttons: [button] })) : [...ends, { buttons: numbers }];
      }
      case 'choice':
        return item.choices.map((choice) => ({ buttons: [option(choice, choice)] }));
      case 'number':
        return [
          { text: this.draft || '–', buttons: [] },
          ...keys.map((row) => ({ buttons: [...row].map((key) => ({ id: `key ${key}`, text: key })) })),
          { buttons: [{ id: `key ${erase}`, text: erase }] },
        ];
      case 'text':
        return [{ text: texts.typedOnScreen, buttons: [] }];
    }
  }

  private get draft(): string {
    const { item, field } = this.current;
    return this.drafts.get(item) ?? String(field.value());
  }

  private press(id: string): void {
    const { item, field } = this.current;
    this.trouble = '';
    if (id === 'back') this.index--;
    else if (id === 'next') this.next();
    else if (id.startsWith('key ')) this.type(id.slice(4));
    else if (id.startsWith('answer ')) {
      const text = id.slice(7);
      field.set(item.kind === 'scale' ? Number(text) : text);
    }
  }

  private type(key: string): void {
    const { item, field } = this.current;
    const text = key === erase ? this.draft.slice(0, -1) : this.draft + key;
    if (!/^-?\d*\.?\d*$/.test(text) || text.length > longestNumber) return;
    this.drafts.set(item, text);
    field.set(/\d/.test(text) ? Number(text) : '');
  }

  private next(): void {
    const { item, field } = this.current;
    if (item.required && field.value() === '') this.trouble = texts.missing(1);
    else if (this.index < this.questions.length - 1) this.index++;
    else {
      const missing = this.finish();
      if (missing === undefined) return;
      this.index = missing;
      this.trouble = texts.missing(1);
    }
  }
}
