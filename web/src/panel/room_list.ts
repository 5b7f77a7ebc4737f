// SPDX-License-Identifier: Apache-2.0
// The hub's rooms in the panel, for switching: only rooms that are visible to this user.
import type { HubRoom } from '../console/hub_api';
import { panelTexts as texts } from '../texts';
import { element, setText } from './element';
import { KeyedList, type Row } from './keyed_list';

/** Address of a room: the page's own address with another room and no other option. */
function addressOf(room: string): string {
  return `?room=${encodeURIComponent(room)}`;
}

interface Entry {
  room: HubRoom;
  isHere: boolean;
}

function row({ room: { name } }: Entry): Row<Entry> {
  const link = element('a', { href: addressOf(name) });
  const counts = element('span', { class: 'counts' });
  const update = ({ room: { title, sensors, viewers, view }, isHere }: Entry) => {
    setText(link, title || name);
    if (isHere) link.setAttribute('aria-current', 'page');
    else link.removeAttribute('aria-current');
    setText(counts, texts.inRoom(sensors, viewers) + (view === 'anyone' ? '' : ` · ${texts.needsToken}`));
  };
  return { root: element('li', {}, link, counts), update };
}

export class RoomList {
  readonly root = element('ul', { class: 'rooms' });
  private readonly list = new KeyedList<Entry>(this.root, ({ room }) => room.name, row);

  /** `current` is undefined when the viewer is in no room. */
  show(rooms: readonly HubRoom[], current: string | undefined): void {
    this.list.show(rooms.map((room) => ({ room, isHere: room.name === current })));
  }
}
