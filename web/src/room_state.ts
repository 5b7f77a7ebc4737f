// SPDX-License-Identifier: Apache-2.0
// The page's state of the room, gathered from the worker's messages and from drawing. Times are page time
// (stream/protocol.ts) in milliseconds unless they are marked as room time.
import type { ViewerPose, Voices, Welcome } from './gen/control_pb';
import { RateMeter } from './rate_meter';
import type { RoomRoster, RoomSensor } from './room_roster';
import {
  initialState,
  pageTime_ms,
  type Body,
  type ConnectionState,
  type DecodedRecord,
  type PlainPose,
  type Status,
  type ViewFrame,
} from './stream/protocol';
import { microphonePlace } from './voice/sensor_speaker';

const keptRecords = 100; // per sensor
const latencyWindow_ms = 1000;

interface SensorRates {
  frames: RateMeter;
  bytes: RateMeter;
}

export class RoomState {
  connection = initialState;
  welcome: Welcome | undefined;
  roster: RoomRoster | undefined;
  status: Status | undefined;
  body: Body | undefined; // current pose of the headset's wearer
  readonly poses = new Map<number, ViewerPose>(); // of the other viewers, as received
  speaking: ReadonlySet<number> = new Set(); // viewers, and microphones of sensors (voice/sensor_speaker.ts)
  readonly unseen = new Set<number>(); // sensors that were paused, as this viewer cannot see what they show; until their next frame
  muted: ReadonlySet<number> = new Set(); // of these, by an admin
  broken = ''; // reason why the page cannot continue
  consoleProblem = ''; // reason why the console is not there
  shownSets = 0;
  lastShownSet = 0n;
  firstShownAt_ms: number | undefined; // since the connection was opened: all online sensors decoded and drawn
  firstDecodedAt_ms: number | undefined;
  readonly shownSeqs = new Map<number, { seq: number; setId: bigint; capture_ms: number; at_ms: number }>();
  readonly records = new Map<number, DecodedRecord[]>();
  private readonly rates = new Map<number, SensorRates>();
  private readonly shownRate = new RateMeter();
  private readonly totalRate = new RateMeter();
  private latencies: { at_ms: number; latency_ms: number }[] = [];
  private readonly complete = new Set<number>();

  sensorFps(sensor: number): number {
    return this.rates.get(sensor)?.frames.perSecond() ?? 0;
  }

  sensorBytesPerSecond(sensor: number): number {
    return this.rates.get(sensor)?.bytes.perSecond() ?? 0;
  }

  get bytesPerSecond(): number {
    return this.totalRate.perSecond();
  }

  get shownFps(): number {
    return this.shownRate.perSecond(pageTime_ms());
  }

  /** From capture to screen, median of the last second. */
  get latency_ms(): number | undefined {
    const sorted = this.latencies.map((entry) => entry.latency_ms).sort((a, b) => a - b);
    return sorted[sorted.length >> 1];
  }

  /** Undefined before the clock is known. */
  roomTime_ms(page_ms = pageTime_ms()): number | undefined {
    const clock = this.status?.clock;
    return clock && page_ms + clock.roomFromPage_ms;
  }

  get onlineSensors(): RoomSensor[] {
    return this.roster?.sensors.filter((sensor) => sensor.online) ?? [];
  }

  /** The head of a person, or a sensor's microphone. */
  placeOf(speaker: number): PlainPose | undefined {
    return this.poses.get(speaker)?.head ?? microphonePlace(speaker, this.roster?.sensors ?? []);
  }

  /** This viewer's own, as the others see it: 0xRRGGBB. */
  get ownColor(): number {
    return this.roster?.viewers.find(({ id }) => id === this.welcome?.viewerId)?.colorRgb ?? 0xffffff;
  }

  follow(roster: RoomRoster): void {
    this.roster = roster;
    const present = new Set(roster.viewers.map(({ id }) => id));
    for (const id of this.poses.keys()) if (!present.has(id)) this.poses.delete(id);
  }

  setVoices({ speaking, muted }: Pick<Voices, 'speaking' | 'muted'>): void {
    this.speaking = new Set(speaking);
    this.muted = new Set(muted);
  }

  setConnection(state: ConnectionState): void {
    if (state.phase === 'connecting') {
      this.complete.clear();
      this.unseen.clear();
      this.firstDecodedAt_ms = this.firstShownAt_ms = undefined;
    }
    // A page that tries again is still without its hub for the same reason.
    const sentence = state.phase === 'connecting' ? this.connection.sentence : state.sentence;
    this.connection = { ...state, sentence };
  }

  setStatus(status: Status): void {
    const now = pageTime_ms();
    this.status = status;
    this.totalRate.count(now, status.received_bytes);
    for (const traffic of status.sensors) {
      const rates = this.ratesOf(traffic.sensor);
      rates.frames.count(now, traffic.frames);
      rates.bytes.count(now, traffic.bytes);
    }
    status.decoded.forEach((record) => this.keep(record));
  }

  framesDecoded(frames: readonly ViewFrame[], at_ms: number): void {
    for (const { sensor } of frames) {
      this.complete.add(sensor);
      this.unseen.delete(sensor);
    }
    const online = this.onlineSensors;
    const all = online.length > 0 && online.every((sensor) => this.complete.has(sensor.id));
    if (all) this.firstDecodedAt_ms ??= at_ms;
  }

  framesShown(setId: bigint, frames: readonly ViewFrame[], at_ms: number): void {
    this.shownSets++;
    this.lastShownSet = setId;
    this.shownRate.count(at_ms, this.shownSets);
    if (this.firstDecodedAt_ms !== undefined) this.firstShownAt_ms ??= at_ms;
    const room_ms = this.roomTime_ms(at_ms);
    for (const { sensor, seq, setId: of, capture_ms } of frames) {
      this.shownSeqs.set(sensor, { seq, setId: of, capture_ms, at_ms });
      if (room_ms !== undefined) this.latencies.push({ at_ms, latency_ms: room_ms - capture_ms });
    }
    this.latencies = this.latencies.filter((entry) => entry.at_ms > at_ms - latencyWindow_ms);
  }

  private ratesOf(sensor: number): SensorRates {
    let rates = this.rates.get(sensor);
    if (!rates) {
      rates = { frames: new RateMeter(), bytes: new RateMeter() };
      this.rates.set(sensor, rates);
    }
    return rates;
  }

  private keep(record: DecodedRecord): void {
    const kept = this.records.get(record.sensor) ?? [];
    kept.push(record);
    if (kept.length > keptRecords) kept.shift();
    this.records.set(record.sensor, kept);
  }
}
