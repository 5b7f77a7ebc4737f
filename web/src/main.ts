// SPDX-License-Identifier: Apache-2.0
// Wires the page together: worker -> state -> stage and panel; navigation -> stage and hub.
import { parseOptions, socketUrl, type PageOptions } from './page_options';
import { OwnPose } from './own_pose';
import type { Roster } from './gen/control_pb';
import type { NudgeEvents } from './panel/nudge_controls';
import { Panel } from './panel/panel';
import { RoomState } from './room_state';
import { pageTime_ms, type FromWorker, type ViewFrame } from './stream/protocol';
import { RoomLink } from './stream/room_link';
import { TestApi } from './test_api';
import { Navigation } from './view/navigation';
import type { DrawMode } from './view/draw_mode';
import { Stage } from './view/stage';
import { fallbackView, startView } from './view/start_view';
import { alongView, pushed } from './view/nudge';
import { viewFromMatrix, type ViewState } from './view/view_state';

const panelInterval_ms = 250;
const statsInterval_ms = 1000;
const startDistance_m = 3;
const roomForPanel_px = 560; // as in panel.css

class Page {
  private readonly state = new RoomState();
  private readonly panel: Panel;
  private readonly ownPose: OwnPose;
  private readonly link: RoomLink;
  private readonly stage: Stage;
  private readonly navigation: Navigation;
  private readonly guesses = new Map<number, number[]>(); // of a person, by sensor: world_from_depth
  private atHand: ViewFrame[] = []; // given to the stage, not yet drawn
  private setAtHand = 0n;
  private hubKnewSensors = false; // when this viewer joined: the hub's start pose means something
  private placedView = false; // the view is where it should be at first, or where the person went

  constructor(private readonly options: PageOptions) {
    const url = socketUrl(location);
    const root = document.getElementById('panel')!;
    this.panel = new Panel(root, this.state, url.replace(/\/ws$/, ''), {
      modeChosen: (mode) => this.setMode(mode),
      sensorSwitched: (sensor, visible) => this.stage.setVisible(sensor, visible),
      reset: () => this.goToStart(),
      nudge: options.key === '' ? undefined : this.nudgeEvents(),
    });
    this.stage = this.openStage();
    this.ownPose = new OwnPose((head) => this.link.pose(head));
    this.navigation = new Navigation(this.stage.canvas, options.view ?? fallbackView, {
      changed: (view) => this.viewChanged(view),
      reset: () => this.goToStart(),
    });
    this.link = new RoomLink(
      { socketUrl: url, room: options.room, name: options.name, record: options.record, key: options.key },
      (message) => this.receive(message),
    );
    this.begin();
  }

  private nudgeEvents(): NudgeEvents {
    return {
      push: (sensor, right, up, forward, turn) => {
        const entry = this.state.roster?.sensors.find(({ id }) => id === sensor);
        if (!entry) return;
        const push = alongView(right, up, forward, turn, this.navigation.current.yaw);
        this.guesses.set(sensor, pushed(this.guesses.get(sensor) ?? entry.worldFromDepth, push));
        this.showRoster();
      },
      tryIt: (sensor) => {
        const guess = this.guesses.get(sensor);
        if (guess) this.link.nudge(sensor, guess);
      },
      putBack: (sensor) => {
        this.guesses.delete(sensor);
        this.showRoster();
      },
    };
  }

  /** As the hub says, but for sensors that are being moved by hand. */
  private showRoster(): void {
    const { roster } = this.state;
    if (!roster) return;
    const sensors = roster.sensors.map((entry) => {
      const guess = this.guesses.get(entry.id);
      return guess ? { ...entry, worldFromDepth: guess } : entry;
    });
    this.stage.follow({ ...roster, sensors }, this.state.welcome?.viewerId ?? -1);
  }

  private openStage(): Stage {
    const canvas = document.getElementById('room') as HTMLCanvasElement;
    canvas.addEventListener('webglcontextlost', () =>
      this.breakDown('The graphics card has stopped. Load the page again.'),
    );
    try {
      return new Stage(canvas, {
        refresh: (now_ms) => this.refresh(now_ms),
        drawn: (withFrames) => this.drawn(withFrames),
      });
    } catch (error) {
      this.breakDown('This browser cannot draw in 3D (WebGL 2 is missing or switched off).');
      throw error;
    }
  }

  private begin(): void {
    const { stage, state, navigation } = this;
    this.placedView = this.options.view !== undefined;
    stage.look(navigation.current);
    if (this.options.best) stage.ladder.pinToBest();
    this.panel.setOpen(this.options.panelOpen ?? window.innerWidth >= roomForPanel_px);
    this.setMode(this.options.mode);
    setInterval(() => this.panel.refresh(), panelInterval_ms);
    setInterval(() => this.reportStats(), statsInterval_ms);
    window.roomcast = new TestApi({ stage, state, navigation, setMode: (mode) => this.setMode(mode) });
  }

  private receive(message: FromWorker): void {
    switch (message.kind) {
      case 'connection':
        this.state.setConnection(message.state);
        this.stage.setConnected(message.state.phase === 'joined');
        return this.panel.refresh();
      case 'welcome':
        this.state.welcome = message.welcome;
        document.title = `${message.welcome.room || 'room'} · roomcast`;
        return this.ownPose.moved(this.navigation.current);
      case 'roster':
        return this.followRoster(message.roster);
      case 'poses':
        if (this.stage.room.avatars.move(message.poses)) this.stage.touch();
        return;
      case 'frames':
        return this.take(message.setId, message.frames, message.decodedAt_ms);
      case 'status':
        return this.state.setStatus(message.status);
      case 'broken':
        return this.breakDown(message.sentence);
    }
  }

  private followRoster(roster: Roster): void {
    const peopleBefore = this.state.roster?.viewers.length ?? 0;
    if (!this.state.roster) this.hubKnewSensors = roster.sensors.length > 0;
    this.forgetAnswered(roster);
    this.state.roster = roster;
    this.showRoster();
    if (roster.viewers.length > peopleBefore) this.ownPose.moved(this.navigation.current);
    if (!this.placedView && roster.sensors.length > 0) this.goToStart();
    this.panel.rebuild();
  }

  /** The aligner has moved a sensor, or says why it does not: the guess is over. */
  private forgetAnswered(roster: Roster): void {
    for (const before of this.state.roster?.sensors ?? []) {
      const now = roster.sensors.find(({ id }) => id === before.id);
      const same = now?.worldFromDepth.every((number, i) => number === before.worldFromDepth[i]);
      if (!same || now?.placementNote !== before.placementNote) this.guesses.delete(before.id);
    }
  }

  private take(setId: bigint, frames: ViewFrame[], decodedAt_ms: number): void {
    this.state.framesDecoded(frames, decodedAt_ms);
    this.atHand.push(...frames);
    this.setAtHand = setId;
    this.stage.show(frames);
  }

  private drawn(withFrames: boolean): void {
    if (!withFrames) return;
    const frames = this.atHand;
    this.atHand = [];
    this.state.framesShown(this.setAtHand, frames, pageTime_ms());
    this.link.shown(frames);
  }

  private refresh(now_ms: number): void {
    this.navigation?.update(now_ms);
    this.ownPose?.update(now_ms);
  }

  private viewChanged(view: ViewState): void {
    this.placedView = true;
    this.stage.look(view);
    this.ownPose.moved(view);
  }

  private start(): ViewState | undefined {
    if (this.options.view) return this.options.view;
    const pose = this.state.welcome?.startPose ?? [];
    if (this.hubKnewSensors && pose.length === 16) return viewFromMatrix(pose, startDistance_m);
    return startView(this.state.roster?.sensors ?? []);
  }

  private goToStart(): void {
    this.navigation.set(this.start() ?? fallbackView);
  }

  private setMode(mode: DrawMode): void {
    this.stage.setMode(mode);
    this.panel.setMode(this.stage.room.drawMode);
  }

  private reportStats(): void {
    const { state } = this;
    if (state.connection.phase !== 'joined' || state.shownSets === 0) return;
    this.link.stats(state.lastShownSet, state.shownFps, state.latency_ms ?? 0);
  }

  private breakDown(sentence: string): void {
    this.state.broken = sentence;
    this.panel.refresh();
  }
}

new Page(parseOptions(location.search, location.hash));
