// SPDX-License-Identifier: Apache-2.0
// Plays the packets of one speaker evenly although they arrive unevenly: waits for late ones as long as pays, conceals
// lost ones, and lengthens or shortens speech by single pitch periods to keep the delay. Times in milliseconds, 48 kHz.
import { Concealment, fadeInto, lengthened, shortened } from './concealment';
import { DelayEstimate } from './delay_estimate';
import { packetSamples, seqDistance, type PcmPacket } from './voice_packet';

const longestConcealed = 3; // packets, 60 ms: then the speaker has paused, or the line is dead
const lateChunk = 240; // samples, 5 ms: what is played before looking again whether a late packet has come
const fadeSamples = 192; // 4 ms
const mostWaiting = 50; // packets, a second
const farApart = 25; // packets: others were nearer meanwhile, or the speaker has joined again
const slack_ms = 20; // by which the delay may exceed its target
const shortfall_ms = 10; // by which it may be less
const tooLate_ms = 150; // beyond the target: packets are left out until the delay is right

export interface JitterFigures {
  target_ms: number;
  played: number; // packets
  concealed: number; // packets, in samples / packetSamples
  skipped: number; // packets that came too late, or were left out to catch up
}

export class JitterBuffer {
  delay = new DelayEstimate();
  readonly figures: JitterFigures = { target_ms: 0, played: 0, concealed: 0, skipped: 0 };
  private readonly waiting = new Map<number, PcmPacket>();
  private readonly concealment = new Concealment();
  private isPlaying = false;
  private next = 0; // sequence number, while playing
  private newest: number | undefined;
  private ready: Float32Array = new Float32Array(0); // being played
  private at = 0; // in `ready`
  private endsAfterReady = false;
  private concealedSamples = 0; // since the last packet
  private readonly bridge = new Float32Array(lateChunk);
  private readonly fade = new Float32Array(fadeSamples);

  get isSilent(): boolean {
    return !this.isPlaying && this.at >= this.ready.length;
  }

  push(packet: PcmPacket, now_ms: number): void {
    const { seq } = packet;
    if (this.newest !== undefined && Math.abs(seqDistance(this.newest, seq)) > farApart) this.restart();
    this.delay.arrived(packet.capture_ms, now_ms);
    this.figures.target_ms = this.delay.target_ms;
    if (this.isPlaying && seqDistance(this.next, seq) < 0) {
      this.figures.skipped++;
      return;
    }
    if (this.newest === undefined || seqDistance(this.newest, seq) > 0) this.newest = seq;
    this.waiting.set(seq, packet);
    if (this.waiting.size > mostWaiting) this.skip(this.first()!);
  }

  /** What follows is of another time: what waits is dropped, and what is being played fades out. */
  silence(): void {
    this.restart();
    this.delay = new DelayEstimate();
    const rest = this.ready.slice(this.at, this.at + fadeSamples);
    this.ready = rest.map((sample, i) => sample * (1 - (i + 1) / rest.length));
    this.at = 0;
  }

  /** Fills `out` with what is to be heard from now on. */
  pull(out: Float32Array, now_ms: number): void {
    let filled = 0;
    while (filled < out.length) {
      if (this.at >= this.ready.length && !this.prepare(now_ms)) {
        out.fill(0, filled);
        return;
      }
      const part = this.ready.subarray(this.at, this.at + out.length - filled);
      out.set(part, filled);
      filled += part.length;
      this.at += part.length;
    }
  }

  /** The next samples. False: silence. */
  private prepare(now_ms: number): boolean {
    if (this.endsAfterReady) this.pause();
    if (!this.isPlaying && !this.begin(now_ms)) return false;
    const packet = this.waiting.get(this.next);
    if (packet) {
      this.play(packet, now_ms);
      return true;
    }
    return this.conceal();
  }

  /** Begins when the first packet has waited for its target. */
  private begin(now_ms: number): boolean {
    let packet = this.first();
    const due_ms = (p: PcmPacket) => p.capture_ms + this.delay.shortest_ms + this.delay.target_ms;
    while (packet && this.waiting.size > 1 && now_ms > due_ms(packet) + tooLate_ms) {
      this.skip(packet);
      packet = this.first();
    }
    if (!packet || now_ms < due_ms(packet)) return false;
    this.next = packet.seq;
    this.isPlaying = true;
    return true;
  }

  private play(packet: PcmPacket, now_ms: number): void {
    this.waiting.delete(packet.seq);
    this.next = (packet.seq + 1) >>> 0;
    this.figures.played++;
    const samples = this.inTime(packet, now_ms);
    if (this.concealment.isOn) {
      this.concealment.fill(this.fade);
      fadeInto(samples, this.fade);
    }
    this.concealment.heard(samples);
    this.concealedSamples = 0;
    this.endsAfterReady = packet.ends;
    this.ready = samples;
    this.at = 0;
  }

  /** The samples of the packet, a pitch period more or less where the delay is not what it should be. */
  private inTime({ capture_ms, samples }: PcmPacket, now_ms: number): Float32Array {
    const delay_ms = now_ms - capture_ms - this.delay.shortest_ms;
    if (delay_ms > this.delay.target_ms + slack_ms && this.waiting.size > 0) return shortened(samples);
    if (delay_ms < this.delay.target_ms - shortfall_ms) return lengthened(samples);
    return samples;
  }

  /** What goes on while a packet is missing. A later one shows that it is lost; else it may still come. */
  private conceal(): boolean {
    if (this.concealedSamples >= longestConcealed * packetSamples) {
      this.pause();
      return false;
    }
    const isLost = this.waiting.size > 0;
    const out = isLost ? new Float32Array(packetSamples - (this.concealedSamples % packetSamples)) : this.bridge;
    this.concealment.fill(out);
    this.concealedSamples += out.length;
    this.figures.concealed += out.length / packetSamples;
    if (isLost) this.next = (this.next + 1) >>> 0;
    this.ready = out;
    this.at = 0;
    return true;
  }

  private pause(): void {
    this.isPlaying = this.endsAfterReady = false;
    this.concealedSamples = 0;
    this.concealment.forget();
  }

  private restart(): void {
    this.figures.skipped += this.waiting.size;
    this.waiting.clear();
    this.newest = undefined;
    this.pause();
  }

  private skip({ seq }: PcmPacket): void {
    this.waiting.delete(seq);
    this.figures.skipped++;
    if (this.isPlaying && seq === this.next) this.next = (seq + 1) >>> 0;
  }

  private first(): PcmPacket | undefined {
    let first: PcmPacket | undefined;
    for (const packet of this.waiting.values()) {
      if (!first || seqDistance(first.seq, packet.seq) < 0) first = packet;
    }
    return first;
  }
}

