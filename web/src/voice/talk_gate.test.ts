// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { loudnessOf, TalkGate } from './talk_gate';

const block = (loudness: number) => new Float32Array(960).fill(loudness);

/** How many of the blocks are sent. */
function sent(gate: TalkGate, loudness: number, blocks: number): number {
  return Array.from({ length: blocks }, () => gate.isOpen(block(loudness))).filter(Boolean).length;
}

describe('the gate', () => {
  test('is closed in silence and opens at once for a voice', () => {
    const gate = new TalkGate();
    expect(sent(gate, 0.0005, 100)).toBe(0);
    expect(gate.isOpen(block(0.1))).toBe(true);
  });
  test('stays open for 400 ms, so that words are not cut off', () => {
    const gate = new TalkGate();
    sent(gate, 0.0005, 10);
    sent(gate, 0.1, 1);
    expect(sent(gate, 0.0005, 100)).toBe(19);
  });
  test('learns the noise of a loud room within seconds', () => {
    const gate = new TalkGate();
    sent(gate, 0.02, 400);
    expect(sent(gate, 0.02, 100)).toBe(0);
    expect(gate.isOpen(block(0.2))).toBe(true);
  });
  test('with push to talk follows the key alone', () => {
    const gate = new TalkGate();
    gate.mode = 'push';
    expect(sent(gate, 0.5, 10)).toBe(0);
    gate.isPushed = true;
    expect(sent(gate, 0, 10)).toBe(10);
  });
  test('measures loudness as root of the mean square', () => {
    expect(loudnessOf(block(0.25))).toBeCloseTo(0.25);
  });
});
