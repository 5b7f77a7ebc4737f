// SPDX-License-Identifier: Apache-2.0
// Formats numbers for display.

export function perSecond(value: number): string {
  return value >= 99.5 ? value.toFixed(0) : value.toFixed(1);
}

/** MB are 10^6 bytes. */
export function megabytes(bytes: number): string {
  return (bytes / 1e6).toFixed(2);
}

export function milliseconds(value: number | undefined): string {
  if (value === undefined) return '–';
  return value < 9950 ? `${Math.round(value)} ms` : `${(value / 1000).toFixed(0)} s`;
}

/** Minutes and seconds. */
export function duration(seconds: number): string {
  const whole = Math.floor(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}

export function clockError(error_ms: number | undefined): string {
  if (error_ms === undefined) return '';
  return `±${error_ms < 9.95 ? error_ms.toFixed(1) : error_ms.toFixed(0)}`;
}
