// SPDX-License-Identifier: Apache-2.0
// The panel's part for voice: the microphone's button and what is in the way. The voice module with everything else is
// loaded when somebody speaks or wants to speak; nobody else waits for it.
import type { Voices } from './gen/control_pb';
import { element, setText } from './panel/element';
import type { RoomRoster } from './room_roster';
import { voiceTexts as texts } from './texts';
import { fellowOf } from './voice/fellow_speaker';
import { hearingObstacle, soundSupport, speakingObstacle, type Rights } from './voice/obstacle';
import { speakerOf } from './voice/sensor_speaker';
import type { Voice, VoiceParts } from './voice/voice';
import type { VoiceControls } from './voice/voice_controls';

type VoiceModule = typeof import('./voice/voice_module');

export interface SoundEvents {
  /** The volume of people can be set from now on. */
  loaded(): void;
}

export class Sound {
  readonly root = element('div', { class: 'sound' });
  private readonly button = element('button', { type: 'button', class: 'plain microphone' }, texts.microphone);
  private readonly note = element('p', { role: 'status' });
  private readonly support = soundSupport();
  private rights: Rights = { maySpeak: false, isMuted: false };
  private isHere = false;
  private loading: Promise<Voice | undefined> | undefined;
  private module: VoiceModule | undefined;
  private voice: Voice | undefined;
  private controls: VoiceControls | undefined;
  private hasFailed = false;
  private isRecorded = false; // what is said
  private wantsToHear = true;
  private wantsRecording = true;
  private isLive = true;
  fellow = 0; // of a recording: the viewer's ID by which the others who play it know this voice; 0: they hear nothing
  private readonly silenced = new Set<number>(); // by the wearer of a headset; viewers

  constructor(
    private readonly parts: VoiceParts,
    private readonly events: SoundEvents,
  ) {
    this.button.addEventListener('click', () => void this.toggle());
    this.root.append(this.button, this.note);
    this.refresh();
  }

  /** For tests. */
  get figures() {
    const { voice } = this;
    if (!voice) return null;
    const { speakers, context, isOn, isSending } = voice;
    const heard = speakers.ids.map((id) => ({ id, volume: speakers.volumeOf(id), ...speakers.figuresOf(id) }));
    return { context: context.state, isOn, isSending, speakers: heard };
  }

  /** Whether this page is in the room, or only trying to get there. */
  setHere(isHere: boolean): void {
    if (isHere === this.isHere) return;
    this.isHere = isHere;
    this.refresh();
  }

  welcomed(maySpeak: boolean): void {
    this.isHere = true;
    this.rights = { maySpeak, isMuted: false };
    this.tellRights();
  }

  /** Of a recording: to the others who play it, as a viewer of this ID; 0: there is no connection. */
  connected(viewer: number, maySpeak: boolean): void {
    this.isLive = false;
    this.fellow = viewer;
    this.welcomed(maySpeak);
  }

  /** Who speaks and who is muted has changed. */
  voicesChanged({ muted }: Pick<Voices, 'muted'>, self: number | undefined): void {
    const own = this.fellow > 0 ? fellowOf(this.fellow) : self;
    const isMuted = own !== undefined && muted.includes(own);
    if (isMuted === this.rights.isMuted) return;
    this.rights = { ...this.rights, isMuted };
    this.tellRights();
  }

  /** The hub has forwarded audio for which nobody listens yet. */
  spoken(): void {
    if (!this.loading && !hearingObstacle(this.support)) void this.ready();
  }

  follow({ viewers, sensors }: RoomRoster): void {
    this.voice?.follow([...viewers.map(({ id }) => id), ...sensors.map(({ id }) => speakerOf(id))]);
    const isRecorded = this.isLive && viewers.some(({ recordsVoices }) => recordsVoices);
    if (isRecorded === this.isRecorded) return;
    this.isRecorded = isRecorded;
    this.refresh();
  }

  get isOn(): boolean {
    return this.voice?.isOn ?? false;
  }

  get isSending(): boolean {
    return this.voice?.isSending ?? false;
  }

  get hears(): boolean {
    return this.wantsToHear;
  }

  hearOthers(wanted: boolean): void {
    this.wantsToHear = wanted;
    this.voice?.hearOthers(wanted);
  }

  /** Whether this person may speak here. */
  get mayBeHeard(): boolean {
    return this.rights.maySpeak && !this.rights.isMuted;
  }

  isSilenced(viewer: number): boolean {
    return this.silenced.has(viewer);
  }

  /** Not heard here any more, or again; nobody else notices. */
  silence(viewer: number, isSilenced: boolean): void {
    if (isSilenced) this.silenced.add(viewer);
    else this.silenced.delete(viewer);
    this.voice?.speakers.setVolume(viewer, isSilenced ? 0 : 1);
    this.events.loaded();
  }

  /** The microphone. */
  async toggle(): Promise<void> {
    await (await this.ready())?.toggleMicrophone();
  }

  /** Of a recording that is played. */
  readonly ofRecording = {
    hear: (wanted: boolean) => {
      this.wantsRecording = wanted;
      this.voice?.speakers.hearRecording(wanted);
    },
    obstacle: () => hearingObstacle(this.support),
    awaitsGesture: () => this.voice?.awaitsGesture ?? false,
  };

  /** Undefined before the voice module is there. */
  volumeSlider(viewer: number, name: string): HTMLElement | undefined {
    return this.voice && this.module?.volumeSlider(this.voice, viewer, name);
  }

  private ready(): Promise<Voice | undefined> {
    this.loading ??= this.load().catch(() => {
      this.hasFailed = true;
      this.loading = undefined; // the next press tries again
      this.refresh();
      return undefined;
    });
    return this.loading;
  }

  private async load(): Promise<Voice> {
    this.module = await import('./voice/voice_module');
    const voice = await this.module.openVoice(this.parts, {
      changed: () => this.refresh(),
      level: (loudness) => this.controls?.showLevel(loudness),
    });
    this.hasFailed = false;
    this.voice = voice;
    this.controls = this.module.voiceControls(voice);
    this.root.append(this.controls.root);
    voice.setRights(this.rights);
    voice.hearOthers(this.wantsToHear);
    voice.speakers.hearRecording(this.wantsRecording);
    this.silenced.forEach((viewer) => voice.speakers.setVolume(viewer, 0));
    this.events.loaded();
    return voice;
  }

  private tellRights(): void {
    this.voice?.setRights(this.rights);
    this.refresh();
  }

  private refresh(): void {
    const obstacle = speakingObstacle(this.support, this.rights);
    this.button.disabled = this.isHere && obstacle !== '';
    this.button.setAttribute('aria-pressed', String(this.voice?.isOn ?? false));
    this.controls?.refresh();
    setText(this.note, this.sentence(obstacle));
  }

  private sentence(obstacle: string): string {
    const { voice } = this;
    if (this.hasFailed) return texts.notLoaded;
    if (hearingObstacle(this.support)) return obstacle;
    if (!this.isHere) return voice?.isOn ? texts.notConnected : '';
    if (!this.isLive && this.fellow === 0) return texts.alone;
    if (voice?.problem) return voice.problem;
    if (obstacle) return obstacle;
    if (voice?.awaitsGesture) return texts.awaitsGesture;
    if (!voice?.isOn) return texts.off;
    const heard = voice.isSending ? texts.sending : voice.mode === 'push' ? texts.heldBack : texts.waits;
    return this.isRecorded ? `${heard} ${texts.recorded}` : heard;
  }
}
