// SPDX-License-Identifier: Apache-2.0
// Where this page's viewer stands: the start view, the view that an address holds, and what moves it.
import type { Vector3 } from 'three';
import { hasCredential } from './access';
import { Follow } from './follow';
import type { PageOptions } from './page_options';
import './panel/overlay.css';
import { MoveHint } from './panel/move_hint';
import { watchPointer } from './panel/pointer_kind';
import { WalkStick } from './panel/walk_stick';
import { bodyOf } from './pose_publisher';
import type { RoomState } from './room_state';
import type { RoomRoster } from './room_roster';
import type { Store } from './storage';
import type { Body } from './stream/protocol';
import type { DrawMode } from './view/draw_mode';
import { Pointing } from './pointing';
import { viewAt } from './view/going_there';
import { Navigation } from './view/navigation';
import type { Stage } from './view/stage';
import { fallbackView, placedOrAll, startView } from './view/start_view';
import { viewFromAbove, viewOfSensor } from './view/sensor_view';
import { SurfacePick } from './view/surface_pick';
import { keptFragment, sharedAddress, viewFragment, viewpointOf } from './view/view_address';
import { reachOf } from './view/view_limits';
import { look, viewFromMatrix, type ViewState } from './view/view_state';

export const startDistance_m = 3; // from a pose to the point that its owner looks at

export interface StandpointEvents {
  /** This viewer stands, looks or points elsewhere. */
  changed(): void;
  modeGiven(mode: DrawMode): void;
  /** Another person is followed, or nobody. */
  followChanged(): void;
  guideEnded(): void;
}

function byId(id: string): HTMLElement {
  return document.getElementById(id)!;
}

export class Standpoint {
  readonly navigation: Navigation;
  readonly follow: Follow;
  readonly pick: SurfacePick;
  readonly pointing: Pointing;
  private readonly hint: MoveHint;
  private hubKnewSensors = false; // when this viewer joined, so its start pose is meaningful
  private placed: boolean; // the start view was set, or the user has moved the view
  private opened: ViewState | undefined; // by the address

  constructor(
    private readonly stage: Stage,
    private readonly state: RoomState,
    options: PageOptions,
    tabStore: Store,
    private readonly events: StandpointEvents,
  ) {
    this.opened = options.view;
    this.placed = options.view !== undefined;
    this.navigation = new Navigation(stage.canvas, options.view ?? fallbackView, {
      changed: (view) => this.changed(view),
      moved: () => this.moved(),
      goThere: (x, y) => this.goToPixel(x, y),
      reset: () => this.goToStart(),
    });
    this.pick = new SurfacePick(stage);
    this.pointing = new Pointing(stage, this.pick, () => state.ownColor, () => events.changed());
    this.navigation.hands.pointing = this.pointing;
    this.follow = new Follow(byId('follow'), state, {
      changed: () => events.followChanged(),
      guideEnded: () => events.guideEnded(),
    });
    this.hint = new MoveHint(byId('hint'), tabStore);
    const stick = new WalkStick(byId('stick'), (push) => this.navigation.pushStick(push));
    watchPointer((kind) => {
      this.hint.setKind(kind);
      stick.setShown(kind === 'touch');
    });
    stage.look(this.current);
    window.addEventListener('hashchange', () => this.addressChanged());
  }

  get current(): ViewState {
    return this.navigation.current;
  }

  get body(): Body {
    return { ...bodyOf(this.current), pointer: this.pointing.current };
  }

  set(view: ViewState): void {
    this.navigation.set(view);
  }

  /** With the device. Meanwhile the way to a place, or another person, decides. */
  turn(dYaw: number, dPitch: number): void {
    if (this.follow.whom !== undefined || this.navigation.isGliding) return;
    this.navigation.set(look(this.current, dYaw, dPitch));
  }

  goToStart(): void {
    this.follow.end();
    this.navigation.set(this.navigation.permitted(this.startView));
  }

  /** Where one enters. */
  get startView(): ViewState {
    return this.start() ?? fallbackView;
  }

  /** Smoothly to a place; height and direction stay. */
  goTo(x: number, z: number): void {
    this.goToView({ ...this.current, position: this.current.position.clone().setX(x).setZ(z) });
  }

  /** Smoothly to another view. */
  goToView(view: ViewState): void {
    this.moved();
    this.navigation.glideTo(view);
  }

  goAbove(): void {
    const { clientWidth, clientHeight } = this.stage.canvas;
    const view = viewFromAbove(this.placedPoses, clientWidth / Math.max(1, clientHeight));
    if (view) this.goToView(view);
  }

  goToSensor(id: number): void {
    const sensor = this.state.roster?.sensors.find((entry) => entry.id === id);
    if (sensor) this.goToView(viewOfSensor(sensor.pose));
  }

  private get placedPoses() {
    return placedOrAll((this.state.roster?.sensors ?? []).map(({ pose }) => pose));
  }

  /** Call once per screen refresh. */
  update(now_ms: number): void {
    this.navigation.update(now_ms);
    const view = this.follow.update(this.current, now_ms);
    if (view !== this.current) this.navigation.set(this.navigation.permitted(view));
    this.pointing.update(now_ms);
  }

  /** There is a room to see. */
  offerHint(offered: boolean): void {
    this.hint.offer(offered);
  }

  /** `before` is the roster until now, undefined for the first one. */
  followRoster(roster: RoomRoster, before: RoomRoster | undefined): void {
    if (!before) this.hubKnewSensors = roster.sensors.length > 0;
    const reach = reachOf(placedOrAll(roster.sensors.map(({ pose }) => pose)));
    if (reach) this.navigation.setReach(reach);
    if (this.current === this.opened) this.goToStart(); // it is known now how far from the room that may be
    if (!this.placed && roster.sensors.length > 0) this.goToStart();
    this.follow.rosterChanged();
  }

  /** The address of this room and viewpoint for others. The page's own address holds the viewpoint from then on. */
  share(): string {
    const fragment = viewFragment(this.current, this.stage.room.drawMode);
    history.replaceState(null, '', location.pathname + location.search + fragment);
    return sharedAddress(location, this.state.welcome?.room ?? '', fragment);
  }

  /** The address in this tab has changed after the # only: opens its viewpoint. */
  private addressChanged(): void {
    if (hasCredential(location.hash)) return location.reload(); // as a link with a credential is opened
    const given = viewpointOf(location.hash);
    history.replaceState(null, '', location.pathname + location.search + keptFragment(location.hash));
    if (!given) return;
    this.opened = given.view;
    if (given.mode) this.events.modeGiven(given.mode);
    this.goToStart();
  }

  private moved(): void {
    this.hint.moved();
    this.follow.end();
  }

  /** Smoothly to a point: in front of it, looking at it, or upon it where it is on the floor. */
  goToPoint(point: Vector3): void {
    this.goToView(viewAt(this.current, point));
  }

  /** Smoothly to the surface that is seen at a pixel, or to the floor where no sensor sees anything. */
  private goToPixel(x: number, y: number): void {
    const point = this.pick.at(x, y);
    if (point) this.goToPoint(point);
  }

  private changed(view: ViewState): void {
    this.placed = true;
    this.stage.look(view);
    this.events.changed();
  }

  private start(): ViewState | undefined {
    if (this.opened) return this.opened;
    const pose = this.state.welcome?.startPose ?? [];
    if (this.hubKnewSensors && pose.length === 16) return viewFromMatrix(pose, startDistance_m);
    return startView(this.placedPoses);
  }
}
