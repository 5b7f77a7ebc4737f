// SPDX-License-Identifier: Apache-2.0
// What a soak has measured: samples of memory and descriptors, recoveries, findings; and the table of them.

export function median(numbers) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

/** Usage of the programs over time. Growth is that of the last third of a life's samples over its first third. */
export class Usage {
  #samples = new Map(); // name -> [{pid, rss_mb, descriptors}]

  add(program) {
    const usage = program.usage();
    if (!usage) return;
    if (!this.#samples.has(program.name)) this.#samples.set(program.name, []);
    this.#samples.get(program.name).push({ pid: program.child.pid, ...usage });
  }

  /** [{name, samples, first, last, growth_percent, descriptors: [first, last]}]; without growth if there are too few. */
  rows(leastSamples) {
    return [...this.#samples].flatMap(([name, samples]) => {
      const [life] = livesOf(samples).sort((a, b) => b.length - a.length);
      if (life.length < leastSamples) return [{ name, samples: life.length }];
      const third = Math.floor(life.length / 3);
      const parts = [life.slice(0, third), life.slice(-third)];
      const of = (key) => parts.map((part) => median(part.map((sample) => sample[key])));
      const [first, last] = of('rss_mb');
      const growth_percent = (100 * (last - first)) / first;
      return [{ name, samples: life.length, first, last, growth_percent, descriptors: of('descriptors') }];
    });
  }
}

/** The samples of each process of a program. */
function livesOf(samples) {
  const lives = new Map();
  for (const sample of samples) lives.set(sample.pid, [...(lives.get(sample.pid) ?? []), sample]);
  return [...lives.values()];
}

/** A table with a head, columns separated by two spaces, numbers to the right. */
export function table(head, rows) {
  const cells = [head, ...rows].map((row) => row.map(String));
  const widths = head.map((_, i) => Math.max(...cells.map((row) => row[i].length)));
  return cells
    .map((row) => row.map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join('  ').trimEnd())
    .join('\n');
}
