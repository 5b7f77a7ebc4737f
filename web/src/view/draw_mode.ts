// SPDX-License-Identifier: Apache-2.0
// The render modes.

export const drawModes = ['blend', 'mesh', 'points'] as const;

/**
 * blend: the surfaces of all sensors, blended by how well each sensor sees the surface that the eye sees, with the
 * background model behind them; mesh: the nearest surface only; points: a square for each depth pixel.
 */
export type DrawMode = (typeof drawModes)[number];
