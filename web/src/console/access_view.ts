// SPDX-License-Identifier: Apache-2.0
// The console's access tab: makes links and tokens, shows each of them once as text and as a QR code, lists and revokes
// them.
import { AskingButton } from '../panel/asking_button';
import { element, setText } from '../panel/element';
import { checkbox, choice, labelled, submit, textField } from '../panel/form';
import { KeyedList } from '../panel/keyed_list';
import { consoleTexts } from '../console_texts';
import type { HubApi, HubToken, NewToken, Role } from './hub_api';
import { qrCode } from './qr_code';

const texts = consoleTexts.access;
const longestName = 64;

export class AccessView {
  readonly root = element('div', { class: 'access' });
  private readonly role = choice<Role>(texts.roles, 'viewer');
  private readonly name = textField(longestName);
  private readonly span = choice<string>(texts.spans, '28800');
  private readonly once = checkbox(true);
  private readonly made = element('div', { class: 'made', 'aria-live': 'polite' });
  private readonly trouble = element('p', { class: 'trouble', role: 'alert' });
  private readonly list = element('ul', { class: 'tokens' });
  private readonly tokens = new KeyedList<HubToken>(
    this.list,
    ({ id, revoked, once }) => `${id} ${revoked} ${once}`,
    (token) => ({ root: this.item(token), update: () => undefined }),
    element('li', { class: 'empty' }, texts.none),
  );

  constructor(
    private readonly api: HubApi,
    private readonly room: () => string,
    private readonly hubAddress: string,
  ) {
    const form = element(
      'form',
      {},
      element('p', { class: 'note' }, texts.intro),
      labelled(texts.role, this.role),
      labelled(texts.name, this.name),
      labelled(texts.span, this.span),
      labelled(texts.once, this.once, 'field box'),
      submit(texts.make),
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.make();
    });
    this.root.append(form, this.trouble, this.made, element('h3', {}, texts.listTitle), this.list);
  }

  async refresh(): Promise<void> {
    await this.trying(async () => this.showList(await this.api.tokens()));
  }

  private async make(): Promise<void> {
    const request = {
      room: this.room(),
      role: this.role.value as Role,
      ...(this.name.value && { name: this.name.value }),
      ttl_s: Number(this.span.value),
      once: this.once.checked,
    };
    await this.trying(async () => {
      this.showMade(await this.api.makeToken(request), request.role);
      this.showList(await this.api.tokens());
    });
  }

  private async trying(what: () => Promise<void>): Promise<void> {
    try {
      await what();
      setText(this.trouble, '');
    } catch (error) {
      setText(this.trouble, consoleTexts.failed((error as Error).message));
    }
  }

  private showMade({ token, fragment }: NewToken, role: Role): void {
    const shown: (Node | undefined)[] = [];
    const link = fragment && `${location.origin}${location.pathname}${fragment}`;
    const command = `roomcast sensor --source sim --hub ${this.hubAddress} --room ${this.room()} --token ${token}`;
    const isForPage = role === 'viewer' || role === 'admin';
    if (link && isForPage) shown.push(qrCode(link, texts.qr), this.copyable(texts.link, link));
    else if (fragment) shown.push(this.copyable(texts.link, fragment));
    if (token) shown.push(this.copyable(texts.token, token));
    if (token && role === 'sensor') shown.push(this.copyable(texts.command, command));
    this.made.replaceChildren(
      ...shown.filter((node) => node !== undefined),
      element('p', { class: 'note' }, texts.shownOnce),
    );
  }

  private copyable(label: string, text: string): HTMLElement {
    const field = textField(text.length, text);
    field.readOnly = true;
    const copy = element('button', { type: 'button', class: 'plain' }, texts.copy);
    copy.addEventListener('click', () => {
      field.select();
      void navigator.clipboard?.writeText(text).then(() => setText(copy, texts.copied));
    });
    return element('div', { class: 'copyable' }, labelled(label, field), copy);
  }

  private showList(tokens: readonly HubToken[]): void {
    this.tokens.show(tokens.filter(({ room }) => room === this.room() || room === '*'));
  }

  private item({ id, role, name, expires_at, revoked, once }: HubToken): HTMLElement {
    const until = new Date(1000 * expires_at).toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'short' });
    const what = [name, texts.roles[role], once ? texts.unusedLink : undefined, revoked ? texts.revoked : texts.until(until)].filter(Boolean).join(' · ');
    const item = element('li', { class: revoked ? 'gone' : '' }, element('span', {}, what));
    if (revoked) return item;
    const asked = { label: texts.revoke, question: texts.reallyRevoke, of: name || role };
    const button = new AskingButton(asked, () =>
      void this.trying(async () => {
        await this.api.revoke(id);
        this.showList(await this.api.tokens());
      }));
    item.append(button.root);
    return item;
  }
}
