// SPDX-License-Identifier: Apache-2.0
// The console of this page: offered to those whom the hub lets use it, loaded when it is needed.
import type { Console } from './console/console';
import type { HubApi } from './console/hub_api';
import { LazyConsole } from './lazy_console';
import type { NudgeEvents } from './panel/nudge_controls';
import type { Panel } from './panel/panel';
import type { RoomState } from './room_state';
import type { ViewFrame } from './stream/protocol';
import { problemTexts } from './texts';
import type { ViewState } from './view/view_state';

export interface RoomConsoleParts {
  state: RoomState;
  api: HubApi;
  hubAddress: string;
  panel(): Panel;
  here(): ViewState;
  nudge(): NudgeEvents;
  hasToken(): boolean;
  /** What is wrong has changed. */
  saidOtherwise(): void;
}

export class RoomConsole {
  private readonly lazy = new LazyConsole(() => this.load());

  constructor(private readonly parts: RoomConsoleParts) {}

  get isOpen(): boolean {
    return this.lazy.isOpen;
  }

  toggle(): void {
    void this.attempt(this.lazy.toggle());
  }

  /** For users who may place sensors, and for admins: those to whom the hub tells more of its sensors. */
  async offer(mayPlace: boolean): Promise<void> {
    const { state, api, hasToken } = this.parts;
    const room = state.welcome?.room ?? '';
    const isAdmin = hasToken() && (await api.sensors(room).then(() => true, () => false));
    await this.attempt(this.lazy.offer({ mayNudge: mayPlace, isAdmin }));
    this.parts.panel().offerConsole(mayPlace || isAdmin);
  }

  /** Called with frames before they are drawn. */
  offerFrames(frames: readonly ViewFrame[], now_ms: number): void {
    this.lazy.offerFrames(frames, now_ms);
  }

  private async load(): Promise<Console> {
    const { Console } = await import('./console/console');
    const { state, api, hubAddress, panel, here, nudge } = this.parts;
    return new Console(document.getElementById('console')!, state, api, hubAddress, {
      closed: () => panel().focusConsole(),
      here,
      nudge: nudge(),
    });
  }

  private async attempt(done: Promise<void>): Promise<void> {
    this.parts.state.consoleProblem = await done.then(() => '', () => problemTexts.noConsole);
    this.parts.saidOtherwise();
  }
}
