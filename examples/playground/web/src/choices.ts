// SPDX-License-Identifier: MIT

import type { AlgorithmDescription, CatalogueReply } from './protocol.ts';
import type { World } from './scene.ts';

/** An algorithm with the options that are not the default ones. */
export interface Choice {
  name: string;
  options: Record<string, string>;
}

/** A search with its smoothers. */
export interface Planner {
  /** Also the number of its colour. */
  id: number;
  search: Choice;
  /** Smoothers one after the other. */
  stages: Choice[];
  seed: number;
  visible: boolean;
}

export function choose(name: string): Choice {
  return { name, options: {} };
}

/** As the command line has it: "rrt_star:max_iterations=5000,goal_bias=0.1". */
export function choiceText({ name, options }: Choice): string {
  const given = Object.entries(options).map(([key, value]) => `${key}=${value}`);
  return given.length > 0 ? `${name}:${given.join(',')}` : name;
}

export function smootherText(planner: Planner): string {
  return planner.stages.map(choiceText).join('+');
}

export function plannerName(planner: Planner): string {
  return `${planner.search.name} with ${planner.stages.map((stage) => stage.name).join('+')}`;
}

export function searchOf(
  catalogue: CatalogueReply | null,
  name: string,
): AlgorithmDescription | undefined {
  return catalogue?.searches.find((search) => search.name === name);
}

export function isForVehicles(catalogue: CatalogueReply | null, planner: Planner): boolean {
  return searchOf(catalogue, planner.search.name)?.for_vehicles ?? false;
}

/** Why the algorithm cannot be used here, or nothing. */
export function unavailable(algorithm: AlgorithmDescription, world: World): string | null {
  if (world.kind === 'workspace' && !algorithm.on_workspace) return 'works on grid maps only';
  if (world.kind === 'cells' && !algorithm.on_cells) return 'works on polygons and discs only';
  return null;
}

/** The smoothers that go with a search: those that keep headings go with searches that plan them. */
export function smoothersFor(catalogue: CatalogueReply, vehicles: boolean): AlgorithmDescription[] {
  return catalogue.smoothers.filter(
    ({ name, for_vehicles }) => name === 'none' || for_vehicles === vehicles,
  );
}

/** The planner with smoothers that go with its search. */
export function matched(catalogue: CatalogueReply, planner: Planner): Planner {
  const vehicles = isForVehicles(catalogue, planner);
  const allowed = smoothersFor(catalogue, vehicles).map(({ name }) => name);
  if (planner.stages.every(({ name }) => allowed.includes(name))) return planner;
  const preferred = vehicles ? 'vehicle_shortcut' : 'clothoid';
  return { ...planner, stages: [choose(allowed.includes(preferred) ? preferred : 'none')] };
}
