// SPDX-License-Identifier: MIT

import type { Point } from './protocol.ts';

/** A number with so many decimals; a dash where there is none, ∞ where it is infinite. */
export function fixed(value: number | null | undefined, decimals = 3): string {
  if (value === undefined) return '–';
  return value === null || !Number.isFinite(value) ? '∞' : value.toFixed(decimals);
}

export function metres(value: number | null | undefined): string {
  return `${fixed(value)} m`;
}

export function point([x, y]: Point): string {
  return `(${short(x)}, ${short(y)})`;
}

/** Up to four significant decimals, without trailing zeros. */
export function short(value: number): string {
  return String(Number(value.toFixed(Math.abs(value) < 1 ? 4 : 3)));
}

/** Browsers measure time in steps of 0.1 ms. */
export function duration(us: number): string {
  if (us < 100) return '< 0.1 ms';
  return us < 1e6 ? `${(us / 1000).toFixed(1)} ms` : `${(us / 1e6).toFixed(2)} s`;
}

/** How much longer than the shortest path. */
export function excess(ratio: number): string {
  const percent = Math.max((ratio - 1) * 100, 0);
  return percent < 0.005
    ? 'as long as the shortest path there is'
    : `${percent.toFixed(2)} % longer than the shortest path there is`;
}

export function degrees(radians: number): number {
  return Math.round(((radians * 180) / Math.PI) * 10) / 10;
}
export function radians(degree: number): number {
  return (degree * Math.PI) / 180;
}
