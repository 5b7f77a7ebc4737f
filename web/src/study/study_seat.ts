// SPDX-License-Identifier: Apache-2.0
// What a study does with the page, and asks of it.
import type { HeadsetControls } from '../panel/headset_controls';
import type { RoomState } from '../room_state';
import type { Sound } from '../sound';
import type { Store } from '../storage';
import type { Body } from '../stream/protocol';
import type { RoomLink } from '../stream/room_link';
import type { DrawMode } from '../view/draw_mode';
import type { SheetHolder } from '../xr/board_sheet';
import type { Stage } from '../view/stage';

export interface StudySeat {
  state: RoomState;
  stage: Pick<Stage, 'setVisible' | 'isVisible'>;
  link: Pick<RoomLink, 'handicap'>;
  sound: Pick<Sound, 'toggle' | 'hearOthers' | 'isSending' | 'isOn'>;
  headset: Pick<HeadsetControls, 'offersVr' | 'enterVr'>;
  sheets: SheetHolder; // what the wearer of a headset is told
  store: Store; // of this tab
  token(): string;
  body(): Body;
  mode(): DrawMode;
  setMode(mode: DrawMode): void;
}
