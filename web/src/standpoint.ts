// SPDX-License-Identifier: Apache-2.0
// Where this page's viewer stands: the start view, the view that an address holds, and what moves it.
import { hasCredential } from './access';
import type { PageOptions } from './page_options';
import { bodyOf } from './pose_publisher';
import type { RoomState } from './room_state';
import type { RoomRoster } from './room_roster';
import type { Body } from './stream/protocol';
import type { DrawMode } from './view/draw_mode';
import { Navigation } from './view/navigation';
import type { Stage } from './view/stage';
import { fallbackView, placedOrAll, startView } from './view/start_view';
import { keptFragment, sharedAddress, viewFragment, viewpointOf } from './view/view_address';
import { viewFromMatrix, type ViewState } from './view/view_state';

export const startDistance_m = 3; // from a pose to the point that its owner looks at

export interface StandpointEvents {
  changed(view: ViewState): void;
  modeGiven(mode: DrawMode): void;
}

export class Standpoint {
  readonly navigation: Navigation;
  private hubKnewSensors = false; // when this viewer joined, so its start pose is meaningful
  private placed: boolean; // the start view was set, or the user has moved the view
  private opened: ViewState | undefined; // by the address

  constructor(
    private readonly stage: Stage,
    private readonly state: RoomState,
    options: PageOptions,
    private readonly events: StandpointEvents,
  ) {
    this.opened = options.view;
    this.placed = options.view !== undefined;
    this.navigation = new Navigation(stage.canvas, options.view ?? fallbackView, {
      changed: (view) => this.changed(view),
      reset: () => this.goToStart(),
    });
    stage.look(this.current);
    window.addEventListener('hashchange', () => this.addressChanged());
  }

  get current(): ViewState {
    return this.navigation.current;
  }

  get body(): Body {
    return bodyOf(this.current);
  }

  set(view: ViewState): void {
    this.navigation.set(view);
  }

  goToStart(): void {
    this.navigation.set(this.start() ?? fallbackView);
  }

  /** `before` is the roster until now, undefined for the first one. */
  followRoster(roster: RoomRoster, before: RoomRoster | undefined): void {
    if (!before) this.hubKnewSensors = roster.sensors.length > 0;
    if (!this.placed && roster.sensors.length > 0) this.goToStart();
  }

  /** The address of this room and viewpoint for others. The page's own address holds the viewpoint from then on. */
  share(): string {
    const fragment = viewFragment(this.current, this.stage.room.drawMode);
    history.replaceState(null, '', location.pathname + location.search + fragment);
    return sharedAddress(location, this.state.welcome?.room ?? '', fragment);
  }

  /** Somebody has opened another address in this tab that differs after the # only. */
  private addressChanged(): void {
    if (hasCredential(location.hash)) return location.reload(); // as a link with a credential is opened
    const given = viewpointOf(location.hash);
    history.replaceState(null, '', location.pathname + location.search + keptFragment(location.hash));
    if (!given) return;
    this.opened = given.view;
    if (given.mode) this.events.modeGiven(given.mode);
    this.goToStart();
  }

  private changed(view: ViewState): void {
    this.placed = true;
    this.stage.look(view);
    this.events.changed(view);
  }

  private start(): ViewState | undefined {
    if (this.opened) return this.opened;
    const pose = this.state.welcome?.startPose ?? [];
    if (this.hubKnewSensors && pose.length === 16) return viewFromMatrix(pose, startDistance_m);
    return startView(placedOrAll((this.state.roster?.sensors ?? []).map(({ pose }) => pose)));
  }
}
