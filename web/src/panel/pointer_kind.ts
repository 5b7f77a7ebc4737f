// SPDX-License-Identifier: Apache-2.0
// Whether the room is moved by mouse or by finger: what was used last, and before that what the device has.

export type PointerKind = 'mouse' | 'touch';

export function kindOf(pointerType: string): PointerKind | undefined {
  if (pointerType === 'mouse') return 'mouse';
  return pointerType === 'touch' || pointerType === 'pen' ? 'touch' : undefined;
}

/** Calls `changed` at once, and when another kind is used. */
export function watchPointer(changed: (kind: PointerKind) => void): void {
  let current: PointerKind = matchMedia('(pointer: coarse)').matches ? 'touch' : 'mouse';
  changed(current);
  const used = ({ pointerType }: PointerEvent) => {
    const kind = kindOf(pointerType);
    if (!kind || kind === current) return;
    current = kind;
    changed(kind);
  };
  for (const event of ['pointerdown', 'pointermove'] as const) {
    window.addEventListener(event, used, { capture: true, passive: true });
  }
}
