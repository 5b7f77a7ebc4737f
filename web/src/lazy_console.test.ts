// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import type { Console } from './console/console';
import { LazyConsole } from './lazy_console';

const nobody = { mayNudge: false, isAdmin: false };
const admin = { mayNudge: true, isAdmin: true };

/** A console that notes what it is told, and a loader that fails `failures` times first. */
function parts(failures = 0) {
  const told: unknown[] = [];
  const made = {
    open: false,
    setOpen: (open: boolean) => void (made.open = open),
    setRights: (rights: unknown) => told.push(rights),
    offer: (frames: unknown) => told.push(frames),
  };
  let loads = 0;
  const load = async () => {
    if (loads++ < failures) throw new Error('no network');
    return made as unknown as Console;
  };
  return { made, told, lazy: new LazyConsole(load), loads: () => loads };
}

describe('the console', () => {
  test('is not loaded for those who may not use it', async () => {
    const { lazy, loads, told } = parts();
    await lazy.offer(nobody);
    lazy.offerFrames([], 0);
    expect([loads(), told]).toEqual([0, []]);
  });

  test('is loaded once for those who may, and knows their rights, also when they lose them', async () => {
    const { lazy, loads, told, made } = parts();
    await Promise.all([lazy.offer(admin), lazy.toggle()]);
    expect([loads(), made.open]).toEqual([1, true]);
    expect(told.at(-1)).toEqual(admin);
    await lazy.offer(nobody);
    expect(told.at(-1)).toEqual(nobody);
    lazy.offerFrames([], 0);
    expect(told.at(-1)).toEqual([]);
    await lazy.toggle();
    expect(made.open).toBe(false);
  });

  test('that could not be loaded is loaded at the next click', async () => {
    const { lazy, made } = parts(1);
    await expect(lazy.offer(admin)).rejects.toThrow('no network');
    await lazy.toggle();
    expect(made.open).toBe(true);
  });
});
