// SPDX-License-Identifier: Apache-2.0
// The marks of the room as the hub tells them. Pure.
import type { Mark, Marks } from '../gen/control_pb';

export class MarkCollection {
  private readonly marks = new Map<number, Mark>();

  /** Oldest first. */
  get list(): readonly Mark[] {
    return [...this.marks.values()];
  }

  clear(): void {
    this.marks.clear();
  }

  take({ all, marks, removed }: Pick<Marks, 'all' | 'marks' | 'removed'>): void {
    if (all) this.marks.clear();
    marks.forEach((mark) => this.marks.set(mark.id, mark));
    removed.forEach((id) => this.marks.delete(id));
  }
}
