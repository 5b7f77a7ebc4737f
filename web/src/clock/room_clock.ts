// SPDX-License-Identifier: Apache-2.0
// The offset from this program's clock to room time (the hub's monotonic clock), by the exchange with the smallest round
// trip among the last 32 pings: docs/spec/wire.md §3, after NTP's clock filter (RFC 5905 §10). Milliseconds throughout.

const keptExchanges = 32;
const quickPings = 5;

interface Exchange {
  offset_ms: number;
  roundTrip_ms: number;
}

export interface ClockEstimate {
  offset_ms: number; // room time = local time + offset
  error_ms: number; // bound: half of the round trip
}

export class RoomClock {
  private readonly exchanges: Exchange[] = [];
  private best: Exchange | undefined;

  /** `sent_ms` and `received_ms` are local time, `hub_ms` is room time when the hub read the ping. */
  addExchange(sent_ms: number, received_ms: number, hub_ms: number): void {
    const roundTrip_ms = received_ms - sent_ms;
    if (!(roundTrip_ms >= 0) || !Number.isFinite(hub_ms)) return;
    this.exchanges.push({ offset_ms: hub_ms - (sent_ms + received_ms) / 2, roundTrip_ms });
    if (this.exchanges.length > keptExchanges) this.exchanges.shift();
    this.best = this.exchanges.reduce((best, next) => (next.roundTrip_ms <= best.roundTrip_ms ? next : best));
  }

  /** The shortest round trip; 0 before the first exchange. */
  get roundTrip_ms(): number {
    return this.best?.roundTrip_ms ?? 0;
  }

  /** Undefined before the first exchange. */
  estimate(): ClockEstimate | undefined {
    if (!this.best) return undefined;
    return { offset_ms: this.best.offset_ms, error_ms: this.best.roundTrip_ms / 2 };
  }
}

/**
 * Delay before ping number `count` (from 0). It is random, because a ping in step with the frames would always wait
 * behind one. `random` is in [0, 1).
 */
export function pingDelay_ms(count: number, random: number): number {
  if (count === 0) return 0;
  return count < quickPings ? 20 + 40 * random : 250 + 500 * random;
}
