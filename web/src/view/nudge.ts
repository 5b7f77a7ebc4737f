// SPDX-License-Identifier: Apache-2.0
// A sensor's pose, pushed along the floor and turned about the vertical by hand. Row-major 4x4 world_from_depth, metres,
// radians, y up. Pure.

export interface Push {
  x: number; // along the world's axes
  y: number;
  z: number;
  turn: number; // about the vertical through the sensor, counter-clockwise seen from above
}

/** The pose after the push: it turns where it stands, then it is shifted. */
export function pushed(worldFromDepth: readonly number[], push: Push): number[] {
  const c = Math.cos(push.turn);
  const s = Math.sin(push.turn);
  const m = worldFromDepth;
  const rotated = [0, 1, 2].map((column) => {
    const x = m[column]!;
    const z = m[8 + column]!;
    return [c * x + s * z, m[4 + column]!, -s * x + c * z] as const;
  });
  const row = (axis: 0 | 1 | 2, shift: number) => [...rotated.map((column) => column[axis]), shift];
  return [
    ...row(0, m[3]! + push.x),
    ...row(1, m[7]! + push.y),
    ...row(2, m[11]! + push.z),
    ...[0, 0, 0, 1],
  ];
}

/** Steps as the person sees them: `heading` is where they look, radians about the vertical, 0 along -z. */
export function alongView(right: number, up: number, forward: number, turn: number, heading: number): Push {
  const c = Math.cos(heading);
  const s = Math.sin(heading);
  return { x: right * c - forward * s, y: up, z: -right * s - forward * c, turn };
}
