// SPDX-License-Identifier: MIT

import type {
  CellScene,
  Movement,
  Obstacle,
  Point,
  SceneRequest,
  WorkspaceScene,
} from './protocol.ts';

export type Bounds = [number, number, number, number];

export interface PolygonWorld {
  kind: 'workspace';
  bounds: Bounds;
  obstacles: readonly Obstacle[];
  /** Lattice spacing; the engine chooses one without it. */
  resolution?: number;
}
export interface CellWorld {
  kind: 'cells';
  width: number;
  height: number;
  resolution: number;
  origin: Point;
  map?: { origin: Point; yaw: number };
  /** Row by row, row 0 is y = 0; 1 is free. */
  free: Uint8Array<ArrayBuffer>;
}
export type World = PolygonWorld | CellWorld;

/** All that a plan is made for. A scene never changes: an edit makes another one, which shares what
 * stayed the same, so that a comparison of references tells what to send and to draw again. */
export interface Scene {
  name: string;
  world: World;
  radius: number;
  start: Point;
  goal: Point;
  /** [rad] */
  startHeading: number;
  goalHeading: number;
  movement: Movement;
  /** The y axis points down, as in the files of image-like maps. */
  yDown: boolean;
}

export function boundsOf(world: World): Bounds {
  if (world.kind === 'workspace') return world.bounds;
  const {
    origin: [x, y],
    width,
    height,
    resolution,
  } = world;
  return [x, y, x + width * resolution, y + height * resolution];
}

export function cellAt(world: CellWorld, [x, y]: Point): Point {
  return [
    Math.floor((x - world.origin[0]) / world.resolution),
    Math.floor((y - world.origin[1]) / world.resolution),
  ];
}

export function cellCentre(world: CellWorld, [x, y]: Point): Point {
  return [
    world.origin[0] + (x + 0.5) * world.resolution,
    world.origin[1] + (y + 0.5) * world.resolution,
  ];
}

/** From the frame of a map to that of its grid; results are in the former, all else in the latter. */
export function toGridFrame(world: World, [x, y]: Point): Point {
  if (world.kind !== 'cells' || !world.map) return [x, y];
  const { origin, yaw } = world.map;
  const c = Math.cos(yaw);
  const s = Math.sin(yaw);
  const dx = x - origin[0];
  const dy = y - origin[1];
  return [world.origin[0] + c * dx + s * dy, world.origin[1] + c * dy - s * dx];
}

/** The inverse of `toGridFrame`. */
export function toMapFrame(world: World, [x, y]: Point): Point {
  if (world.kind !== 'cells' || !world.map) return [x, y];
  const { origin, yaw } = world.map;
  const c = Math.cos(yaw);
  const s = Math.sin(yaw);
  const dx = x - world.origin[0];
  const dy = y - world.origin[1];
  return [origin[0] + c * dx - s * dy, origin[1] + s * dx + c * dy];
}

export function workspaceOf(scene: Scene, world: PolygonWorld): WorkspaceScene {
  return {
    name: scene.name,
    bounds: world.bounds,
    safety_radius: scene.radius,
    ...(world.resolution !== undefined && { resolution: world.resolution }),
    start: scene.start,
    goals: [scene.goal],
    obstacles: [...world.obstacles],
  };
}

export function cellsOf(scene: Scene, world: CellWorld): CellScene {
  const { width, height, resolution, origin, map } = world;
  return {
    name: scene.name,
    width,
    height,
    resolution,
    origin,
    ...(map && { map }),
    y_down: scene.yDown,
    safety_radius: scene.radius,
    start: scene.start,
    goals: [scene.goal],
  };
}

export function sceneRequest(scene: Scene): { request: SceneRequest; bytes?: Uint8Array } {
  const { world, movement } = scene;
  if (world.kind === 'workspace')
    return { request: { do: 'scene', workspace: workspaceOf(scene, world), movement } };
  return { request: { do: 'scene', cells: cellsOf(scene, world), movement }, bytes: world.free };
}

/** Whether the engine has to be told: it keeps all but the ends of the way. */
export function sameSpace(a: Scene, b: Scene): boolean {
  return a.world === b.world && a.radius === b.radius && a.movement === b.movement;
}

/** Past and future scenes. */
export class History {
  private past: Scene[] = [];
  private future: Scene[] = [];
  private static readonly limit = 60;

  get canUndo(): boolean {
    return this.past.length > 0;
  }
  get canRedo(): boolean {
    return this.future.length > 0;
  }
  clear(): void {
    this.past = [];
    this.future = [];
  }
  /** Call before a change, with the scene as it was. */
  push(scene: Scene): void {
    if (this.past.at(-1) === scene) return;
    this.past.push(scene);
    if (this.past.length > History.limit) this.past.shift();
    this.future = [];
  }
  /** Call after a change that may have changed nothing. */
  dropUnchanged(scene: Scene): void {
    if (this.past.at(-1) === scene) this.past.pop();
  }
  undo(now: Scene): Scene {
    const scene = this.past.pop();
    if (!scene) return now;
    this.future.push(now);
    return scene;
  }
  redo(now: Scene): Scene {
    const scene = this.future.pop();
    if (!scene) return now;
    this.past.push(now);
    return scene;
  }
}
