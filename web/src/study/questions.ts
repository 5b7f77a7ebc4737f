// SPDX-License-Identifier: Apache-2.0
// A questionnaire as a form. Items are the researcher's; what is required must be answered before it goes on.
import { element, setText } from '../panel/element';
import { submit } from '../panel/form';
import type { Item, Questionnaire } from './study_plan';
import { QuestionBoard } from './question_board';
import { studyTexts as texts } from './study_texts';

const mostColumns = 11; // of a scale, beside each other on a phone
const longestText = 1600; // characters; the hub takes 5000 bytes

export interface Answer {
  item: string;
  value: number | string; // '': left out
}

interface Field {
  root: HTMLElement;
  value(): number | string;
  set(value: number | string): void; // '': none
  focus(): void;
}

export class Questions {
  readonly root = element('form', { class: 'questions', novalidate: '' });
  private readonly fields: { item: Item; field: Field }[];
  /** The same in a headset. */
  readonly board: QuestionBoard;
  private readonly trouble = element('p', { class: 'trouble', role: 'alert' });

  constructor(
    { title, intro, items }: Questionnaire,
    private readonly done: (answers: Answer[]) => void,
  ) {
    const head = { title: title || texts.questions, intro };
    this.fields = items.map((item, i) => ({ item, field: fieldFor(item, `item-${i}`) }));
    const words = intro ? [element('p', { class: 'words' }, intro)] : [];
    this.board = new QuestionBoard(head, this.fields, () => this.finish());
    this.root.append(element('h2', {}, head.title), ...words, ...this.fields.map(({ field }) => field.root), this.trouble, submit(texts.next));
    this.root.addEventListener('submit', (event) => {
      event.preventDefault();
      this.finish();
    });
  }

  /** The number of the topmost question that has no answer; undefined: it has ended. */
  private finish(): number | undefined {
    const missing = this.fields.filter(({ item, field }) => item.required && field.value() === '');
    this.fields.forEach(({ item, field }) => field.root.classList.toggle('missing', item.required && field.value() === ''));
    setText(this.trouble, missing.length > 0 ? texts.missing(missing.length) : '');
    if (missing[0]) {
      missing[0].field.focus();
      return this.fields.indexOf(missing[0]);
    }
    this.done(this.fields.map(({ item, field }) => ({ item: item.name, value: field.value() })));
    return undefined;
  }
}

function fieldFor(item: Item, id: string): Field {
  switch (item.kind) {
    case 'scale':
      return radios(item, id, scaleValues(item), item.labels.length === item.points ? 'options' : 'scale');
    case 'choice':
      return radios(item, id, item.choices.map((choice) => ({ value: choice, text: choice })), 'options');
    case 'number':
      return typed(item, id, element('input', { type: 'number', step: 'any' }), (text) => (text === '' ? '' : Number(text)));
    case 'text':
      return typed(item, id, element('textarea', { rows: '4', maxlength: String(longestText) }), (text) => text);
  }
}

interface Choice {
  value: number | string;
  text: string;
}

function scaleValues({ points, labels }: Item): Choice[] {
  return Array.from({ length: points }, (_, i) => {
    const text = labels.length === points ? labels[i]! : String(i + 1);
    return { value: i + 1, text };
  });
}

/** A group of which one is chosen. Labels of the ends of a scale stand beside it. */
function radios(item: Item, id: string, values: Choice[], className: string): Field {
  const { text, labels, points, required } = item;
  const inputs = values.map(({ value }) => ({ value, input: element('input', { type: 'radio', name: id, value: String(value) }) }));
  const [low, high] = className === 'scale' ? labels : [];
  const options = inputs.map(({ input }, i) => {
    const isEnd = (i === 0 && low) || (i === inputs.length - 1 && high);
    if (isEnd) input.setAttribute('aria-label', `${values[i]!.text}: ${isEnd}`);
    return element('label', {}, input, element('span', {}, values[i]!.text));
  });
  const row = element('div', { class: className }, ...options);
  row.style.setProperty('--columns', String(Math.min(points, mostColumns)));
  const ends = low && high ? [element('div', { class: 'ends', 'aria-hidden': 'true' }, element('span', {}, low), element('span', {}, high))] : [];
  const root = element('fieldset', {}, element('legend', {}, text), ...optionalNote(required), row, ...ends);
  return {
    root,
    value: () => inputs.find(({ input }) => input.checked)?.value ?? '',
    set: (chosen) => inputs.forEach(({ value, input }) => (input.checked = value === chosen)),
    focus: () => inputs[0]!.input.focus(),
  };
}

function typed(
  { text, required }: Item,
  id: string,
  input: HTMLInputElement | HTMLTextAreaElement,
  read: (text: string) => number | string,
): Field {
  input.id = id;
  const root = element('div', { class: 'typed' }, element('label', { for: id }, text), ...optionalNote(required), input);
  return {
    root,
    value: () => read(input.value.trim()),
    set: (value) => (input.value = String(value)),
    focus: () => input.focus(),
  };
}

function optionalNote(isRequired: boolean): HTMLElement[] {
  return isRequired ? [] : [element('span', { class: 'note' }, texts.optional)];
}
