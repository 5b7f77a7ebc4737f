// SPDX-License-Identifier: Apache-2.0
// Why one cannot hear or speak here, as a sentence for people; empty if nothing is in the way.
import { voiceTexts as texts } from '../texts';

/** What a browser offers to this page. */
export interface SoundSupport {
  isSecure: boolean; // WebCodecs and microphones exist on secure pages only
  decodes: boolean;
  encodes: boolean;
}

export function soundSupport(): SoundSupport {
  return {
    isSecure: window.isSecureContext,
    decodes: 'AudioDecoder' in window && 'AudioWorkletNode' in window,
    encodes: 'AudioEncoder' in window && 'mediaDevices' in navigator,
  };
}

export function hearingObstacle({ isSecure, decodes }: SoundSupport): string {
  if (!isSecure) return texts.insecure;
  return decodes ? '' : texts.noDecoder;
}

export interface Rights {
  maySpeak: boolean; // by the rules of the room; also false at a hub of an earlier version
  isMuted: boolean; // by an admin
}

export function speakingObstacle(support: SoundSupport, { maySpeak, isMuted }: Rights): string {
  const hearing = hearingObstacle(support);
  if (hearing) return hearing;
  if (!support.encodes) return texts.noEncoder;
  if (!maySpeak) return texts.mayNotSpeak;
  return isMuted ? texts.muted : '';
}

/** Of navigator.mediaDevices.getUserMedia. */
export function microphoneFault(error: unknown): string {
  const { name, message } = error as DOMException;
  switch (name) {
    case 'NotAllowedError':
    case 'SecurityError':
      return texts.denied;
    case 'NotFoundError':
    case 'OverconstrainedError':
      return texts.noMicrophone;
    case 'NotReadableError':
    case 'AbortError':
      return texts.inUse;
    default:
      return texts.failed(message);
  }
}
