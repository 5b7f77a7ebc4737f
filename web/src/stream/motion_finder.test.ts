// SPDX-License-Identifier: Apache-2.0
import { expect, test, vi } from 'vitest';
import { MotionFinder } from './motion_finder';

const settle = () => new Promise((resolve) => setTimeout(resolve));
const nothing = { take: () => undefined, destroy: () => {} };

test('the module is loaded once, when motion is first wanted', async () => {
  const load = vi.fn(async () => () => nothing);
  const finder = new MotionFinder(load);
  finder.want(false);
  expect(load).not.toHaveBeenCalled();
  for (const isWanted of [true, false, true]) finder.want(isWanted);
  expect(load).toHaveBeenCalledTimes(1);
  expect(finder.make).toBeUndefined();
  await settle();
  expect(finder.make).toBeDefined();
});

test('motion is found only while it is wanted', async () => {
  const finder = new MotionFinder(async () => () => nothing);
  finder.want(true);
  await settle();
  finder.want(false);
  expect(finder.make).toBeUndefined();
  finder.want(true);
  expect(finder.make).toBeDefined();
});

test('a module that cannot be loaded is done without', async () => {
  const finder = new MotionFinder(() => Promise.reject(new Error('the server answered 404')));
  finder.want(true);
  await settle();
  expect(finder.make).toBeUndefined();
});
