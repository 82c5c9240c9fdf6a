// SPDX-License-Identifier: MIT

import type { Movement, Point } from './protocol.ts';
import type { CellWorld, Scene } from './scene.ts';

/** A grid map as a file of this page: `#` is blocked, row 0 is y = 0. */
export interface CellFile {
  tutavia_cells: 1;
  name: string;
  resolution: number;
  origin: Point;
  map?: { origin: Point; yaw: number };
  safety_radius: number;
  movement: Movement;
  y_down: boolean;
  start: Point;
  goals: Point[];
  rows: string[];
}

export function isCellFile(text: string): boolean {
  return /^\s*\{\s*"tutavia_cells"/.test(text);
}

export function cellFile(scene: Scene, world: CellWorld): CellFile {
  const rows = Array.from({ length: world.height }, (_, y) =>
    Array.from(world.free.subarray(y * world.width, (y + 1) * world.width), (free) =>
      free === 1 ? '.' : '#',
    ).join(''),
  );
  return {
    tutavia_cells: 1,
    name: scene.name,
    resolution: world.resolution,
    origin: world.origin,
    ...(world.map && { map: world.map }),
    safety_radius: scene.radius,
    movement: scene.movement,
    y_down: scene.yDown,
    start: scene.start,
    goals: [scene.goal],
    rows,
  };
}

/** The cells of rows of characters; `#` is blocked. */
export function worldOfRows(rows: string[], resolution = 1, origin: Point = [0, 0]): CellWorld {
  const width = rows[0]?.length ?? 0;
  if (width === 0 || rows.some((row) => row.length !== width))
    throw new Error('rows: expected rows of the same length');
  const free = Uint8Array.from(rows.join(''), (character) => (character === '#' ? 0 : 1));
  return { kind: 'cells', width, height: rows.length, resolution, origin, free };
}

function isPoint(value: unknown): value is Point {
  return (
    Array.isArray(value) && value.length === 2 && value.every((number) => Number.isFinite(number))
  );
}

/** Throws an Error if the file is not as `cellFile` makes it. */
export function parseCellFile(text: string, name: string): Scene {
  const file = JSON.parse(text) as Partial<CellFile>;
  const { rows, resolution, origin, start, goals, safety_radius: radius } = file;
  if (!Array.isArray(rows) || !rows.every((row) => typeof row === 'string'))
    throw new Error(`${name}: rows: expected a list of texts`);
  if (!(Number(resolution) > 0)) throw new Error(`${name}: resolution: expected a positive number`);
  if (!isPoint(origin) || !isPoint(start) || !isPoint(goals?.[0]))
    throw new Error(`${name}: origin, start and goals: expected points [x, y]`);
  const world = worldOfRows(rows, Number(resolution), origin);
  return {
    name: file.name ?? name,
    world: { ...world, ...(file.map && { map: file.map }) },
    radius: Number(radius ?? 0),
    movement: file.movement ?? 'no_cut',
    yDown: file.y_down ?? false,
    start,
    goal: goals[0],
    startHeading: 0,
    goalHeading: 0,
  };
}
