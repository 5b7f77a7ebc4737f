// SPDX-License-Identifier: Apache-2.0
// The console next to the room, for operators. Data from the socket is shown to every user who may place sensors. Data
// that needs an admin's token comes from the hub's HTTP interface and is offered only when that grants access.
import type { ConsoleRights } from '../lazy_console';
import { element } from '../panel/element';
import type { NudgeEvents } from '../panel/nudge_controls';
import { nameOf } from '../panel/people_list';
import type { RoomSensor } from '../room_roster';
import type { RoomState } from '../room_state';
import type { ViewFrame } from '../stream/protocol';
import type { ViewState } from '../view/view_state';
import { consoleTexts as texts } from '../console_texts';
import { AccessView } from './access_view';
import { AlignmentView } from './alignment_view';
import { EventsView } from './events_view';
import type { HubApi, HubSensor, HubViewer } from './hub_api';
import { PairWatch } from './pair_watch';
import { PeopleView } from './people_view';
import { RecordingView } from './recording_view';
import { RecordingsApi } from './recordings_api';
import { RecordingsView } from './recordings_view';
import type { MapPerson } from './room_map';
import { RoomView } from './room_view';
import { SensorCards } from './sensor_cards';
import { Tabs } from './tabs';
import './chart.css';
import './console.css';
import './room_map.css';
import './room_tab.css';
import './events.css';

const sample_ms = 1000;
const askEvery = 2; // samples
const listEvery = 10; // samples

export interface ConsoleEvents {
  closed(): void;
  /** Where this viewer stands. */
  here(): ViewState;
  nudge: NudgeEvents;
}

export class Console {
  private readonly cards = new SensorCards({
    forget: (sensor) => void this.forget(sensor),
    mute: (sensor, muted) => void this.muteSensor(sensor, muted),
    change: (sensor, wanted) => this.api.changeSensor(this.state.welcome?.room ?? '', sensor, wanted),
  });
  private readonly alignment: AlignmentView;
  private readonly people: PeopleView;
  private readonly access: AccessView;
  private readonly recording: RecordingView;
  private readonly recordings: RecordingsView;
  private readonly settings: RoomView;
  private readonly happened: EventsView;
  private readonly tabs: Tabs;
  private readonly pairs = new PairWatch();
  private readonly close = element('button', { type: 'button', class: 'close', 'aria-label': texts.close }, '×');
  private hubSensors: HubSensor[] = [];
  private hubViewers: HubViewer[] = [];
  private isAdmin = false;
  private samples = 0;

  constructor(
    private readonly root: HTMLElement,
    private readonly state: RoomState,
    private readonly api: HubApi,
    hubAddress: string,
    private readonly events: ConsoleEvents,
  ) {
    const room = () => this.state.welcome?.room ?? '';
    this.alignment = new AlignmentView(events.nudge);
    this.people = new PeopleView({
      sendAway: (viewer) => void this.sendAway(viewer),
      mute: (viewer, muted) => void this.mute(viewer, muted),
    });
    this.access = new AccessView(api, room, hubAddress);
    this.recordings = new RecordingsView(new RecordingsApi(api, room));
    this.recording = new RecordingView(api, room, () => void this.recordings.refresh());
    this.happened = new EventsView(api, room);
    this.settings = new RoomView(api, room, () => events.here());
    this.tabs = new Tabs(this.tabList(), (id) => this.tabChosen(id));
    this.close.addEventListener('click', () => this.setOpen(false));
    root.append(element('header', {}, element('h2', {}, texts.title), this.close), this.recording.root, this.tabs.root);
    root.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || event.defaultPrevented) return;
      event.preventDefault(); // an Escape does one thing
      this.setOpen(false);
    });
    this.setAdmin(false);
    this.setOpen(false);
    setInterval(() => this.sample(), sample_ms);
  }

  get open(): boolean {
    return !this.root.hidden;
  }

  setOpen(open: boolean): void {
    if (this.root.hidden === !open) return;
    this.root.hidden = !open;
    document.body.classList.toggle('console-open', open);
    if (open) {
      this.sample();
      this.tabChosen(this.tabs.current);
      this.close.focus();
    } else {
      this.events.closed();
    }
  }

  setRights({ mayNudge, isAdmin }: ConsoleRights): void {
    this.alignment.setMayNudge(mayNudge);
    this.setAdmin(isAdmin);
  }

  /** Called with frames before they are drawn. */
  offer(frames: readonly ViewFrame[], now_ms: number): void {
    if (!this.open) return;
    this.cards.offer(frames, now_ms);
    this.pairs.offer(frames, now_ms);
  }

  private tabList() {
    return [
      { id: 'sensors', label: texts.tabs.sensors, content: this.cards.root },
      { id: 'alignment', label: texts.tabs.alignment, content: this.alignment.root },
      { id: 'people', label: texts.tabs.people, content: this.people.root },
      { id: 'recordings', label: texts.tabs.recordings, content: this.recordings.root },
      { id: 'events', label: texts.tabs.events, content: this.happened.root },
      { id: 'access', label: texts.tabs.access, content: this.access.root },
      { id: 'room', label: texts.tabs.room, content: this.settings.root },
    ];
  }

  private setAdmin(isAdmin: boolean): void {
    this.isAdmin = isAdmin;
    for (const id of ['recordings', 'events', 'access', 'room']) this.tabs.setOffered(id, isAdmin);
    this.recording.root.hidden = !isAdmin;
  }

  private tabChosen(id: string): void {
    if (!this.isAdmin || !this.open) return;
    if (id === 'recordings') void this.recordings.refresh();
    if (id === 'events') void this.happened.refresh();
    if (id === 'access') void this.access.refresh();
    if (id === 'room') void this.settings.refresh();
  }

  /** Charts continue while the console is closed; the rest is drawn only when it is open. */
  private sample(): void {
    const entries = byName(this.state.roster?.sensors ?? []);
    this.cards.sample(entries, this.state, this.hubSensors);
    if (!this.open) return;
    if (this.isAdmin && this.samples++ % askEvery === 0) {
      void this.ask();
      void this.recording.refresh();
      if (this.tabs.current === 'events') void this.happened.refresh();
    }
    if (this.samples % listEvery === 0 && this.tabs.current === 'recordings') this.tabChosen('recordings');
    this.pairs.step(entries);
    this.alignment.show(entries, this.pairs.pairs, this.peopleInRoom());
    this.showPeople();
  }

  private peopleInRoom(): MapPerson[] {
    return (this.state.roster?.viewers ?? []).flatMap((viewer) => {
      const head = this.state.poses.get(viewer.id)?.head;
      if (!head || viewer.relays || viewer.id === this.state.welcome?.viewerId) return [];
      return [{ x: head.x, z: head.z, color: `#${viewer.colorRgb.toString(16).padStart(6, '0')}`, name: nameOf(viewer) }];
    });
  }

  private showPeople(): void {
    const { roster, welcome, shownFps, latency_ms } = this.state;
    const self = welcome?.viewerId;
    const own = { id: self ?? -1, shown_fps: shownFps, ...(latency_ms !== undefined && { latency_ms }) };
    const known = this.hubViewers.some(({ id }) => id === self) ? this.hubViewers : [...this.hubViewers, own];
    this.people.show(roster?.viewers ?? [], known, self);
  }

  private async ask(): Promise<void> {
    const room = this.state.welcome?.room ?? '';
    const [sensors, viewers] = await Promise.all([this.api.sensors(room), this.api.viewers(room)]).catch(() => [
      [],
      [],
    ]);
    this.hubSensors = sensors;
    this.hubViewers = viewers;
  }

  private async forget(sensor: string): Promise<void> {
    await this.api.forgetSensor(this.state.welcome?.room ?? '', sensor).catch(() => undefined);
    await this.ask();
  }

  private async muteSensor(sensor: string, muted: boolean): Promise<void> {
    await this.api.muteSensor(this.state.welcome?.room ?? '', sensor, muted).catch(() => undefined);
    await this.ask();
  }

  private async mute(viewer: number, muted: boolean): Promise<void> {
    await this.api.mute(this.state.welcome?.room ?? '', viewer, muted).catch(() => undefined);
    await this.ask();
  }

  private async sendAway(viewer: number): Promise<void> {
    await this.api.sendAway(this.state.welcome?.room ?? '', viewer).catch(() => undefined);
    await this.ask();
  }
}

function byName(entries: readonly RoomSensor[]): RoomSensor[] {
  return [...entries].sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true }));
}
