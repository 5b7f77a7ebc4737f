// SPDX-License-Identifier: Apache-2.0
// The panel next to the room: connection, problems, sensors, figures, people, render modes, headset controls. Parts are
// rebuilt when the roster changes; figures are refreshed a few times a second.
import type { HubRoom } from '../console/hub_api';
import { themes, type Theme } from '../look';
import type { RoomState } from '../room_state';
import type { Place } from '../own_places';
import type { Sound } from '../sound';
import { headsetTexts, mapTexts, panelTexts as texts, signInTexts, viewTexts, voiceTexts } from '../texts';
import { drawModes, type Drawing, type DrawMode } from '../view/draw_mode';
import type { Quality, QualityChoice } from '../view/quality_ladder';
import type { ViewState } from '../view/view_state';
import { element, setText } from './element';
import { labelled, submit, textField } from './form';
import { clockError, megabytes, milliseconds, perSecond } from './format';
import { HeadsetControls, type HeadsetControlEvents } from './headset_controls';
import { MiniMap } from './mini_map';
import { NameForm } from './name_form';
import { PeopleList, type VolumeSlider } from './people_list';
import { PlaceList, type PlaceEvents, type RoomPlaces } from './place_list';
import { problems } from './problems';
import { QualityMenu } from './quality_menu';
import { RadioGroup } from './radio_group';
import { RoomList } from './room_list';
import { SensorList } from './sensor_list';
import { Troubles } from './troubles';
import { ViewTools, type ViewToolEvents } from './view_tools';
import './panel.css';
import './places.css';

const longestToken = 4096;

export interface PanelEvents {
  modeChosen(mode: DrawMode): void;
  qualityChosen(quality: QualityChoice): void;
  themeChosen(theme: Theme): void;
  sensorSwitched(sensor: string, visible: boolean): void;
  consoleWanted(): void;
  /** Returns why the token cannot be used, or nothing. */
  tokenGiven(token: string): string;
  /** Returns the name as far as it can be used; empty if it cannot. */
  named(name: string): string;
  /** The button of this person was pressed. */
  follow(viewer: number): void;
  /** To a place that was clicked on the map: the world's x and z, metres. */
  goTo(x: number, z: number): void;
  places: PlaceEvents;
  view: ViewToolEvents;
  headset: HeadsetControlEvents;
}

interface Figure {
  root: HTMLElement;
  value: HTMLElement;
}

function figure({ label, title }: { label: string; title: string }): Figure {
  const value = element('dd', {}, '–');
  return { root: element('div', { class: 'figure', title }, element('dt', {}, label), value), value };
}

function section(title: string, ...content: Node[]): HTMLElement {
  return element('section', {}, element('h2', {}, title), ...content);
}

export class Panel {
  readonly headset: HeadsetControls;
  private readonly tools: ViewTools;
  private readonly dot = element('span', { class: 'dot', 'aria-hidden': 'true' });
  private readonly title = element('h1', {}, 'roomcast');
  private readonly phase = element('p', { class: 'phase', role: 'status' });
  private readonly console = element('button', { type: 'button', class: 'console', hidden: '' }, signInTexts.console);
  private readonly toggle = element('button', { type: 'button', class: 'toggle', 'aria-controls': 'panel-body' });
  private readonly body = element('div', { id: 'panel-body', class: 'body' });
  private readonly troubles = new Troubles();
  private readonly ways = element('div', { class: 'ways' });
  private readonly again = element('button', { type: 'button', class: 'plain' }, texts.tryAgain);
  private readonly tokenForm = this.makeTokenForm();
  private readonly signIn = element('details', { class: 'help' }, element('summary', {}, texts.running), this.tokenForm);
  readonly quality: QualityMenu;
  private readonly sensors: SensorList;
  private readonly people: PeopleList;
  private readonly name: NameForm;
  private readonly map: MiniMap;
  private readonly placeList: PlaceList;
  private readonly mapSection: HTMLElement;
  private followed: number | undefined;
  private readonly rooms = new RoomList();
  private readonly roomChoice = section(texts.rooms, this.rooms.root);
  private readonly received = figure(texts.received);
  private readonly shown = figure(texts.shown);
  private readonly latency = figure(texts.latency);
  private readonly modes: RadioGroup<DrawMode>;
  private readonly themes: RadioGroup<Theme>;

  constructor(
    private readonly root: HTMLElement,
    private readonly state: RoomState,
    private readonly hubAddress: string,
    ownName: string,
    private readonly sound: Sound,
    private readonly events: PanelEvents,
  ) {
    const volumeSlider: VolumeSlider = (speaker, name) => sound.volumeSlider(speaker, name);
    this.sensors = new SensorList(state, (sensor, visible) => events.sensorSwitched(sensor, visible), volumeSlider);
    this.people = new PeopleList((viewer) => events.follow(viewer), volumeSlider);
    this.name = new NameForm(ownName, (name) => events.named(name));
    this.placeList = new PlaceList(events.places);
    this.map = new MiniMap(state, (x, z) => events.goTo(x, z));
    this.mapSection = section(mapTexts.title, this.map.root, this.placeList.root);
    this.map.root.title = mapTexts.help;
    this.tools = new ViewTools(events.view);
    this.headset = new HeadsetControls(events.headset);
    const modes = drawModes.map((value) => ({ value, ...texts.modes[value] }));
    this.modes = new RadioGroup('mode', texts.drawnAs, modes, (mode) => events.modeChosen(mode));
    this.quality = new QualityMenu((quality) => events.qualityChosen(quality));
    const looks = themes.map((value) => ({ value, label: texts.themes[value] }));
    this.themes = new RadioGroup('theme', texts.theme, looks, (theme) => events.themeChosen(theme));
    this.toggle.addEventListener('click', () => this.setOpen(!this.open));
    this.console.addEventListener('click', () => events.consoleWanted());
    this.fill();
    this.offerRooms([]);
    this.setOpen(true);
    this.refresh();
  }

  get open(): boolean {
    return !this.root.classList.contains('closed');
  }

  setOpen(open: boolean): void {
    this.root.classList.toggle('closed', !open);
    this.body.hidden = !open;
    this.toggle.setAttribute('aria-expanded', String(open));
    this.toggle.setAttribute('aria-label', open ? texts.closePanel : texts.openPanel);
  }

  setMode(mode: DrawMode): void {
    this.modes.show(mode);
  }

  setTheme(theme: Theme): void {
    this.themes.show(theme);
  }

  /** Sets whether this user may open the console. */
  offerConsole(offered: boolean): void {
    this.console.hidden = !offered;
  }

  /** Shows the room list if there is a room other than the current one. */
  offerRooms(rooms: readonly HubRoom[]): void {
    const current = this.state.welcome?.room;
    this.roomChoice.hidden = rooms.every(({ name }) => name === current);
    this.rooms.show(rooms, current);
  }

  focusConsole(): void {
    this.console.focus();
  }

  /** The roster has changed. */
  rebuild(): void {
    this.sensors.rebuild();
    this.showPeople();
    this.refresh();
  }

  /** `followed` is the person whose view this page's goes along with. */
  setFollowed(followed: number | undefined): void {
    this.followed = followed;
    this.showPeople();
  }

  /** The people themselves, or who of them speaks, has changed. */
  showPeople(): void {
    const { state, followed } = this;
    this.people.show(state.roster?.viewers ?? [], state.welcome?.viewerId, followed, state);
    this.name.setHere(Boolean(this.state.welcome?.viewerId)); // nobody is in a recording that is played
  }

  refresh(): void {
    const { state } = this;
    const { connection, status } = state;
    const isTryingAgain = connection.phase === 'connecting' && connection.sentence !== '';
    const phase = state.broken ? 'broken' : isTryingAgain ? 'waiting' : connection.phase;
    const live = phase === 'joined';
    setText(this.title, state.welcome?.room || 'roomcast');
    this.root.dataset.phase = phase;
    setText(this.phase, texts.phases[live && !state.welcome?.viewerId ? 'recorded' : phase]);
    setText(this.received.value, live ? megabytes(state.bytesPerSecond) : '–');
    setText(this.shown.value, live ? perSecond(state.shownFps) : '–');
    const latency = `${milliseconds(state.latency_ms)} ${clockError(status?.clock?.error_ms)}`.trim();
    setText(this.latency.value, live ? latency : '–');
    this.sound.setHere(live);
    this.sensors.refresh();
    this.troubles.show(problems({ ...this.known(), hubAddress: this.hubAddress }, state.roomTime_ms(), Date.now()));
    this.showWays();
  }

  /** `view` is this page's own. */
  showMap(view: ViewState): void {
    this.mapSection.hidden = !this.state.roster?.sensors.length;
    this.map.show(view);
  }

  showPlaces(places: readonly Place[], room: RoomPlaces): void {
    this.placeList.show(this.state.roster?.sensors ?? [], places, room);
  }

  /** `offered`: this viewer may show everybody around; `on`: they do. */
  setGuide(offered: boolean, on: boolean): void {
    this.tools.setGuide(offered, on);
  }

  showDrawing(drawing: Drawing, quality: Quality): void {
    this.quality.show(drawing, quality);
  }

  /** What the user can do about the end of the connection: give a token where one is needed, or try again. */
  private showWays(): void {
    const { broken, connection } = this.state;
    const needsToken = !broken && connection.phase === 'waiting' && connection.needsToken;
    if (needsToken && this.signIn.contains(this.tokenForm)) this.ways.prepend(this.tokenForm);
    if (!needsToken && this.ways.contains(this.tokenForm)) this.signIn.append(this.tokenForm);
    this.again.hidden = !broken && !connection.ended && !connection.reload;
    this.signIn.hidden = needsToken;
    this.ways.hidden = this.again.hidden && !needsToken;
  }

  private fill(): void {
    const names = element('div', { class: 'names' }, this.title, this.phase);
    const figures = element('dl', { class: 'figures' }, this.received.root, this.shown.root, this.latency.root);
    this.body.append(
      figures,
      section(texts.sensors, this.sensors.root),
      section(texts.people, this.people.root, this.name.root),
      section(voiceTexts.title, this.sound.root),
      this.mapSection,
      this.roomChoice,
      section(texts.drawnAs, this.modes.root, this.quality.root),
      section(viewTexts.title, this.tools.root),
      section(headsetTexts.title, this.headset.root),
      section(texts.theme, this.themes.root),
      this.help(),
      this.signIn,
    );
    this.again.addEventListener('click', () => location.reload());
    this.ways.append(this.again);
    const header = element('header', {}, this.dot, names, this.console, this.toggle);
    this.root.append(header, this.troubles.root, this.ways, this.body, this.troubles.announced);
  }

  private known() {
    const { broken, connection, roster, status, consoleProblem, unseen } = this.state;
    return { broken, connection, roster, status, consoleProblem, unseen };
  }

  private help(): HTMLElement {
    const rows = texts.keys.map(([keys, what]) => element('div', {}, element('dt', {}, keys), element('dd', {}, what)));
    const keys = element('dl', { class: 'keys' }, ...rows);
    return element('details', { class: 'help' }, element('summary', {}, texts.moving), keys);
  }

  private makeTokenForm(): HTMLElement {
    const { signIn, signInHelp, enter } = signInTexts;
    const token = textField(longestToken);
    const said = element('p', { role: 'status' });
    const form = element('form', { class: 'token' }, labelled(signIn, token), element('p', {}, signInHelp), submit(enter), said);
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      if (token.value.trim() !== '') setText(said, this.events.tokenGiven(token.value.trim()));
    });
    return form;
  }
}
