// SPDX-License-Identifier: Apache-2.0
// What scripts of an AudioWorklet find around them, as far as they are used: TypeScript's libraries have no types for it.

interface AudioWorkletProcessor {
  readonly port: MessagePort;
}
declare const AudioWorkletProcessor: { new (): AudioWorkletProcessor };
declare function registerProcessor(name: string, made: new () => AudioWorkletProcessor): void;
declare const currentTime: number; // seconds
declare const currentFrame: number; // samples
