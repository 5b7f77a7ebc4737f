// SPDX-License-Identifier: Apache-2.0
// The room's model is asked for, and what decodes it loaded, once the room is shown: the live picture comes first. A
// recording that is played has none.
import type { HubApi } from './console/hub_api';
import type { PageOptions } from './page_options';
import type { RoomState } from './room_state';
import type { Stage } from './view/stage';

const afterFirstPicture_ms = 1500;

export interface ModelledPage {
  readonly api: HubApi;
  readonly options: PageOptions;
  readonly stage: Stage;
  readonly state: RoomState;
}

export class LazyModel {
  private isAsked = false;

  constructor(private readonly page: () => ModelledPage) {}

  /** Frames have been drawn. */
  drawn(): void {
    const { options } = this.page();
    if (this.isAsked || options.playback) return;
    this.isAsked = true;
    setTimeout(() => void this.begin().catch(() => undefined), afterFirstPicture_ms); // the picture is whole without it
  }

  private async begin(): Promise<void> {
    const { ModelFollower } = await import('./model/model_follower');
    const { api, stage, state } = this.page();
    new ModelFollower({
      changesAfter: (version) => api.roomModel(state.welcome?.room ?? '', version),
      show: (model) => stage.showModel(model),
    });
  }
}
