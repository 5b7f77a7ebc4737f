// SPDX-License-Identifier: Apache-2.0
// The render modes.

export const drawModes = ['blend', 'mesh', 'points', 'still'] as const;

/**
 * blend: the surfaces of all sensors, blended by how well each sensor sees the surface that the eye sees, with the
 * background model behind them; mesh: the nearest surface only; points: a square for each depth pixel; still: the
 * hub's model of what stands still, without people and what moves.
 */
export type DrawMode = (typeof drawModes)[number];

/** How a room is drawn just now. */
export interface Drawing {
  mode: DrawMode; // as chosen
  mixes: boolean; // surfaces are blended now
  shown: number; // sensors drawn
  wanted: number; // sensors with a picture that are not switched off
}
