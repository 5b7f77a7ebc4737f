// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { lateSensors } from './late_sensors';

const at = (capture_ms: number | undefined, fps = 30, online = true) => ({ capture_ms, entry: { online, fps } });

test('late are those behind the newest picture', () => {
  const sensors = [at(10_000), at(9710), at(9690)];
  expect([...lateSensors(sensors)]).toEqual([sensors[2]]);
});

test('a sensor may send few frames a second', () => {
  expect(lateSensors([at(10_000), at(9100, 2)]).size).toBe(0);
  expect(lateSensors([at(10_000), at(8700, 2)]).size).toBe(1);
});

test('those that send nothing neither are late nor make others late', () => {
  expect(lateSensors([at(10_000, 30, false), at(undefined), at(0)]).size).toBe(0);
  expect(lateSensors([]).size).toBe(0);
});
