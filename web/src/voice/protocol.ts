// SPDX-License-Identifier: Apache-2.0
// Messages between the page and its voice worker, which encodes and decodes. The voice worker has a port to the worker
// that owns the socket, one to each player of the AudioWorklet, and one to the microphone.
import type { TalkMode } from './talk_gate';

export type ToVoiceWorker =
  | { kind: 'hub'; port: MessagePort } // HeardPackets and Silence come, SpokenPackets go
  | { kind: 'player'; speaker: number; port: MessagePort } // PcmPackets and Silence go
  | { kind: 'gone'; speaker: number }
  | { kind: 'microphone'; port: MessagePort } // RecordedBlocks come
  | { kind: 'talk'; mode: TalkMode; isPushed: boolean; isOn: boolean };

export type FromVoiceWorker =
  | { kind: 'speaks'; speaker: number } // it has no player yet
  | { kind: 'level'; loudness: number; isSent: boolean } // of the microphone, ten times a second
  | { kind: 'fault'; sentence: string }; // of the encoder
