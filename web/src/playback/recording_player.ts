// SPDX-License-Identifier: Apache-2.0
// Plays a recording that a hub keeps, in place of a live room: the worker gets the same messages, in the time in which they
// came. To seek, it fetches the part of the moment (docs/spec/playback.md); while it plays, the parts that follow.
import { create } from '@bufbuild/protobuf';
import { RoomClock } from '../clock/room_clock';
import { WelcomeSchema } from '../gen/control_pb';
import { playbackTexts as texts } from '../recording_texts';
import { initialState, pageTime_ms, type ConnectionState, type PlaybackCommand, type PlaybackState, type StartOptions } from '../stream/protocol';
import type { RoomEvents, RoomSource } from '../stream/room_source';
import { audioPayload, parseAudioHeader } from '../wire/audio_header';
import { decodeControl, type ControlMessage } from '../wire/control';
import { framePayload, MessageType, messageType, parseFrameHeader, type FrameHeader } from '../wire/frame_header';
import { WireError } from '../wire/wire_error';
import { inOrderOfShowing, type MomentFrame } from './moment_frames';
import type { Part, PartRecord } from './part';
import { PartyLine } from './party_line';
import { PartsClient, PlaybackProblem, type AboutRecording } from './parts_client';
import { PlaybackClock } from './playback_clock';

const ahead_s = 2; // what is fetched before its time has come, at speed 1
const longestTurn_ms = 40; // of decoding; then messages of the page and finished colours get their turn
const reportEvery_ms = 200;
const longestSleep_ms = 100;
const fastSpeed = 2; // from here on, frames that no other one needs are left out
const voiceSpeed = 1; // voices are heard at no other
const retries_ms = [1000, 2000, 4000];

type Timer = ReturnType<typeof setTimeout>;

export class RecordingPlayer implements RoomSource {
  readonly clock = new RoomClock(); // room time is of the past: it is never known
  private readonly parts: PartsClient;
  private readonly time = new PlaybackClock(() => performance.now());
  private about: AboutRecording | undefined;
  private waiting: PartRecord[] = []; // fetched; their time has not come
  private next: number | undefined; // part to fetch
  private fetched_s = 0; // up to here
  private damaged = { from_s: Infinity, until_s: -1 }; // the last part that was
  private isFetching = false;
  private wanted_s: number | undefined; // to be sought
  private isSeeking = false;
  private seeks = 0;
  private moment: PlaybackState['moment'] = [];
  private loops = false;
  private failures = 0;
  private isDown = false;
  private timer: Timer | undefined;
  private phase: ConnectionState['phase'] | undefined;
  private openedAt_ms: number | undefined;
  private line: PartyLine | undefined; // to the others who play it
  private pose: ControlMessage | undefined; // of this person
  private readonly told = new Map<string, Uint8Array>(); // the last roster and marks

  constructor(
    private options: StartOptions,
    private readonly playback: NonNullable<StartOptions['playback']>,
    private readonly events: RoomEvents,
  ) {
    const hub = options.socketUrl.replace(/^ws/, 'http').replace(/ws$/, '');
    this.parts = new PartsClient(hub, this.room, playback.recording, options.access.token);
  }

  get received_bytes(): number {
    return this.parts.received_bytes + (this.line?.received_bytes ?? 0);
  }

  connect(): void {
    this.report('connecting');
    void this.trying(async () => {
      if (this.room === '') throw new PlaybackProblem(texts.noRoom, false, true);
      this.begin(await this.parts.about());
    });
  }

  /** Nothing can be done to a recording; the others hear where one stands. */
  send(message: ControlMessage): void {
    if (message.case !== 'viewerPose') return;
    this.pose = message;
    this.line?.stand(message);
  }

  sendAudio(page_ms: number, ends: boolean, payload: Uint8Array): void {
    this.line?.sendAudio(page_ms, ends, payload);
  }

  rename(name: string): void {
    this.options = { ...this.options, name };
    this.line?.rename(name);
  }

  control({ seek_s, paused, speed, loops, isTogether }: PlaybackCommand): void {
    if (isTogether !== undefined) this.join(isTogether);
    if (loops !== undefined) this.loops = loops;
    if (speed !== undefined) this.setSpeed(speed);
    if (paused !== undefined) this.pause(paused);
    if (seek_s !== undefined) this.seek(seek_s);
    this.tell();
    this.turnSoon();
  }

  private join(isTogether: boolean): void {
    if (isTogether === (this.line !== undefined) || !this.options.hears) return;
    this.line?.leave();
    const { options, room, playback, pose, events } = this;
    this.line = isTogether ? new PartyLine({ ...options, room }, playback.recording, pose, events) : undefined;
  }

  private get room(): string {
    return this.options.room || this.options.access.room;
  }

  private get length_s(): number {
    return this.about?.seconds ?? 0;
  }

  private begin(about: AboutRecording): void {
    if (about.state === 'unreadable') throw new PlaybackProblem(about.problem ?? texts.unreadable, false, true);
    this.about = about;
    this.events.welcome(create(WelcomeSchema, { room: this.room }));
    this.events.line(0, false);
    this.seek(this.playback.from_s);
    setInterval(() => this.tell(), reportEvery_ms);
  }

  /** At the end, playing begins anew. */
  private pause(paused: boolean): void {
    if (!paused && this.time.position_s >= this.length_s && !this.isSeeking) this.seek(0);
    if (paused) this.events.silenced();
    this.time.pause(paused);
  }

  private setSpeed(speed: number): void {
    this.events.silenced();
    this.time.setSpeed(speed);
  }

  /** While one moment is being sought, only the last one that was asked for in the meantime follows it. */
  private seek(position_s: number): void {
    this.wanted_s = Math.min(Math.max(0, position_s), this.length_s);
    this.time.set(this.wanted_s);
    this.time.hold(true);
    if (!this.isSeeking) void this.seekOn();
  }

  private async seekOn(): Promise<void> {
    this.isSeeking = true;
    while (this.wanted_s !== undefined) {
      const position_s = this.wanted_s;
      const isDone = await this.trying(async () => this.show(await this.parts.moment(position_s), position_s));
      if (isDone && this.wanted_s === position_s) this.wanted_s = undefined;
      if (!isDone && this.isDown) break;
    }
    this.isSeeking = false;
    if (this.isDown) return;
    this.time.hold(false);
    this.turnSoon();
  }

  private async show(part: Part, position_s: number): Promise<void> {
    if (this.wanted_s !== position_s) return;
    this.report('joined');
    this.events.rewound(); // what is being decoded is of another moment
    this.events.silenced();
    this.waiting = [];
    this.take(part);
    this.seeks++;
    this.moment = [];
    this.tell();
    await this.showPast(part.records.filter(({ isPast }) => isPast), position_s);
    this.time.set(position_s);
  }

  private async showPast(records: readonly PartRecord[], position_s: number): Promise<void> {
    const frames: Omit<MomentFrame, 'isShown'>[] = [];
    for (const { message } of records) this.read(message, (header, payload) => frames.push({ header, payload }));
    const ordered = inOrderOfShowing(frames, BigInt(-2 * this.seeks));
    const last = new Map(ordered.map(({ header: { sensor, seq } }) => [sensor, seq]));
    this.moment = [...last].map(([sensor, seq]) => ({ sensor, seq }));
    this.tell();
    let turn_ms = performance.now();
    for (const { header, payload, isShown } of ordered) {
      this.events.frame(header, payload, !isShown);
      if (performance.now() - turn_ms < longestTurn_ms && !(isShown && header.last)) continue;
      await new Promise((resolve) => setTimeout(resolve));
      if (this.wanted_s !== position_s) return; // another moment is wanted by now
      turn_ms = performance.now();
    }
  }

  private take({ records, next, until_s, isDamaged, from_s }: Part): void {
    this.waiting = this.waiting.concat(records.filter(({ isPast }) => !isPast));
    this.next = next;
    this.fetched_s = next === undefined ? Math.max(until_s, this.length_s) : until_s;
    if (isDamaged) this.damaged = { from_s, until_s };
  }

  /** Hands over what is due, and arranges for the next time. */
  private turn(): void {
    if (this.isSeeking || this.isDown) return;
    const position_s = this.time.position_s;
    const isLate = this.handOver(position_s);
    void this.fetchAhead(position_s);
    const isShort = position_s >= this.fetched_s && this.next !== undefined;
    if (isShort) {
      this.time.set(this.fetched_s);
      this.time.hold(true);
      this.events.silenced();
    } else if (position_s >= this.length_s && !this.time.paused && this.waiting.length === 0) {
      return this.atEnd();
    }
    if (!this.time.paused) this.turnSoon(isLate ? 0 : Math.min(longestSleep_ms, this.untilNext_ms));
  }

  private get untilNext_ms(): number {
    const [first] = this.waiting;
    return first ? this.time.until_ms(first.time_s) : longestSleep_ms;
  }

  /** True if there is more than one turn can decode: then playing slows down, and nothing is lost. */
  private handOver(position_s: number): boolean {
    const end_ms = performance.now() + longestTurn_ms;
    let done = 0;
    for (const { message, time_s } of this.waiting) {
      if (time_s > position_s) break;
      done++;
      this.read(message, (header, payload) => {
        if (this.time.speed < fastSpeed || header.layer === 0) this.events.frame(header, payload);
      });
      if (performance.now() < end_ms) continue;
      this.time.set(time_s);
      break;
    }
    this.waiting.splice(0, done);
    const [first] = this.waiting;
    return first !== undefined && first.time_s <= this.time.position_s;
  }

  private atEnd(): void {
    if (this.loops) return this.seek(0);
    this.time.pause(true);
    this.time.set(this.length_s);
    this.tell();
  }

  private async fetchAhead(position_s: number): Promise<void> {
    const { next } = this;
    const enough_s = position_s + ahead_s * Math.max(1, this.time.speed);
    if (next === undefined || this.isFetching || this.fetched_s > enough_s) return;
    this.isFetching = true;
    const { seeks } = this;
    await this.trying(async () => {
      const part = await this.parts.following(next);
      if (seeks === this.seeks && !this.isSeeking) this.take(part);
      this.report('joined');
    });
    this.isFetching = false;
    if (this.isSeeking || this.isDown) return;
    this.time.hold(false);
    this.turnSoon();
  }

  private turnSoon(after_ms = 0): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.turn(), after_ms);
  }

  /** What cannot be read is left out: it was checked by the hub that recorded it, but the file may have been altered. */
  private read(message: Uint8Array, frame: (header: FrameHeader, payload: Uint8Array) => void): void {
    try {
      const view = new DataView(message.buffer, message.byteOffset, message.byteLength);
      if (messageType(view) === MessageType.Control) return this.readControl(message);
      if (messageType(view) === MessageType.Audio) return this.readAudio(message, view);
      const header = parseFrameHeader(view);
      frame(header, framePayload(message, header));
    } catch (error) {
      if (!(error instanceof WireError)) throw error;
    }
  }

  private readAudio(message: Uint8Array, view: DataView): void {
    const header = parseAudioHeader(view);
    if (this.time.speed === voiceSpeed) this.events.audio(header, audioPayload(message, header));
  }

  /** What is as it was is not told again: the page would draw for it. */
  private readControl(bytes: Uint8Array): void {
    const { message } = decodeControl(bytes);
    if (message.case === 'viewerPoses') return this.events.poses(message.value.poses);
    if (message.case !== 'roster' && message.case !== 'marks') return;
    const isKnown = isEqual(bytes, this.told.get(message.case));
    this.told.set(message.case, bytes);
    if (isKnown) return;
    if (message.case === 'roster') this.events.roster(message.value);
    else this.events.marks(message.value);
  }

  /** Says what has failed, and tries again where that can help. False: it has failed. */
  private async trying(what: () => Promise<void> | void): Promise<boolean> {
    try {
      await what();
      this.failures = 0;
      return true;
    } catch (error) {
      this.failed(error);
      return false;
    }
  }

  private failed(error: unknown): void {
    const isKnown = error instanceof PlaybackProblem || error instanceof WireError;
    if (!isKnown) throw error;
    const sentence = error instanceof WireError ? texts.refused(error.message) : error.message;
    const isFinal = error instanceof WireError || error.isFinal;
    const needsToken = error instanceof PlaybackProblem && error.needsToken;
    this.isDown = true;
    this.time.hold(true);
    const delay_ms = retries_ms[Math.min(this.failures++, retries_ms.length - 1)]!;
    const retryAt_ms = isFinal ? undefined : Date.now() + delay_ms;
    this.report('waiting', { sentence, needsToken, ended: isFinal, retryAt_ms });
    if (!isFinal) setTimeout(() => this.again(), delay_ms);
  }

  private again(): void {
    this.isDown = false;
    if (!this.about) this.connect();
    else this.seek(this.wanted_s ?? this.time.position_s);
  }

  private tell(): void {
    const { about, time, loops, seeks, moment } = this;
    if (!about) return;
    const position_s = Math.min(time.position_s, this.length_s);
    const isWaiting = this.isSeeking || (position_s >= this.fetched_s && this.next !== undefined);
    const isDamaged = position_s >= this.damaged.from_s && position_s < this.damaged.until_s;
    const { name, began_at, voices = false } = about;
    const { paused, speed } = time;
    const length_s = this.length_s;
    this.events.playback({ name, began_at, length_s, position_s, paused, speed, loops, isWaiting, isDamaged, voices, seeks, moment });
  }

  private report(phase: ConnectionState['phase'], facts: Partial<ConnectionState> = {}): void {
    if (phase === this.phase && phase === 'joined') return;
    if (phase === 'joined') this.isDown = false;
    this.phase = phase;
    this.openedAt_ms ??= pageTime_ms();
    this.events.connection({ ...initialState, openedAt_ms: this.openedAt_ms, ...facts, phase });
  }

}

function isEqual(bytes: Uint8Array, others: Uint8Array | undefined): boolean {
  return bytes.length === others?.length && bytes.every((value, i) => value === others[i]);
}
