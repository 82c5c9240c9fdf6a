// SPDX-License-Identifier: MIT

import type { Obstacle, Point } from './protocol.ts';
import { boundsOf, cellAt, type CellWorld, type PolygonWorld, type Scene } from './scene.ts';

/** Something that can be selected and moved. Ring 0 of a polygon is its border, others are holes. */
export type Item =
  | { kind: 'start' | 'goal' | 'startHeading' | 'goalHeading' }
  | { kind: 'obstacle' | 'size'; index: number }
  | { kind: 'vertex'; index: number; ring: number; vertex: number };

export function sameItem(a: Item | null, b: Item | null): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

export function ringsOf(obstacle: Obstacle | undefined): Point[][] {
  return obstacle && 'polygon' in obstacle ? [obstacle.polygon, ...(obstacle.holes ?? [])] : [];
}

/** All items, in the order in which the keyboard goes through them. */
export function itemsOf(scene: Scene, headings: boolean): Item[] {
  const items: Item[] = [{ kind: 'start' }, { kind: 'goal' }];
  if (headings) items.push({ kind: 'startHeading' }, { kind: 'goalHeading' });
  if (scene.world.kind === 'workspace')
    scene.world.obstacles.forEach((_, index) => items.push({ kind: 'obstacle', index }));
  return items;
}

/** The vertices of an obstacle, or the handle of a disc's radius. */
export function partsOf(scene: Scene, index: number): Item[] {
  const obstacle = obstacleAt(scene, index);
  if (!obstacle) return [];
  if (!('polygon' in obstacle)) return [{ kind: 'size', index }];
  return ringsOf(obstacle).flatMap((points, ring) =>
    points.map((_, vertex): Item => ({ kind: 'vertex', index, ring, vertex })),
  );
}

export function obstacleAt(scene: Scene, index: number): Obstacle | undefined {
  return scene.world.kind === 'workspace' ? scene.world.obstacles[index] : undefined;
}

export function itemName(scene: Scene, item: Item): string {
  switch (item.kind) {
    case 'start':
      return 'start';
    case 'goal':
      return 'goal';
    case 'startHeading':
      return 'heading at the start';
    case 'goalHeading':
      return 'heading at the goal';
    case 'size':
      return `radius of disc ${item.index + 1}`;
    case 'vertex':
      return `vertex ${item.vertex + 1}${item.ring > 0 ? ` of hole ${item.ring}` : ''} of polygon ${item.index + 1}`;
    case 'obstacle': {
      const obstacle = obstacleAt(scene, item.index);
      return `${obstacle && 'polygon' in obstacle ? 'polygon' : 'disc'} ${item.index + 1}`;
    }
  }
}

/** Where an item is; of a polygon the mean of its vertices. `arm` is the length of heading arrows. */
export function itemPoint(scene: Scene, item: Item, arm: number): Point | null {
  const along = ([x, y]: Point, heading: number): Point => [
    x + arm * Math.cos(heading),
    y + arm * Math.sin(heading),
  ];
  switch (item.kind) {
    case 'start':
      return scene.start;
    case 'goal':
      return scene.goal;
    case 'startHeading':
      return along(scene.start, scene.startHeading);
    case 'goalHeading':
      return along(scene.goal, scene.goalHeading);
    case 'vertex':
      return ringsOf(obstacleAt(scene, item.index))[item.ring]?.[item.vertex] ?? null;
    case 'size':
    case 'obstacle': {
      const obstacle = obstacleAt(scene, item.index);
      if (!obstacle) return null;
      if (!('polygon' in obstacle)) {
        const [x, y] = obstacle.center;
        return item.kind === 'size' ? [x + obstacle.radius, y] : [x, y];
      }
      const n = obstacle.polygon.length;
      const sum = obstacle.polygon.reduce<Point>((a, b) => [a[0] + b[0], a[1] + b[1]], [0, 0]);
      return [sum[0] / n, sum[1] / n];
    }
  }
}

function withObstacles(
  scene: Scene,
  change: (obstacles: Obstacle[], world: PolygonWorld) => Obstacle[],
): Scene {
  const { world } = scene;
  if (world.kind !== 'workspace') return scene;
  return { ...scene, world: { ...world, obstacles: change([...world.obstacles], world) } };
}

function inBounds(scene: Scene, [x, y]: Point): Point {
  const [x0, y0, x1, y1] = boundsOf(scene.world);
  return [Math.min(Math.max(x, x0), x1), Math.min(Math.max(y, y0), y1)];
}

function withRing(
  obstacle: Obstacle,
  ring: number,
  change: (points: Point[]) => Point[],
): Obstacle {
  if (!('polygon' in obstacle)) return obstacle;
  if (ring === 0) return { ...obstacle, polygon: change([...obstacle.polygon]) };
  return {
    ...obstacle,
    holes: (obstacle.holes ?? []).map((hole, i) => (i === ring - 1 ? change([...hole]) : hole)),
  };
}

function withObstacle(
  scene: Scene,
  index: number,
  change: (obstacle: Obstacle) => Obstacle,
): Scene {
  return withObstacles(scene, (all) =>
    all.map((obstacle, i) => (i === index ? change(obstacle) : obstacle)),
  );
}

function translated(obstacle: Obstacle, [dx, dy]: Point): Obstacle {
  const move = ([x, y]: Point): Point => [x + dx, y + dy];
  if (!('polygon' in obstacle)) return { ...obstacle, center: move(obstacle.center) };
  return {
    polygon: obstacle.polygon.map(move),
    ...(obstacle.holes && { holes: obstacle.holes.map((hole) => hole.map(move)) }),
  };
}

/** Moves an item to a point; headings turn towards it. */
export function moveItem(scene: Scene, item: Item, to: Point): Scene {
  const towards = ([x, y]: Point): number => Math.atan2(to[1] - y, to[0] - x);
  switch (item.kind) {
    case 'start':
      return { ...scene, start: inBounds(scene, to) };
    case 'goal':
      return { ...scene, goal: inBounds(scene, to) };
    case 'startHeading':
      return { ...scene, startHeading: towards(scene.start) };
    case 'goalHeading':
      return { ...scene, goalHeading: towards(scene.goal) };
    case 'vertex':
      return withObstacle(scene, item.index, (obstacle) =>
        withRing(obstacle, item.ring, (points) =>
          points.map((point, i) => (i === item.vertex ? to : point)),
        ),
      );
    case 'size':
      return withObstacle(scene, item.index, (obstacle) => {
        if ('polygon' in obstacle) return obstacle;
        return {
          ...obstacle,
          radius: Math.max(
            Math.hypot(to[0] - obstacle.center[0], to[1] - obstacle.center[1]),
            1e-3,
          ),
        };
      });
    case 'obstacle': {
      const at = itemPoint(scene, item, 0);
      return at
        ? withObstacle(scene, item.index, (obstacle) =>
            translated(obstacle, [to[0] - at[0], to[1] - at[1]]),
          )
        : scene;
    }
  }
}

export function addObstacle(scene: Scene, obstacle: Obstacle): Scene {
  return withObstacles(scene, (all) => [...all, obstacle]);
}

/** Removes an obstacle, or a vertex where at least three others stay. */
export function removeItem(scene: Scene, item: Item): Scene {
  if (item.kind === 'obstacle' || item.kind === 'size')
    return withObstacles(scene, (all) => all.filter((_, i) => i !== item.index));
  if (item.kind !== 'vertex') return scene;
  const ring = ringsOf(obstacleAt(scene, item.index))[item.ring] ?? [];
  if (ring.length <= 3) return scene;
  return withObstacle(scene, item.index, (obstacle) =>
    withRing(obstacle, item.ring, (points) => points.filter((_, i) => i !== item.vertex)),
  );
}

/** Adds a vertex in the middle of the edge that follows a vertex. */
export function splitEdge(scene: Scene, item: Item): Scene {
  if (item.kind !== 'vertex') return scene;
  return withObstacle(scene, item.index, (obstacle) =>
    withRing(obstacle, item.ring, (points) => {
      const a = points[item.vertex];
      const b = points[(item.vertex + 1) % points.length];
      if (!a || !b) return points;
      return points.toSpliced(item.vertex + 1, 0, [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
    }),
  );
}

/** Sets the cells within a disc around a line. */
export function paint(scene: Scene, from: Point, to: Point, brush: number, free: boolean): Scene {
  const { world } = scene;
  if (world.kind !== 'cells') return scene;
  const cells = world.free.slice();
  const [x0, y0] = cellAt(world, from);
  const [x1, y1] = cellAt(world, to);
  const steps = Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0), 1);
  let changed = false;
  for (let i = 0; i <= steps; ++i) {
    const x = Math.round(x0 + ((x1 - x0) * i) / steps);
    const y = Math.round(y0 + ((y1 - y0) * i) / steps);
    changed = stamp(world, cells, x, y, brush, free ? 1 : 0) || changed;
  }
  return changed ? { ...scene, world: { ...world, free: cells } } : scene;
}

function stamp(
  world: CellWorld,
  cells: Uint8Array,
  x: number,
  y: number,
  brush: number,
  value: number,
): boolean {
  const first = -Math.floor(brush / 2);
  const middle = first + (brush - 1) / 2;
  let changed = false;
  for (let dy = first; dy < first + brush; ++dy) {
    for (let dx = first; dx < first + brush; ++dx) {
      const [cx, cy] = [x + dx, y + dy];
      if (
        Math.hypot(dx - middle, dy - middle) > brush / 2 + 0.21 ||
        cx < 0 ||
        cy < 0 ||
        cx >= world.width ||
        cy >= world.height
      )
        continue;
      const at = cy * world.width + cx;
      if (cells[at] === value) continue;
      cells[at] = value;
      changed = true;
    }
  }
  return changed;
}
