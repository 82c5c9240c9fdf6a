// SPDX-License-Identifier: MIT

import { itemPoint, partsOf, ringsOf, splitEdge, type Item } from './edit.ts';
import type { Obstacle, Point } from './protocol.ts';
import type { Scene } from './scene.ts';
import type { View } from './view.ts';

/** Length of the arrows of headings [px]. */
export const armPixels = 44;

function contains(ring: Point[], [x, y]: Point): boolean {
  let inside = false;
  ring.forEach(([ax, ay], i) => {
    const [bx, by] = ring[(i + 1) % ring.length] ?? [ax, ay];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
  });
  return inside;
}

function distanceToRing(ring: Point[], [x, y]: Point): number {
  return ring.reduce((least, [ax, ay], i) => {
    const [bx, by] = ring[(i + 1) % ring.length] ?? [ax, ay];
    const [ux, uy] = [bx - ax, by - ay];
    const t = Math.min(Math.max(((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy || 1), 0), 1);
    return Math.min(least, Math.hypot(x - ax - t * ux, y - ay - t * uy));
  }, Infinity);
}

/** Whether a point is on an obstacle, or so near that it counts. */
function isOn(obstacle: Obstacle, at: Point, tolerance: number): boolean {
  if (!('polygon' in obstacle))
    return (
      Math.hypot(at[0] - obstacle.center[0], at[1] - obstacle.center[1]) <=
      obstacle.radius + tolerance
    );
  const rings = ringsOf(obstacle);
  return (
    rings.filter((ring) => contains(ring, at)).length % 2 === 1 ||
    rings.some((ring) => distanceToRing(ring, at) <= tolerance)
  );
}

/** The item under a pixel. Handles of the selected obstacle come before obstacles. */
export function itemAt(
  scene: Scene,
  view: View,
  pixel: Point,
  selection: Item | null,
  headings: boolean,
  reach: number,
): Item | null {
  const arm = armPixels / view.scale;
  const isNear = (item: Item): boolean => {
    const at = itemPoint(scene, item, arm);
    if (!at) return false;
    const [x, y] = view.toScreen(at);
    return Math.hypot(x - pixel[0], y - pixel[1]) <= reach;
  };
  const ends: Item[] = [
    ...(headings ? [{ kind: 'startHeading' } as const, { kind: 'goalHeading' } as const] : []),
    { kind: 'goal' },
    { kind: 'start' },
  ];
  const handles = selection && 'index' in selection ? partsOf(scene, selection.index) : [];
  const handle = [...ends, ...handles].find(isNear);
  if (handle) return handle;
  if (scene.world.kind !== 'workspace') return null;
  const at = view.toWorld(pixel);
  const index = scene.world.obstacles.findLastIndex((obstacle) =>
    isOn(obstacle, at, 4 / view.scale),
  );
  return index < 0 ? null : { kind: 'obstacle', index };
}

/** Whether a disc touches no obstacle. */
export function isFreeDisc(obstacles: readonly Obstacle[], centre: Point, radius: number): boolean {
  return !obstacles.some((obstacle) => isOn(obstacle, centre, radius));
}

/** The vertex before the edge that is nearest to a point. */
export function nearestEdge(scene: Scene, index: number, at: Point): Item | null {
  let best: { item: Item; distance: number } | null = null;
  for (const item of partsOf(scene, index)) {
    const a = itemPoint(scene, item, 0);
    const middle = splitEdge(scene, item);
    if (item.kind !== 'vertex' || !a) continue;
    const m = itemPoint(middle, { ...item, vertex: item.vertex + 1 }, 0);
    if (!m) continue;
    const half = [m[0] - a[0], m[1] - a[1]] as const;
    const t = Math.min(
      Math.max(
        ((at[0] - a[0]) * half[0] + (at[1] - a[1]) * half[1]) / (half[0] ** 2 + half[1] ** 2 || 1),
        0,
      ),
      2,
    );
    const distance = Math.hypot(at[0] - a[0] - t * half[0], at[1] - a[1] - t * half[1]);
    if (!best || distance < best.distance) best = { item, distance };
  }
  return best?.item ?? null;
}
