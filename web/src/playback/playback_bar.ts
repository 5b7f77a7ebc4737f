// SPDX-License-Identifier: Apache-2.0
// The controls of a recording that is played: a timeline to seek in, pause, speed, repeat. The space bar pauses, too, while
// the room has the keyboard.
import './playback.css';
import { element, setText } from '../panel/element';
import { checkbox, choice, labelled } from '../panel/form';
import { duration } from '../panel/format';
import { playbackTexts as texts } from '../recording_texts';
import type { PlaybackCommand, PlaybackState, ViewFrame } from '../stream/protocol';
import { KeyFramePainter } from './key_frame_painter';
import { PartsClient } from './parts_client';
import { SeekWatch } from './seek_watch';
import { TimelinePictures, type PictureSource } from './timeline_pictures';
import { Together, type PartyAnswer, type Self, type TogetherEvents } from './together';

const step_s = 0.1; // of the timeline by mouse; keys go by a second
const keyStep_s = 1;
const pageStep_s = 10;

/** The voices in the recording. */
export interface PlaybackSound {
  hear(wanted: boolean): void;
  /** Why this browser plays no voices, as a sentence, or empty. */
  obstacle(): string;
  /** Browsers play no sound before the user has done something. */
  awaitsGesture(): boolean;
}

/** Where the pictures along the timeline come from. */
export interface PlaybackPictures {
  source: PictureSource;
  sensors(): readonly string[];
}

export function picturesOf(events: { room(): string; sensors(): readonly string[]; self(): { token: string } }, recording: string): PlaybackPictures {
  const source = new PartsClient('', events.room(), recording, events.self().token);
  return { source, sensors: () => events.sensors() };
}

/** The people who play this recording of a room. */
export function partyOf(events: Omit<TogetherEvents, 'self'> & { room(): string; self(): Self & { token: string } }, recording: string): Together {
  const path = `api/v1/rooms/${encodeURIComponent(events.room())}/recordings/${encodeURIComponent(recording)}/together`;
  const ask = async (body: object, keepalive = false): Promise<PartyAnswer> => {
    const headers = { Authorization: `Bearer ${events.self().token}`, 'Content-Type': 'application/json' };
    const response = await fetch(path, { method: 'POST', headers, body: JSON.stringify(body), keepalive, signal: AbortSignal.timeout(5000) });
    if (!response.ok) throw new Error(String(response.status));
    return (await response.json()) as PartyAnswer;
  };
  return new Together(ask, events);
}

export class PlaybackBar {
  private readonly name = element('strong');
  private readonly date = element('span', { class: 'date' });
  private readonly company = element('span');
  private readonly isTogether = checkbox(true);
  private readonly companyField = element('label', { class: 'company', hidden: '' }, this.isTogether, this.company);
  private readonly play = element('button', { type: 'button', class: 'main play' });
  private readonly time = element('span', { class: 'time' });
  private readonly line = element('input', { type: 'range', min: '0', step: String(step_s), 'aria-label': texts.position });
  private readonly speed = choice(texts.speeds, '1');
  private readonly loops = checkbox(false);
  private readonly voices = checkbox(true);
  private readonly voicesField = labelled(texts.voices, this.voices, 'voices');
  private readonly note = element('p', { class: 'note', role: 'status' });
  private readonly hint = element('p', { class: 'note hint', role: 'status' });
  private readonly watch = new SeekWatch();
  private readonly pictures: TimelinePictures | undefined;
  private state: PlaybackState | undefined;
  private isDragged = false; // the line is the person's until it is let go

  constructor(
    room: string,
    private readonly apply: (command: PlaybackCommand) => void,
    private readonly sound: PlaybackSound,
    private readonly together: Together,
    { source, sensors }: PlaybackPictures,
  ) {
    const seek = (position_s: number) => this.seek(position_s);
    if (KeyFramePainter.isPossible)
      this.pictures = new TimelinePictures(source, new KeyFramePainter(), { sensors, seek, isBusy: () => this.state?.isWaiting ?? true });
    const link = element('a', { href: `?room=${encodeURIComponent(room)}` }, texts.live);
    const title = element('div', { class: 'title' }, this.name, this.date, this.companyField, link);
    const speed = labelled(texts.speed, this.speed, 'speed');
    const loops = labelled(texts.loop, this.loops, 'loops');
    const controls = element('div', { class: 'controls' }, this.play, this.time, this.voicesField, speed, loops);
    const bar = element('section', { id: 'playback', 'aria-label': texts.title }, title, this.pictures?.root, this.line, controls, this.note, this.hint);
    document.querySelector('main')!.append(bar);
    document.body.classList.add('playing');
    this.listen();
    together.begin();
  }

  private control(command: PlaybackCommand): void {
    this.together.wanted(command);
    this.apply(command);
  }

  /** For tests. */
  get figures() {
    const { first_ms, exact_ms } = this.watch;
    return { ...this.state!, firstPicture_ms: first_ms ?? null, exactPicture_ms: exact_ms ?? null };
  }

  show(state: PlaybackState): void {
    this.state = state;
    this.watch.take(state);
    this.together.show(state);
    const { names } = this.together;
    this.companyField.hidden = names.length === 0 && this.isTogether.checked;
    setText(this.company, names.length > 0 ? texts.together(names) : texts.togetherAgain);
    setText(this.name, state.name);
    setText(this.play, state.paused ? texts.play : texts.pause);
    this.line.max = String(state.length_s);
    if (!this.isDragged) this.showPosition(state.position_s);
    if (document.activeElement !== this.speed) this.speed.value = String(state.speed);
    this.loops.checked = state.loops;
    this.voicesField.hidden = !state.voices;
    setText(this.note, state.isDamaged ? texts.damaged : '');
    setText(this.hint, state.voices && this.voices.checked ? this.voicesHint(state) : '');
  }

  drawn(frames: readonly ViewFrame[]): void {
    this.watch.show(frames, performance.now());
    if (this.state) void this.pictures?.load(this.state.length_s, this.line.clientWidth);
  }

  /** Why voices are not heard, or nothing. */
  private voicesHint({ paused, speed }: PlaybackState): string {
    if (this.sound.obstacle()) return this.sound.obstacle();
    if (speed !== 1) return texts.voicesAtOne;
    return this.sound.awaitsGesture() && !paused ? texts.awaitsGesture : '';
  }

  private listen(): void {
    const { line } = this;
    this.isTogether.addEventListener('change', () => this.together.setOn(this.isTogether.checked));
    this.voices.addEventListener('change', () => this.sound.hear(this.voices.checked));
    this.play.addEventListener('click', () => this.toggle());
    this.speed.addEventListener('change', () => this.control({ speed: Number(this.speed.value) }));
    this.loops.addEventListener('change', () => this.control({ loops: this.loops.checked }));
    line.addEventListener('input', () => this.seek(Number(line.value)));
    line.addEventListener('pointerdown', () => (this.isDragged = true));
    for (const end of ['pointerup', 'pointercancel', 'blur']) line.addEventListener(end, () => (this.isDragged = false));
    line.addEventListener('keydown', (event) => this.lineKey(event));
    window.addEventListener('keydown', (event) => this.spaceKey(event));
  }

  private toggle(): void {
    this.control({ paused: !this.state?.paused });
  }

  private seek(position_s: number): void {
    this.watch.asked(performance.now());
    this.showPosition(position_s);
    this.control({ seek_s: position_s });
  }

  private showPosition(position_s: number): void {
    const { length_s = 0, began_at = 0 } = this.state ?? {};
    this.line.value = String(position_s);
    const words = texts.of(duration(position_s), duration(length_s));
    this.line.setAttribute('aria-valuetext', words);
    setText(this.time, words);
    const then = new Date(1000 * (began_at + position_s));
    setText(this.date, then.toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'medium' }));
  }

  /** Steps that fit a recording; the browser's own are those of the mouse. */
  private lineKey(event: KeyboardEvent): void {
    const step_s = {
      ArrowRight: keyStep_s,
      ArrowUp: keyStep_s,
      ArrowLeft: -keyStep_s,
      ArrowDown: -keyStep_s,
      PageUp: pageStep_s,
      PageDown: -pageStep_s,
    }[event.code];
    if (event.code === 'Space') this.toggle();
    else if (step_s !== undefined) this.seek(Math.min(Math.max(0, Number(this.line.value) + step_s), Number(this.line.max)));
    else return;
    event.preventDefault();
  }

  private spaceKey(event: KeyboardEvent): void {
    const isForRoom = event.target instanceof Element && event.target.matches('body, canvas');
    if (event.code !== 'Space' || !isForRoom || event.repeat || event.defaultPrevented) return;
    event.preventDefault();
    this.toggle();
  }
}
