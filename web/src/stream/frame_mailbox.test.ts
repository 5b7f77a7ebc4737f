// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { FrameMailbox } from './frame_mailbox';

interface Frame {
  sensor: number;
  seq: number;
}

function mailbox() {
  const sent: [bigint, Frame[]][] = [];
  const discarded: Frame[] = [];
  const box = new FrameMailbox<Frame>(
    (setId, frames) => sent.push([setId, frames]),
    (frame) => discarded.push(frame),
  );
  return { box, sent, discarded };
}

test('a free page gets a set at once', () => {
  const { box, sent } = mailbox();
  box.put(1n, [{ sensor: 0, seq: 0 }]);
  expect(sent).toEqual([[1n, [{ sensor: 0, seq: 0 }]]]);
});

test('a busy page gets the newest frame of each sensor when it is free again', () => {
  const { box, sent, discarded } = mailbox();
  box.put(1n, [{ sensor: 0, seq: 0 }]);
  box.put(2n, [
    { sensor: 0, seq: 1 },
    { sensor: 1, seq: 0 },
  ]);
  box.put(3n, [{ sensor: 0, seq: 2 }]);
  expect(sent.length).toBe(1);
  box.pageIsFree();
  expect(sent[1]).toEqual([
    3n,
    [
      { sensor: 0, seq: 2 },
      { sensor: 1, seq: 0 },
    ],
  ]);
  expect(discarded).toEqual([{ sensor: 0, seq: 1 }]);
});

test('a free page gets nothing while no frame waits', () => {
  const { box, sent } = mailbox();
  box.pageIsFree();
  expect(sent).toEqual([]);
});
