// SPDX-License-Identifier: Apache-2.0
// A colour for each sensor, the same in the panel and in the room. After Okabe and Ito (2008): distinguishable for
// colour-blind people too.

const colors = ['#56b4e9', '#e69f00', '#009e73', '#cc79a7', '#f0e442', '#0072b2', '#d55e00', '#999999'] as const;

export function sensorColor(id: number): string {
  return colors[id % colors.length]!;
}
