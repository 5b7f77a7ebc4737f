// SPDX-License-Identifier: Apache-2.0
// The tools on the room: pointing, notes, sketches, measuring, and the list of what was left; below them what a tool
// says. One tool at most is chosen; a second press on its button ends it.
import { tools, type Tool } from '../marks/tool';
import { toolTexts as texts } from '../mark_texts';
import { element, setText } from './element';
import { toolIcon } from './tool_icons';
import './tool_bar.css';

export interface ToolBarEvents {
  chosen(tool: Tool | undefined): void;
  /** Returns whether the list is open now. */
  list(): Promise<boolean>;
}

export class ToolBar {
  readonly more = element('div', { class: 'more' }); // the form and the list
  private readonly bar = element('div', { class: 'bar', role: 'toolbar', 'aria-label': texts.title, 'aria-orientation': 'vertical' });
  private readonly buttons = new Map<Tool, HTMLButtonElement>();
  private readonly list: HTMLButtonElement;
  private readonly count = element('span', { class: 'count' });
  private readonly said = element('p', { role: 'status' });
  private readonly action = element('button', { type: 'button', class: 'plain', hidden: '' });
  private readonly note = element('div', { class: 'said empty' }, this.said, this.action);
  private run: (() => void) | undefined;
  private current: Tool | undefined;

  constructor(root: HTMLElement, private readonly events: ToolBarEvents) {
    for (const tool of tools) {
      const button = this.button(tool, texts.tools[tool].label, texts.tools[tool].help);
      button.setAttribute('aria-pressed', 'false');
      button.addEventListener('click', () => events.chosen(tool === this.current ? undefined : tool));
      this.buttons.set(tool, button);
    }
    this.list = this.button('list', texts.list, texts.listHelp);
    this.list.append(this.count);
    this.list.setAttribute('aria-expanded', 'false');
    this.list.addEventListener('click', () => void this.toggleList());
    this.action.addEventListener('click', () => this.run?.());
    root.append(element('div', { class: 'side' }, this.note, this.more), this.bar);
  }

  get tool(): Tool | undefined {
    return this.current;
  }

  setTool(tool: Tool | undefined): void {
    this.current = tool;
    this.buttons.forEach((button, of) => button.setAttribute('aria-pressed', String(of === tool)));
    this.say(tool ? texts.tools[tool].help : '');
  }

  /** Whether this viewer may leave marks, and how many there are. */
  setMarks(mayLeave: boolean, count: number): void {
    for (const tool of ['note', 'sketch'] as const) this.buttons.get(tool)!.hidden = !mayLeave;
    this.list.hidden = !mayLeave && count === 0;
    setText(this.count, count > 0 ? ` ${count}` : '');
  }

  /** `action` is offered beside the sentence. */
  say(sentence: string, action?: { label: string; run(): void }): void {
    this.run = action?.run;
    setText(this.action, action?.label ?? '');
    this.action.hidden = !action;
    this.note.classList.toggle('empty', sentence === '');
    setText(this.said, sentence);
  }

  private async toggleList(): Promise<void> {
    this.list.setAttribute('aria-expanded', String(await this.events.list()));
  }

  private button(icon: Tool | 'list', label: string, help: string): HTMLButtonElement {
    const button = element('button', { type: 'button', title: help }, toolIcon(icon), element('span', {}, label));
    this.bar.append(button);
    return button;
  }
}
