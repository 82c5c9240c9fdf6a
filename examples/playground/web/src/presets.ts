// SPDX-License-Identifier: MIT

import maps from 'virtual:maps';
import { choose, type Planner } from './choices.ts';
import { worldOfRows } from './cell_file.ts';
import { required, type Client } from './client.ts';
import { unpack, type EmbeddedGrid } from './embedded.ts';
import { defaultEnds } from './ends.ts';
import { openFiles, sceneOf, withScenario, type FileSettings } from './files.ts';
import type { VehicleChoice } from './protocol.ts';
import { cellCentre, type CellWorld, type Scene } from './scene.ts';

/** A map with what is planned on it. */
export interface PresetContent {
  scene: Scene;
  planner?: Omit<Planner, 'id' | 'visible'>;
  vehicle?: VehicleChoice;
  note?: string;
}

export interface Preset {
  id: string;
  group: string;
  label: string;
  load(client: Client, settings: FileSettings): Promise<PresetContent>;
}

const movingAiNote =
  'From the MovingAI benchmarks (N. Sturtevant, Benchmarks for Grid-Based Pathfinding, IEEE Transactions on Computational Intelligence and AI in Games 4(2), 2012), unchanged; Open Data Commons Attribution License.';

const builtins: [string, string][] = [
  ['maze', 'Maze'],
  ['array', 'Array'],
  ['complex', 'Complex'],
  ['rrt_scene_1', 'RRT* paper, scene 1'],
  ['rrt_scene_2', 'RRT* paper, scene 2'],
];

function builtin([name, label]: [string, string]): Preset {
  return {
    id: name,
    group: 'Built in',
    label,
    async load(client) {
      const { reply, bytes } = await required(client.call({ do: 'builtin', name }));
      return { scene: sceneOf(reply, bytes, name, false) };
    },
  };
}

const parking: Preset = {
  id: 'parking',
  group: 'Built in',
  label: 'Parking, for a car',
  async load(client, settings) {
    const file = { name: 'parking.json', bytes: new TextEncoder().encode(maps.parking) };
    const { scene } = await openFiles(client, [file], settings);
    if (!scene) throw new Error('parking.json has no scene');
    return {
      scene: { ...scene, startHeading: 0, goalHeading: Math.PI / 2 },
      planner: { search: choose('hybrid_astar'), stages: [choose('vehicle_shortcut')], seed: 1 },
      vehicle: {
        min_turning_radius: 5,
        reverse: true,
        car: { length: 4.5, width: 1.8, wheelbase: 2.7 },
      },
    };
  },
};

/** The border of blocked cells of the "Improved REA*" paper: start and goal stay free. */
function withBuffer(world: CellWorld, width: number, keep: [number, number][]): CellWorld {
  const free = world.free.slice();
  world.free.forEach((isFree, at) => {
    if (isFree) return;
    const [x, y] = [at % world.width, Math.floor(at / world.width)];
    for (let v = Math.max(y - width, 0); v <= Math.min(y + width, world.height - 1); ++v) {
      free.fill(
        0,
        v * world.width + Math.max(x - width, 0),
        v * world.width + Math.min(x + width, world.width - 1) + 1,
      );
    }
  });
  for (const [x, y] of keep) free[y * world.width + x] = 1;
  return { ...world, free };
}

function gridScene(grid: EmbeddedGrid): Scene {
  const plain = worldOfRows(grid.rows);
  const world = grid.buffer > 0 ? withBuffer(plain, grid.buffer, [grid.start, grid.goal]) : plain;
  return {
    name: grid.name,
    world,
    radius: 0,
    movement: grid.movement,
    yDown: true,
    startHeading: 0,
    goalHeading: 0,
    start: cellCentre(world, grid.start),
    goal: cellCentre(world, grid.goal),
  };
}

let grids: Promise<EmbeddedGrid[]> | null = null;

/** The grids of the papers. They are inflated when the first one is wanted. */
function paperGrids(): Promise<EmbeddedGrid[]> {
  grids ??= unpack(maps.grids).then(
    (bytes) => JSON.parse(new TextDecoder().decode(bytes)) as EmbeddedGrid[],
  );
  return grids;
}

function paper(name: string): Preset {
  return {
    id: name,
    group: 'Grids of papers',
    label: name,
    async load() {
      const grid = (await paperGrids()).find((each) => each.name === name);
      if (!grid) throw new Error(`There is no grid ${name}.`);
      return { scene: gridScene(grid) };
    },
  };
}

const rooms: Preset = {
  id: 'ros',
  group: 'Maps of robots',
  label: 'ROS map, rooms',
  async load(client, settings) {
    const files = [
      { name: 'rooms.yaml', bytes: new TextEncoder().encode(maps.ros.yaml) },
      { name: maps.ros.name, bytes: await unpack(maps.ros.image) },
    ];
    const { scene } = await openFiles(client, files, settings);
    if (!scene) throw new Error('rooms.yaml has no map');
    return { scene: { ...scene, radius: 0.2, ...defaultEnds(scene.world, 0.2) } };
  },
};

function movingAi(file: (typeof maps.movingAi)[number]): Preset {
  return {
    id: file.name,
    group: 'MovingAI benchmarks',
    label: file.name.replace('.map', ''),
    async load(client, settings) {
      const { scene } = await openFiles(
        client,
        [{ name: file.name, bytes: await unpack(file.gzip) }],
        { ...settings, terrain: 'blocked' },
      );
      if (!scene) throw new Error(`${file.name} has no map`);
      const { start, goal } = file;
      if (!start || !goal || scene.world.kind !== 'cells') return { scene, note: movingAiNote };
      const ends = { start: cellCentre(scene.world, start), goal: cellCentre(scene.world, goal) };
      return { scene: withScenario(scene, ends), note: movingAiNote };
    },
  };
}

function empty(kind: 'polygons' | 'cells'): Preset {
  const common = { movement: 'no_cut' as const, yDown: false, startHeading: 0, goalHeading: 0 };
  return {
    id: `empty ${kind}`,
    group: 'Empty',
    label: kind === 'cells' ? 'Empty grid map' : 'Empty map for polygons and discs',
    async load() {
      if (kind === 'polygons') {
        const world = {
          kind: 'workspace' as const,
          bounds: [0, 0, 20, 15] as [number, number, number, number],
          obstacles: [],
        };
        return {
          scene: { ...common, name: 'drawn', world, radius: 0.3, start: [2, 2], goal: [18, 13] },
        };
      }
      const world = worldOfRows(
        Array.from({ length: 45 }, () => '.'.repeat(60)),
        0.25,
      );
      return {
        scene: {
          ...common,
          name: 'painted',
          world,
          radius: 0.3,
          start: [1.125, 1.125],
          goal: [13.875, 10.125],
        },
      };
    },
  };
}

export const presets: Preset[] = [
  ...builtins.map(builtin),
  parking,
  ...maps.gridNames.map(paper),
  rooms,
  ...maps.movingAi.map(movingAi),
  empty('polygons'),
  empty('cells'),
];
