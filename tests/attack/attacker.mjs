// SPDX-License-Identifier: Apache-2.0
// What the attacks in this folder share: random numbers by which an attack can be repeated, the time that they take, and
// the list of what they found.
//   ROOMCAST_ATTACK_SECONDS=3600 ROOMCAST_ATTACK_SEED=7 node --test tests/attack/    # longer, and others
//   ROOMCAST_ATTACK_SEED=7 ROOMCAST_ATTACK_CASE=123 node --test tests/attack/arguments.test.mjs    # one of them again
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';

const defaultSeconds = 40;
const mostFindings = 10;
export const seconds = Number(process.env.ROOMCAST_ATTACK_SECONDS ?? defaultSeconds);
const seed = process.env.ROOMCAST_ATTACK_SEED ?? '1';
const onlyCase = process.env.ROOMCAST_ATTACK_CASE;

/** How long such a test may take, with its preparation. */
export const timeout = { timeout: (seconds + 180) * 1000 };

/** Random numbers of one case: the same in every run with the same seed. */
export class Random {
  #state;
  #bytes = Buffer.alloc(0);

  constructor(...key) {
    this.#state = createHash('sha256').update(key.join(' ')).digest();
  }

  bytes(count) {
    while (this.#bytes.length < count) {
      this.#state = createHash('sha256').update(this.#state).digest();
      this.#bytes = Buffer.concat([this.#bytes, this.#state]);
    }
    const taken = this.#bytes.subarray(0, count);
    this.#bytes = this.#bytes.subarray(count);
    return Buffer.from(taken);
  }

  /** A whole number from 0 to `limit` - 1. */
  below(limit) {
    return Number(this.bytes(6).readUIntBE(0, 6) % limit);
  }

  isTrue(share) {
    return this.below(1_000_000) < share * 1_000_000;
  }

  pick(list) {
    return list[this.below(list.length)];
  }
}

/**
 * Calls `attack(random, number)` for one case after the other, `atATime` of them at once, until the time is over; it
 * returns what is wrong, as sentences. Fails with all of them.
 */
export async function attackInTurn(t, attack, { atATime = 1 } = {}) {
  const end_ms = performance.now() + seconds * 1000;
  const findings = [];
  let next = onlyCase === undefined ? 0 : Number(onlyCase);
  const first = next;
  const isOver = () => performance.now() > end_ms || findings.length >= mostFindings || (onlyCase !== undefined && next > first);
  const attackUntilOver = async () => {
    while (!isOver()) {
      const number = next++;
      const faults = await attack(new Random(t.name, seed, number), number);
      findings.push(...faults.map((fault) => `case ${number}: ${fault}`));
    }
  };
  await Promise.all(Array.from({ length: atATime }, attackUntilOver));
  const count = next - first;
  t.diagnostic(`${count} cases with seed ${seed}`);
  assert.deepEqual(findings, [], `ROOMCAST_ATTACK_SEED=${seed} ROOMCAST_ATTACK_CASE=N repeats case N`);
  assert.ok(count > 0, 'there was time for a case');
}
