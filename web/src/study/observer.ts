// SPDX-License-Identifier: Apache-2.0
// Watches a participant's page and writes what it sees into the log: poses ten times a second, figures once, and what
// changes when it does.
import type { LogRecord, SessionLog } from './session_log';
import type { StudySeat } from './study_seat';

const tick_ms = 100;
const ticksPerSecond = 10;
const decimals = 4; // of metres and quaternions

function rounded(value: number): number {
  return Number(value.toFixed(decimals));
}

export class Observer {
  private ticks = 0;
  private timer: ReturnType<typeof setInterval> | undefined;
  private bytes: number | undefined;
  private wasSending = false;
  private wasVisible: boolean | undefined;
  private wasConnected: boolean | undefined;

  constructor(
    private readonly seat: StudySeat,
    private readonly log: Pick<SessionLog, 'add'>,
    private readonly now_s: () => number,
  ) {}

  begin(): void {
    this.timer = setInterval(() => this.tick(), tick_ms);
  }

  /** The study is over: nothing more of the participant is noted. */
  end(): void {
    clearInterval(this.timer);
  }

  /** Also for what others write: with the time of now. */
  add(kind: string, fields: Omit<LogRecord, 'kind' | 't'>): void {
    this.log.add({ ...fields, kind, t: Number(this.now_s().toFixed(3)) } as LogRecord);
  }

  private tick(): void {
    const { x, y, z, qx, qy, qz, qw } = this.seat.body().head;
    const pose = { x, y, z, qx, qy, qz, qw };
    this.add('poses', Object.fromEntries(Object.entries(pose).map(([name, value]) => [name, rounded(value)])));
    this.noteChanges();
    if (this.ticks++ % ticksPerSecond === 0) this.noteFigures();
  }

  private noteChanges(): void {
    const { sound, state } = this.seat;
    if (sound.isSending !== this.wasSending) {
      this.wasSending = sound.isSending;
      this.add('speech', { on: this.wasSending });
    }
    const isVisible = document.visibilityState === 'visible';
    if (isVisible !== this.wasVisible) this.add('page', { what: 'visible', on: (this.wasVisible = isVisible), note: '' });
    const isConnected = state.connection.phase === 'joined';
    if (isConnected !== this.wasConnected) {
      this.add('page', { what: 'connected', on: (this.wasConnected = isConnected), note: state.connection.sentence });
    }
  }

  private noteFigures(): void {
    const { state, stage } = this.seat;
    const bytes = state.status?.received_bytes ?? 0;
    const mbit = this.bytes === undefined ? 0 : (8 * Math.max(0, bytes - this.bytes)) / 1e6;
    this.bytes = bytes;
    this.add('figures', {
      fps: rounded(state.shownFps),
      latency_ms: rounded(state.latency_ms ?? 0),
      mbit: rounded(mbit),
      clock_error_ms: rounded(state.status?.clock?.error_ms ?? 0),
    });
    const now_ms = state.roomTime_ms();
    for (const { id, name, online } of state.roster?.sensors ?? []) {
      const traffic = state.status?.sensors.find(({ sensor }) => sensor === id);
      const newest = state.shownSeqs.get(id);
      const age_ms = now_ms !== undefined && newest ? now_ms - newest.capture_ms : 0;
      const frames = traffic?.frames ?? 0;
      this.add('sensors', { sensor: name, online, shown: stage.isVisible(id), frames, age_ms: rounded(age_ms) });
    }
  }
}
