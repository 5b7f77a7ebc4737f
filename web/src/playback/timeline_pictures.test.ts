// SPDX-License-Identifier: Apache-2.0
import { beforeAll, describe, expect, test, vi } from 'vitest';
import type { Part } from './part';
import { momentsOf, pictureIn, TimelinePictures } from './timeline_pictures';

/** Enough of a document for the strip. */
beforeAll(() => {
  vi.stubGlobal('document', {
    createElement: (name: string) => {
      const attributes: Record<string, string> = {};
      const children: unknown[] = [];
      return {
        name, children, hidden: true,
        append: (...more: unknown[]) => children.push(...more),
        setAttribute: (key: string, value: string) => (attributes[key] = value),
        addEventListener: () => undefined,
      };
    },
  });
});

function frameMessage(key: boolean): Uint8Array {
  const section = [2, 1, 0, 0, 3, 0, 0, 0, 1, 2, 3];
  const message = new Uint8Array(48 + section.length);
  const view = new DataView(message.buffer);
  view.setUint16(0, 0x4352, true);
  message[2] = 1;
  message[3] = 1;
  view.setUint16(4, 48, true);
  view.setUint16(6, key ? 1 : 0, true);
  view.setUint32(40, section.length, true);
  message.set(section, 48);
  return message;
}

const partOf = (...messages: Uint8Array[]): Part => ({
  from_s: 0, until_s: 0, next: undefined, isDamaged: false,
  records: messages.map((message) => ({ isPast: true, time_s: 0, message })),
});

function strip(answer: (sensor: string, at_s: number) => Part, bytesEach = 50_000) {
  const asked: string[] = [];
  const painted: number[] = [];
  const source = {
    received_bytes: 0,
    keyFrame: (sensor: string, at_s: number) => {
      asked.push(`${sensor} ${at_s}`);
      source.received_bytes += bytesEach;
      try {
        return Promise.resolve(answer(sensor, at_s));
      } catch (error) {
        return Promise.reject(error as Error);
      }
    },
  };
  const painter = {
    paint: (vp9: Uint8Array) => {
      painted.push(vp9.length);
      return Promise.resolve(true);
    },
    close: () => painted.push(-1),
  };
  const pictures = new TimelinePictures(source, painter, { sensors: () => ['a', 'b'], isBusy: () => false, seek: () => undefined });
  return { pictures, asked, painted };
}

describe('pictures along the timeline', () => {
  test('are of the middles of equal shares, as many as fit', () => {
    expect(momentsOf(80, 300)).toEqual([10, 30, 50, 70]);
    expect(momentsOf(60, 100).length).toBe(4);
    expect(momentsOf(60, 9000).length).toBe(16);
  });

  test('are key frames with colour', () => {
    expect([...pictureIn(partOf(frameMessage(true)))!]).toEqual([1, 2, 3]);
    expect(pictureIn(partOf(frameMessage(false)))).toBeUndefined();
    expect(pictureIn(partOf())).toBeUndefined();
    expect(() => pictureIn(partOf(new Uint8Array(60)))).toThrow();
  });

  test('are of the sensor that has had one, so that they show the same place', async () => {
    const { pictures, asked, painted } = strip((sensor) => (sensor === 'a' ? partOf() : partOf(frameMessage(true))));
    await pictures.load(40, 300);
    expect(asked).toEqual(['a 5', 'b 5', 'b 15', 'b 25', 'b 35']);
    expect(painted).toEqual([3, 3, 3, 3, -1]);
    expect(pictures.root.hidden).toBe(false);
  });

  test('end with a limit of bytes, and without a word where the hub has none', async () => {
    const rich = strip(() => partOf(frameMessage(true)), 4_000_000);
    await rich.pictures.load(40, 300);
    expect(rich.asked.length).toBe(2);
    const old = strip(() => {
      throw new Error('404');
    });
    await old.pictures.load(40, 300);
    await old.pictures.load(40, 300);
    expect(old.asked.length).toBe(1);
    expect(old.pictures.root.hidden).toBe(true);
  });
});
