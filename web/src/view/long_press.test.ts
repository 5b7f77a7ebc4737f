// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { LongPress } from './long_press';

const finger = { id: 3, x: 100, y: 100 };

test('a finger that stays is a long press, once', () => {
  const press = new LongPress();
  press.down(finger, 1000);
  expect(press.due(1400)).toBeUndefined();
  press.move({ ...finger, x: 105 });
  expect(press.due(1460)).toMatchObject(finger);
  expect(press.due(1470)).toBeUndefined();
});

test('a drag, a lifted finger and a second one are none', () => {
  const press = new LongPress();
  press.down(finger, 0);
  press.move({ ...finger, y: 120 });
  expect(press.due(1000)).toBeUndefined();
  press.down(finger, 1000);
  press.cancel();
  expect(press.due(2000)).toBeUndefined();
  press.down(finger, 2000);
  press.move({ id: 4, x: 300, y: 300 }); // another finger's way
  expect(press.due(3000)).toMatchObject(finger);
});
