// SPDX-License-Identifier: Apache-2.0
// The values of a figure over the last minutes, one per second, for charts.

export const keptReadings = 180;

export class History {
  private readonly kept: (number | undefined)[] = [];

  /** `undefined`: there is no value. */
  add(value: number | undefined): void {
    this.kept.push(value);
    if (this.kept.length > keptReadings) this.kept.shift();
  }

  get readings(): readonly (number | undefined)[] {
    return this.kept;
  }
}

/** An SVG path over `width` x `height`, the newest value at the right edge, interrupted where values are missing. */
export function chartPath(
  readings: readonly (number | undefined)[],
  most: number,
  width: number,
  height: number,
): string {
  const step = width / (keptReadings - 1);
  const start = keptReadings - readings.length;
  let path = '';
  let pen = 'M';
  readings.forEach((value, i) => {
    if (value === undefined) {
      pen = 'M';
      return;
    }
    const y = height * (1 - Math.min(1, Math.max(0, value / most)));
    path += `${pen}${((start + i) * step).toFixed(1)} ${y.toFixed(1)}`;
    pen = 'L';
  });
  return path;
}

/** A round number that is at least as large as all values. */
export function scaleOf(readings: readonly (number | undefined)[], least: number): number {
  const most = Math.max(least, ...readings.map((value) => value ?? 0));
  const power = 10 ** Math.floor(Math.log10(most));
  return [1, 2, 5, 10].map((factor) => factor * power).find((round) => round >= most)!;
}

/** The value at a share of the chart's width, 1 being now, and how long ago that was. */
export function readingAt(readings: readonly (number | undefined)[], share: number): { value: number | undefined; age_s: number } {
  const age_s = Math.round((1 - Math.min(1, Math.max(0, share))) * (keptReadings - 1));
  return { value: readings[readings.length - 1 - age_s], age_s };
}
