// SPDX-License-Identifier: Apache-2.0
// The voice worker: encodes the microphone's blocks for the hub, and decodes the packets of speakers for their players.
import { pageTime_ms } from '../stream/protocol';
import { isFellow } from './fellow_speaker';
import type { FromVoiceWorker, ToVoiceWorker } from './protocol';
import { loudnessOf } from './talk_gate';
import { VoiceDecoder } from './voice_decoder';
import { VoiceEncoder } from './voice_encoder';
import { silence, type HeardPacket, type Silence } from './voice_packet';
import type { RecordedBlock } from './worklet';

interface WorkerPort {
  postMessage(message: FromVoiceWorker): void;
  onmessage: ((event: MessageEvent<ToVoiceWorker>) => void) | null;
}

const page = self as unknown as WorkerPort;
const levelEvery = 5; // blocks
const mostKept = 25; // packets of a speaker whose player is not there yet
const mostSpeakers = 64;

interface Player {
  decoder: VoiceDecoder;
  port: MessagePort;
}

const players = new Map<number, Player>();
const kept = new Map<number, HeardPacket[]>(); // of speakers without a player
let hub: MessagePort | undefined;
let blocks = 0;

const encoder = new VoiceEncoder({
  packet: (packet) => hub?.postMessage(packet, [packet.payload.buffer]),
  fault: (sentence) => page.postMessage({ kind: 'fault', sentence }),
});

function heard(packet: HeardPacket): void {
  const player = players.get(packet.speaker);
  if (player) return player.decoder.take(packet);
  const waiting = kept.get(packet.speaker);
  if (waiting) {
    if (waiting.push(packet) > mostKept) waiting.shift();
  } else if (kept.size < mostSpeakers) {
    kept.set(packet.speaker, [packet]);
    page.postMessage({ kind: 'speaks', speaker: packet.speaker });
  }
}

function recorded(block: RecordedBlock): void {
  const loudness = loudnessOf(block.samples);
  const isSent = encoder.take(block, pageTime_ms());
  if (++blocks % levelEvery === 0) page.postMessage({ kind: 'level', loudness, isSent });
}

/** Of a recording; who plays it together with this person talks on. */
function fallSilent(): void {
  kept.forEach((packets, speaker) => !isFellow(speaker) && (packets.length = 0));
  for (const [speaker, { decoder, port }] of players) {
    if (isFellow(speaker)) continue;
    decoder.restart();
    port.postMessage(silence);
  }
}

function forget(speaker: number): void {
  players.get(speaker)?.decoder.close();
  players.delete(speaker);
  kept.delete(speaker);
}

page.onmessage = ({ data }) => {
  switch (data.kind) {
    case 'hub':
      hub = data.port;
      hub.onmessage = ({ data: packet }: MessageEvent<HeardPacket | Silence>) => {
        if (packet === silence) fallSilent();
        else heard(packet);
      };
      return;
    case 'player': {
      const { speaker, port } = data;
      const decoder = new VoiceDecoder((packet) => port.postMessage(packet, [packet.samples.buffer]));
      const waiting = kept.get(speaker) ?? [];
      forget(speaker);
      players.set(speaker, { decoder, port });
      return waiting.forEach((packet) => decoder.take(packet));
    }
    case 'gone':
      return forget(data.speaker);
    case 'microphone':
      encoder.restart();
      data.port.onmessage = ({ data: block }: MessageEvent<RecordedBlock>) => recorded(block);
      return;
    case 'talk':
      encoder.gate.mode = data.mode;
      encoder.gate.isPushed = data.isPushed;
      encoder.isOn = data.isOn;
  }
};
