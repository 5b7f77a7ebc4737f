// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { voiceTexts as texts } from '../texts';
import { hearingObstacle, microphoneFault, speakingObstacle } from './obstacle';

const all = { isSecure: true, decodes: true, encodes: true };
const free = { maySpeak: true, isMuted: false };

describe('what is in the way', () => {
  test('of hearing: an insecure page before a browser that cannot', () => {
    expect(hearingObstacle(all)).toBe('');
    expect(hearingObstacle({ ...all, decodes: false })).toBe(texts.noDecoder);
    expect(hearingObstacle({ isSecure: false, decodes: false, encodes: false })).toBe(texts.insecure);
  });
  test('of speaking: what is in the way of hearing, the browser, the room, an admin', () => {
    expect(speakingObstacle(all, free)).toBe('');
    expect(speakingObstacle({ ...all, isSecure: false }, free)).toBe(texts.insecure);
    expect(speakingObstacle({ ...all, encodes: false }, free)).toBe(texts.noEncoder);
    expect(speakingObstacle(all, { maySpeak: false, isMuted: true })).toBe(texts.mayNotSpeak);
    expect(speakingObstacle(all, { maySpeak: true, isMuted: true })).toBe(texts.muted);
  });
  test('of the microphone, by the browser’s error', () => {
    const saidOf = (name: string) => microphoneFault(new DOMException('why', name));
    expect(saidOf('NotAllowedError')).toBe(texts.denied);
    expect(saidOf('NotFoundError')).toBe(texts.noMicrophone);
    expect(saidOf('NotReadableError')).toBe(texts.inUse);
    expect(saidOf('TypeError')).toBe(texts.failed('why'));
  });
});
