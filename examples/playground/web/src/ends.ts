// SPDX-License-Identifier: MIT

import { isFreeDisc } from './hit.ts';
import type { Point } from './protocol.ts';
import { boundsOf, cellCentre, type World } from './scene.ts';

/** A start and a goal for a map that names none: far apart in the largest free area. */
export function defaultEnds(world: World, radius: number): { start: Point; goal: Point } {
  if (world.kind === 'cells') {
    const { width, height, free } = world;
    const reach = Math.ceil(radius / world.resolution);
    const isFree = (x: number, y: number): boolean => {
      for (let v = Math.max(y - reach, 0); v <= Math.min(y + reach, height - 1); ++v) {
        for (let u = Math.max(x - reach, 0); u <= Math.min(x + reach, width - 1); ++u) {
          if (free[v * width + u] !== 1) return false;
        }
      }
      return true;
    };
    const [a, b] = extremes(width, height, isFree);
    return { start: cellCentre(world, a), goal: cellCentre(world, b) };
  }
  const [x0, y0, x1, y1] = boundsOf(world);
  const n = 40;
  const at = ([i, j]: Point): Point => [
    x0 + ((i + 0.5) / n) * (x1 - x0),
    y0 + ((j + 0.5) / n) * (y1 - y0),
  ];
  const margin = Math.max(radius * 1.05, (x1 - x0) * 1e-3);
  const [a, b] = extremes(n, n, (x, y) => isFreeDisc(world.obstacles, at([x, y]), margin));
  return { start: at(a), goal: at(b) };
}

/** The lowest left and the highest right cell of the largest connected free area. */
function extremes(
  width: number,
  height: number,
  isFree: (x: number, y: number) => boolean,
): [Point, Point] {
  const seen = new Uint8Array(width * height);
  let best: number[] = [];
  for (let seed = 0; seed < seen.length; ++seed) {
    if (seen[seed] || !isFree(seed % width, Math.floor(seed / width))) continue;
    seen[seed] = 1;
    const area = [seed];
    for (let i = 0; i < area.length; ++i) {
      const cell = area[i] ?? 0;
      const [x, y] = [cell % width, Math.floor(cell / width)];
      for (const [nx, ny] of [
        [x + 1, y],
        [x - 1, y],
        [x, y + 1],
        [x, y - 1],
      ] as const) {
        const next = ny * width + nx;
        if (nx < 0 || ny < 0 || nx >= width || ny >= height || seen[next] || !isFree(nx, ny))
          continue;
        seen[next] = 1;
        area.push(next);
      }
    }
    if (area.length > best.length) best = area;
  }
  const cells = best.map((cell): Point => [cell % width, Math.floor(cell / width)]);
  const by = (a: Point, b: Point): number => a[0] + a[1] - b[0] - b[1];
  const first = cells.reduce<Point>((a, b) => (by(b, a) < 0 ? b : a), cells[0] ?? [0, 0]);
  const last = cells.reduce<Point>(
    (a, b) => (by(b, a) > 0 ? b : a),
    cells[0] ?? [width - 1, height - 1],
  );
  return [first, last];
}
