// SPDX-License-Identifier: Apache-2.0
// The hub's rooms in the panel, for switching: only rooms that are visible to this user.
import type { HubRoom } from '../console/hub_api';
import { panelTexts as texts } from '../texts';
import { element } from './element';

/** Address of a room: the page's own address with another room and no other option. */
function addressOf(room: string): string {
  return `?room=${encodeURIComponent(room)}`;
}

function item({ name, title, sensors, viewers, view }: HubRoom, current: string | undefined): HTMLElement {
  const link = element('a', { href: addressOf(name) }, title || name);
  if (name === current) link.setAttribute('aria-current', 'page');
  const needsToken = view === 'anyone' ? '' : ` · ${texts.needsToken}`;
  return element('li', {}, link, element('span', { class: 'counts' }, texts.inRoom(sensors, viewers) + needsToken));
}

export class RoomList {
  readonly root = element('ul', { class: 'rooms' });

  /** `current` is undefined when the viewer is in no room. */
  show(rooms: readonly HubRoom[], current: string | undefined): void {
    this.root.replaceChildren(...rooms.map((room) => item(room, current)));
  }
}
