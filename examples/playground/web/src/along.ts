// SPDX-License-Identifier: MIT

import type { PlanReply, Point, SpeedSamples } from './protocol.ts';

/** The index of the last value that is at most `value`, and how far it is to the next, 0 to 1. */
function locate(values: number[], value: number): [number, number] {
  let [low, high] = [0, values.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((values[middle] ?? 0) <= value) low = middle;
    else high = middle - 1;
  }
  const [a, b] = [values[low] ?? 0, values[low + 1] ?? values[low] ?? 0];
  return [low, b > a ? Math.min(Math.max((value - a) / (b - a), 0), 1) : 0];
}

/** A list's value at an arc length; null where it is infinite. */
export function valueAlong(s: number[], list: (number | null)[], along: number): number | null {
  const [i, t] = locate(s, along);
  const a = list[i] ?? null;
  const b = list[i + 1] ?? a;
  return a === null || b === null ? null : a + t * (b - a);
}

/** Where the robot is at an arc length of its path. */
export function robotAlong(
  reply: PlanReply | undefined,
  along: number,
): { at: Point; heading: number } | null {
  const curve = reply?.curve ?? reply?.route;
  if (!curve || curve.s.length === 0) return null;
  const [i] = locate(curve.s, along);
  return {
    at: [valueAlong(curve.s, curve.x, along) ?? 0, valueAlong(curve.s, curve.y, along) ?? 0],
    heading: curve.heading[i] ?? 0,
  };
}

export function lengthOf(reply: PlanReply | undefined): number {
  return (reply?.curve ?? reply?.route)?.s.at(-1) ?? 0;
}

export function speedOf(reply: PlanReply | undefined): SpeedSamples | null {
  return reply?.speed && 'time' in reply.speed ? reply.speed : null;
}

/** The arc length at a moment of the drive. */
export function alongAt(speed: SpeedSamples, time: number): number {
  return valueAlong(speed.time, speed.s, time) ?? 0;
}
/** The moment at an arc length. */
export function timeAt(speed: SpeedSamples, along: number): number {
  return valueAlong(speed.s, speed.time, along) ?? 0;
}
