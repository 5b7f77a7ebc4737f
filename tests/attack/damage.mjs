// SPDX-License-Identifier: Apache-2.0
// Damages bytes in the ways in which disks, transfers, editors and enemies do.

const mostFlips = 16;
const mostRun = 64;
const longAddition = 300_000;
const nastyNumbers = ['nan', '-1', '0', '1e400', '-1e400', '1e-400', '99999999999999999999', '0.1e', 'null', '""', '[]', '{}', '1'.repeat(500)];
const nastyTexts = ['\u0000', '\u001b[31m', '\u202e', '"', '\\', '../../../../etc/passwd', '/dev/zero', 'a'.repeat(5_000), '\ud800', '{'.repeat(2_000), '['.repeat(20_000)];

const damages = {
  cut: (bytes, random) => bytes.subarray(0, random.below(bytes.length + 1)),
  headless: (bytes, random) => bytes.subarray(random.below(bytes.length + 1)),
  flipped(bytes, random) {
    for (let n = 1 + random.below(mostFlips); n > 0 && bytes.length > 0; --n) bytes[random.below(bytes.length)] ^= 1 << random.below(8);
    return bytes;
  },
  overwritten(bytes, random) {
    const at = random.below(bytes.length + 1);
    const run = Buffer.alloc(random.below(mostRun), random.pick([0x00, 0xff, 0x7f, 0x80]));
    return Buffer.concat([bytes.subarray(0, at), run, bytes.subarray(at + run.length)]);
  },
  noisy(bytes, random) {
    const at = random.below(bytes.length + 1);
    const run = random.bytes(random.below(mostRun));
    return Buffer.concat([bytes.subarray(0, at), run, bytes.subarray(at + run.length)]);
  },
  lacking(bytes, random) {
    const at = random.below(bytes.length + 1);
    return Buffer.concat([bytes.subarray(0, at), bytes.subarray(at + random.below(mostRun))]);
  },
  repeated(bytes, random) {
    const [from, to] = [random.below(bytes.length + 1), random.below(bytes.length + 1)].sort((a, b) => a - b);
    return Buffer.concat([bytes.subarray(0, to), bytes.subarray(from)]);
  },
  swapped(bytes, random) {
    const [a, b] = [random.below(bytes.length + 1), random.below(bytes.length + 1)].sort((x, y) => x - y);
    return Buffer.concat([bytes.subarray(b), bytes.subarray(a, b), bytes.subarray(0, a)]);
  },
  long: (bytes, random) => Buffer.concat([bytes, Buffer.alloc(random.below(longAddition), random.pick([0, 0x20, 0xff]))]),
  renumbered(bytes, random) {
    const text = bytes.toString('latin1');
    const numbers = [...text.matchAll(/-?\d+(\.\d+)?(e[-+]?\d+)?/g)];
    if (numbers.length === 0) return damages.flipped(bytes, random);
    const { 0: number, index } = random.pick(numbers);
    return Buffer.from(text.slice(0, index) + random.pick(nastyNumbers) + text.slice(index + number.length), 'latin1');
  },
  reworded(bytes, random) {
    const at = random.below(bytes.length + 1);
    return Buffer.concat([bytes.subarray(0, at), Buffer.from(random.pick(nastyTexts)), bytes.subarray(at)]);
  },
};

/** A damaged copy of `bytes`: one or two of these happened to it. */
export function damaged(bytes, random) {
  let copy = Buffer.from(bytes);
  for (let n = 1 + random.below(2); n > 0; --n) copy = Buffer.from(damages[random.pick(Object.keys(damages))](copy, random));
  return copy;
}
