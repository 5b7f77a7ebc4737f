// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { pictureName } from './picture_name';

const date = new Date(2026, 2, 7, 9, 5, 3);

test('a picture is named after the room and the time', () => {
  expect(pictureName('lab', date)).toBe('roomcast-lab-2026-03-07-09-05-03.png');
  expect(pictureName('', date)).toBe('roomcast-room-2026-03-07-09-05-03.png');
  expect(pictureName('部屋 2', date)).toBe('roomcast-部屋-2-2026-03-07-09-05-03.png');
});

test('a hostile name of a room does not leave the folder', () => {
  expect(pictureName('../../etc/passwd', date)).toMatch(/^roomcast-etc-passwd-/);
  expect(pictureName('<img src=x>"\n', date)).toMatch(/^roomcast-img-src-x-2026/);
  expect(pictureName('x'.repeat(500), date).length).toBeLessThan(80);
});
