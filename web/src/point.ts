// SPDX-License-Identifier: Apache-2.0
// A point as it is written in an address.
import { Vector3 } from 'three';

/** "1,2.5,-3" in metres; undefined for anything else. */
export function parsePoint(text: string | null): Vector3 | undefined {
  const numbers = text?.split(',').map((part) => (part.trim() === '' ? NaN : Number(part))) ?? [];
  if (numbers.length !== 3 || !numbers.every(Number.isFinite)) return undefined;
  return new Vector3(...(numbers as [number, number, number]));
}
