// SPDX-License-Identifier: Apache-2.0
// Reuses pixel buffers that travel to the page and back, so that no frame allocates. By size; a few of each are kept.

const keptPerSize = 24;

export class BufferPool {
  private readonly bySize = new Map<number, ArrayBuffer[]>();

  take(bytes: number): ArrayBuffer {
    return this.bySize.get(bytes)?.pop() ?? new ArrayBuffer(bytes);
  }

  giveBack(buffer: ArrayBuffer): void {
    if (buffer.byteLength === 0) return; // transferred away
    const kept = this.bySize.get(buffer.byteLength) ?? [];
    if (kept.length < keptPerSize) kept.push(buffer);
    this.bySize.set(buffer.byteLength, kept);
  }
}
