// SPDX-License-Identifier: Apache-2.0
// Wires the page together: worker -> state -> stage and panel; navigation and headset -> stage and hub.
import './theme.css';
import { accessTo, readAccess, rememberAccess, type Access } from './access';
import { authorKey } from './author_key';
import { HubApi } from './console/hub_api';
import type { ViewerEntry, ViewerPose, Voices, Welcome } from './gen/control_pb';
import type { EmbeddedParts } from './embedding/embedded';
import { dressPage, isFramed, visitStorage } from './embedding/frame';
import { enterHeadset, headsetOf } from './headset_view';
import { LazyModel } from './lazy_model';
import { LazyPlayback } from './lazy_playback';
import { Look } from './look';
import { Marking } from './marking';
import { nudgeEvents } from './nudge_events';
import { ownName, takeName } from './own_name';
import { PosePublisher } from './pose_publisher';
import { parseOptions, socketUrl, type PageOptions } from './page_options';
import type { NudgeEvents } from './panel/nudge_controls';
import { Panel } from './panel/panel';
import { namedPicture } from './panel/picture_name';
import { Progress } from './panel/progress';
import { RoomConsole } from './room_console';
import { RoomPlaces } from './room_places';
import type { RoomRoster } from './room_roster';
import { RoomState } from './room_state';
import { SensorNudges } from './sensor_nudges';
import { Standpoint } from './standpoint';
import { keptIn } from './storage';
import { pageTime_ms, type Body, type FromWorker, type ViewFrame } from './stream/protocol';
import { Sound } from './sound';
import { RoomLink } from './stream/room_link';
import type { StudySeat } from './study/study_seat';
import { TestApi } from './test_api';
import { problemTexts, signInTexts } from './texts';
import type { DrawMode } from './view/draw_mode';
import { darkBackground, lightBackground } from './view/room_scene';
import { Stage } from './view/stage';
import { keptFragment } from './view/view_address';
import { hearingObstacle, soundSupport } from './voice/obstacle';
import type { Headset } from './xr/headset';
import { SheetHolder } from './xr/board_sheet';
import { browsersXr, headsetOffer } from './xr/offer';

const panelInterval_ms = 250;
const statsInterval_ms = 1000;
const anyParticipant = 'participant'; // a number beside an address would be in the hub's log
const roomForPanel = '(min-width: 35.0625em)'; // as in panel.css

class Page {
  readonly state = new RoomState();
  readonly sound: Sound;
  readonly sheets = new SheetHolder();
  readonly hubAddress = socketUrl(location).replace(/\/ws$/, '');
  readonly panel: Panel;
  private readonly progress: Progress;
  private readonly console: RoomConsole;
  readonly api: HubApi;
  private readonly look: Look;
  readonly posePublisher: PosePublisher;
  private readonly link: RoomLink;
  readonly stage: Stage;
  readonly standpoint: Standpoint;
  readonly marking: Marking;
  readonly headset: Headset;
  private readonly playback = new LazyPlayback({
    control: (command) => this.link.playback(command),
    room: () => this.state.welcome?.room ?? '',
    sensors: () => this.state.roster?.sensors.map(({ name }) => name) ?? [],
    sound: () => this.sound.ofRecording,
    self: () => ({ name: ownName(this.options.name, browserStorage.store), head: this.body.head, viewer: this.sound.fellow, token: this.access.token }),
    people: (viewers, poses) => this.joinedBy(viewers, poses),
    failed: () => this.breakDown(problemTexts.noPlayback),
  });
  private readonly model = new LazyModel(() => this);
  private readonly nudges = new SensorNudges();
  private readonly places = new RoomPlaces(browserStorage.store, () => this);
  private company: ViewerEntry[] = []; // who plays the same recording
  private recorded: RoomRoster | undefined; // the roster without them
  private atHand: ViewFrame[] = []; // passed to the stage, not yet drawn
  private setAtHand = 0n;

  constructor(
    readonly options: PageOptions,
    private readonly access: Access,
  ) {
    const name = options.study ? anyParticipant : ownName(options.name, browserStorage.store);
    this.sound = this.makeSound();
    this.panel = new Panel(document.getElementById('panel')!, this.state, this.hubAddress, name, this.sound, {
      modeChosen: (mode) => this.setMode(mode),
      qualityChosen: (quality) => this.stage.choose(quality),
      sensorSwitched: (sensor, visible) => this.stage.setVisible(sensor, visible),
      themeChosen: (theme) => this.look.choose(theme),
      consoleWanted: () => this.console.toggle(),
      tokenGiven: (token) => this.comeBackWith(token),
      named: (text) => this.rename(text),
      follow: (viewer) => !this.headset.isOn && this.standpoint.follow.toggle(viewer),
      goTo: (x, z) => this.standpoint.goTo(x, z),
      places: this.places.events,
      view: {
        reset: () => this.standpoint.goToStart(),
        turn: (dYaw, dPitch) => this.standpoint.turn(dYaw, dPitch),
        share: () => ({ address: this.standpoint.share(), omitsToken: this.access.token !== '' }),
        picture: () => namedPicture(this.stage.snapshot(), this.state.welcome?.room ?? ''),
        guide: (on) => this.link.guide(on),
      },
      headset: {
        enter: (mode) => enterHeadset(this, mode),
        leave: () => void this.headset.leave(),
      },
    });
    this.progress = new Progress(document.getElementById('progress')!, this.state, !options.controls);
    this.api = new HubApi(() => this.access.token);
    this.console = this.makeConsole();
    this.stage = this.openStage();
    this.headset = headsetOf(this.stage, () => this);
    this.look = new Look((isLight) => this.stage.setBackground(isLight ? lightBackground : darkBackground));
    this.posePublisher = new PosePublisher((body) => this.link.pose(body));
    this.standpoint = new Standpoint(this.stage, this.state, options, tabStorage.store, {
      changed: () => this.viewChanged(),
      modeGiven: (mode) => this.setMode(mode),
      followChanged: () => this.panel.setFollowed(this.standpoint.follow.whom),
      guideEnded: () => this.link.guide(false),
    });
    this.marking = new Marking(document.getElementById('tools')!, this, {
      leave: (mark) => this.link.mark(mark),
      remove: (ids) => this.link.removeMarks(ids),
      changed: () => this.places.show(),
    });
    const { room, record, playback } = options;
    this.link = new RoomLink(
      { socketUrl: socketUrl(location), room, record, playback, name, access, hears: hearingObstacle(soundSupport()) === '', authorKey: authorKey(browserStorage.store) },
      (message) => this.receive(message),
    );
    this.begin();
  }

  private makeSound(): Sound {
    const heads = { own: () => this.body.head, of: (speaker: number) => this.state.placeOf(speaker) };
    const parts = { heads, store: browserStorage.store, connectHub: (port: MessagePort) => this.link.connectVoice(port) };
    return new Sound(parts, { loaded: () => this.panel.showPeople() });
  }

  private makeConsole(): RoomConsole {
    const { state, api, hubAddress } = this;
    return new RoomConsole({
      ...{ state, api, hubAddress },
      panel: () => this.panel,
      here: () => this.standpoint.current,
      nudge: () => this.nudgeEvents(),
      hasToken: () => this.access.token !== '',
      saidOtherwise: () => this.refreshWords(),
    });
  }

  private hearVoices(voices: Voices): void {
    this.state.setVoices(voices);
    this.sound.voicesChanged(voices, this.state.welcome?.viewerId);
    this.panel.showPeople();
    if (this.stage.room.avatars.speak(this.state.speaking)) this.stage.touch();
  }

  private nudgeEvents(): NudgeEvents {
    const { state, nudges, standpoint, link } = this;
    return nudgeEvents({ state, nudges, standpoint, link, changed: () => this.showRoster() });
  }

  private showRoster(): void {
    const { roster, welcome } = this.state;
    if (roster) this.stage.follow(this.nudges.applyTo(roster), welcome?.viewerId ?? -1);
  }

  private openStage(): Stage {
    const canvas = document.getElementById('room') as HTMLCanvasElement;
    try {
      return new Stage(canvas, {
        refresh: (now_ms, frame) => this.refresh(now_ms, frame),
        drawn: (withFrames) => this.drawn(withFrames),
        lost: () => this.breakDown(this.state.broken || problemTexts.contextLost),
        restored: () => this.breakDown(this.state.broken === problemTexts.contextLost ? '' : this.state.broken),
      });
    } catch (error) {
      this.breakDown(problemTexts.noWebGl);
      throw error;
    }
  }

  private begin(): void {
    const { stage, state, standpoint, headset, sound } = this;
    dressPage(this.options.controls);
    if (this.options.muted) sound.hearOthers(false);
    if (this.options.place) this.places.goToNamed(this.options.place);
    if (this.options.best) this.panel.quality.set('best');
    stage.choose(this.panel.quality.chosen);
    this.panel.setOpen(this.options.panelOpen ?? (!isFramed() && matchMedia(roomForPanel).matches));
    this.setMode(this.options.mode);
    this.look.apply();
    this.panel.setTheme(this.look.theme);
    setInterval(() => this.refreshWords(), panelInterval_ms);
    setInterval(() => this.reportStats(), statsInterval_ms);
    void headsetOffer(window.isSecureContext, browsersXr()).then((offer) => this.panel.headset.offer(offer));
    const { navigation } = standpoint;
    window.roomcast = new TestApi({ stage, state, navigation, headset, sound, ...this.forTests() });
  }

  private forTests() {
    return { playback: this.playback, setMode: (mode: DrawMode) => this.setMode(mode), marks: () => this.marking.list };
  }

  /** The page for a participant of a study. */
  get forStudy(): StudySeat {
    const { state, stage, link, sound, sheets } = this;
    return {
      ...{ state, stage, link, sound, sheets, store: tabStorage.store, headset: this.panel.headset },
      token: () => this.access.token,
      body: () => this.body,
      mode: () => stage.room.drawMode,
      setMode: (mode) => this.setMode(mode),
    };
  }

  /** The page for another one that shows it in a frame. */
  get forFrame(): EmbeddedParts {
    const { state, sound, standpoint, marking, places } = this;
    return { state, sound, standpoint, marking, places, setMode: (mode) => this.setMode(mode) };
  }

  private receive(message: FromWorker): void {
    switch (message.kind) {
      case 'connection':
        this.state.setConnection(message.state);
        if (message.state.phase !== 'connecting') void this.offerRooms();
        this.stage.setConnected(message.state.phase === 'joined');
        return this.refreshWords();
      case 'welcome':
        return this.welcomed(message.welcome);
      case 'roster':
        return this.followRoster(message.roster);
      case 'poses':
        return this.takePoses(message.poses);
      case 'marks':
        return this.marking.take(message.marks);
      case 'guide':
        this.standpoint.follow.guided(message.viewer);
        return this.panel.setGuide(this.state.welcome?.mayPlace ?? false, this.standpoint.follow.isGuide);
      case 'playback':
        return this.playback.show(message.state);
      case 'unseen':
        message.paused.forEach((sensor) => this.state.unseen.add(sensor));
        return this.stage.clear(message.paused);
      case 'frames':
        return this.take(message.setId, message.frames, message.decodedAt_ms);
      case 'voices':
        return this.hearVoices(message.voices);
      case 'spoken':
        return this.sound.spoken();
      case 'line':
        return this.sound.connected(message.viewer, message.maySpeak);
      case 'status':
        return this.state.setStatus(message.status);
      case 'broken':
        return this.breakDown(message.sentence);
    }
  }

  private welcomed(welcome: Welcome): void {
    this.state.welcome = welcome;
    this.places.enter(welcome.room);
    this.sound.welcomed(welcome.maySpeak);
    this.standpoint.follow.guided(0);
    this.panel.setGuide(welcome.mayPlace, false);
    this.marking.welcomed(welcome);
    document.title = `${welcome.room || 'room'} · roomcast`;
    if (welcome.token) this.access.token = welcome.token;
    if (this.access.token) rememberAccess(this.access, tabStorage.store);
    if (!this.options.playback && !isFramed()) void this.console.offer(welcome.mayPlace);
    this.tellPosePublisher();
  }

  /** Also for users whom the hub refused: they may have meant another room. */
  private async offerRooms(): Promise<void> {
    if (!isFramed()) this.panel.offerRooms(await this.api.rooms().catch(() => []));
  }

  /** Loads the page again with the token. Returns why that is not possible, or nothing. */
  private comeBackWith(token: string): string {
    if (!tabStorage.outlivesPage) return signInTexts.notKept;
    rememberAccess({ room: this.state.welcome?.room ?? this.options.room, code: '', token }, tabStorage.store);
    location.reload();
    return '';
  }

  private rename(text: string): string {
    const name = takeName(text, browserStorage.store);
    if (name) this.link.rename(name);
    return name;
  }

  private joinedBy(viewers: ViewerEntry[], poses: ViewerPose[]): void {
    const isOther = viewers.map(({ id }) => id).join() !== this.company.map(({ id }) => id).join();
    this.company = viewers;
    if (isOther && this.recorded) this.followRoster(this.recorded);
    this.takePoses(poses);
  }

  private takePoses(poses: ViewerPose[]): void {
    poses.forEach((pose) => this.state.poses.set(pose.viewerId, pose));
    if (this.stage.room.avatars.move(poses)) this.stage.touch();
  }

  private followRoster(given: RoomRoster): void {
    this.recorded = given;
    const roster = { ...given, viewers: [...given.viewers, ...this.company] };
    const before = this.state.roster;
    this.nudges.forgetAnswered(before, roster);
    this.state.follow(roster);
    this.showRoster();
    if (roster.viewers.length > (before?.viewers.length ?? 0)) this.tellPosePublisher();
    this.standpoint.followRoster(roster, before);
    this.sound.follow(roster);
    this.panel.rebuild();
    this.places.show();
  }

  private get body(): Body {
    return this.state.body ?? this.standpoint.body;
  }

  private tellPosePublisher(): void {
    this.posePublisher.moved(this.body);
  }

  private take(setId: bigint, frames: ViewFrame[], decodedAt_ms: number): void {
    this.state.framesDecoded(frames, decodedAt_ms);
    this.console.offerFrames(frames, performance.now());
    this.atHand.push(...frames);
    this.setAtHand = setId;
    this.stage.show(frames);
  }

  private drawn(withFrames: boolean): void {
    if (!withFrames) return;
    const frames = this.atHand.splice(0);
    this.state.framesShown(this.setAtHand, frames, pageTime_ms());
    this.link.shown(frames, this.stage.room.drawing);
    this.playback.drawn(frames);
    this.model.drawn();
  }

  private refresh(now_ms: number, frame: XRFrame | undefined): void {
    if (frame) this.headset.update(now_ms, frame);
    else this.standpoint?.update(now_ms);
    this.marking?.update();
    const wantsAll = this.options.record || this.console?.isOpen; // the console shows every sensor
    this.posePublisher?.update(now_ms, wantsAll ? undefined : this.stage.viewAngles);
  }

  private viewChanged(): void {
    if (!this.headset.isOn) this.tellPosePublisher();
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

  private refreshWords(): void {
    if (this.stage) this.panel.showDrawing(this.stage.room.drawing, this.stage.quality);
    this.panel.refresh();
    this.progress.refresh();
    if (this.standpoint) this.panel.showMap(this.standpoint.current);
    this.standpoint?.offerHint(this.state.shownSets > 0);
  }

  /** The page cannot continue; with an empty sentence, it can again. */
  breakDown(sentence: string): void {
    this.state.broken = sentence;
    this.refreshWords();
  }
}

const tabStorage = keptIn(visitStorage);
const browserStorage = keptIn(() => localStorage);
const options = parseOptions(location.search, location.hash);
const access = accessTo(options.room, readAccess(location.hash, tabStorage.store));
if (location.hash !== '') {
  history.replaceState(null, '', location.pathname + location.search + keptFragment(location.hash));
}
const page = new Page(options, access);
if (options.study) {
  const fail = (error: unknown) => page.breakDown(problemTexts.noStudy(String(error)));
  void import('./study/study').then(({ Study }) => new Study(page.forStudy).run()).catch(fail);
}
if (isFramed()) void import('./embedding/embedded').then(({ Embedded }) => new Embedded(page.forFrame).begin());
