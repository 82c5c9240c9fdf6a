// SPDX-License-Identifier: MIT

import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { EmbeddedFile, EmbeddedGrid, EmbeddedMaps } from '../src/embedded.ts';

type Rows = string[];
interface NamedGrid {
  start: [number, number];
  goal: [number, number];
  rows: Rows;
}

/** The sets of the SSA-A* paper have fifteen grids each; the page takes some. */
const gridsOfSet = 3;

/** The three maps of the MovingAI benchmarks that the page offers, if their folder is given. */
const movingAiMaps = ['arena2', '32room_000', 'den520d'];

function packed(path: string): string {
  return gzipSync(readFileSync(path), { level: 9 }).toString('base64');
}

/** The start and the goal of the last, hardest scenario: cells from the top left corner. */
function lastScenario(path: string): { start: [number, number]; goal: [number, number] } | null {
  if (!existsSync(path)) return null;
  const line = readFileSync(path, 'utf8').trimEnd().split('\n').at(-1) ?? '';
  const [x0, y0, x1, y1] = line.split(/\s+/).slice(4, 8).map(Number);
  if (x0 === undefined || y0 === undefined || x1 === undefined || y1 === undefined) return null;
  return { start: [x0, y0], goal: [x1, y1] };
}

function movingAi(folder: string): EmbeddedFile[] {
  return movingAiMaps.map((name) => {
    const map = join(folder, `${name}.map`);
    return { name: `${name}.map`, gzip: packed(map), ...lastScenario(`${map}.scen`) };
  });
}

function paperGrids(data: string): EmbeddedGrid[] {
  const read = <T>(name: string): T => JSON.parse(readFileSync(join(data, name), 'utf8')) as T;
  const jps = read<Record<string, NamedGrid>>('jps_theta_map.json');
  const rea = read<Record<string, NamedGrid>>('rea_maps.json');
  const ssa = read<Record<string, Rows[]>>('ssa_grids.json');
  const grids: EmbeddedGrid[] = [];
  for (const grid of Object.values(jps)) {
    grids.push({ name: 'JPS_Theta*', movement: 'no_cut', buffer: 0, ...grid });
  }
  for (const [name, grid] of Object.entries(rea)) {
    grids.push({ name: `Improved REA*, map ${name}`, movement: 'no_cut', buffer: 1, ...grid });
  }
  for (const [set, all] of Object.entries(ssa)) {
    all.slice(0, gridsOfSet).forEach((rows, i) => {
      const side = rows.length - 1;
      const name = `SSA-A*, ${set.replace('_', ' ')}, grid ${i + 1}`;
      grids.push({ name, movement: 'allow', buffer: 0, start: [0, 0], goal: [side, side], rows });
    });
  }
  return grids;
}

/**
 * The maps that become part of the page: those of the library's tests, and three of the MovingAI
 * benchmarks if a folder of them is given.
 */
export function embeddedMaps(data: string, movingAiFolder: string | undefined): EmbeddedMaps {
  const grids = paperGrids(data);
  return {
    grids: gzipSync(JSON.stringify(grids), { level: 9 }).toString('base64'),
    gridNames: grids.map(({ name }) => name),
    ros: {
      yaml: readFileSync(join(data, 'ros_map/rooms.yaml'), 'utf8'),
      name: 'rooms.pgm',
      image: packed(join(data, 'ros_map/rooms.pgm')),
    },
    parking: readFileSync(join(data, 'parking.json'), 'utf8'),
    movingAi: movingAiFolder ? movingAi(movingAiFolder) : [],
  };
}
