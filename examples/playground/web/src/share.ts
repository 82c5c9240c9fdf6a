// SPDX-License-Identifier: MIT

import type { App, Settings } from './app.ts';
import type { Planner } from './choices.ts';
import { fromBase64 } from './embedded.ts';
import type { CellWorld, PolygonWorld, Scene } from './scene.ts';

/** What a link holds. Cells are bits, eight in a byte, in base64. */
interface Shared {
  v: 1;
  scene: Omit<Scene, 'world'> & {
    world: PolygonWorld | (Omit<CellWorld, 'free'> & { bits: string });
  };
  planners: Planner[];
  active: number;
  vehicle: Settings['vehicle'];
  speed: Settings['speed'];
}

const prefix = '#s=';

function toBase64(bytes: Uint8Array): string {
  let binary = '';
  // A call takes only so many arguments.
  for (let i = 0; i < bytes.length; i += 8192)
    binary += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(binary);
}

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  transform: CompressionStream | DecompressionStream,
): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytes]).stream().pipeThrough(transform);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function packBits(free: Uint8Array): string {
  const bits = new Uint8Array(Math.ceil(free.length / 8));
  free.forEach((isFree, i) => {
    if (isFree) bits[i >> 3] = (bits[i >> 3] ?? 0) | (1 << (i & 7));
  });
  return toBase64(bits);
}

function unpackBits(text: string, count: number): Uint8Array<ArrayBuffer> {
  const bits = fromBase64(text);
  return Uint8Array.from({ length: count }, (_, i) => ((bits[i >> 3] ?? 0) >> (i & 7)) & 1);
}

/** The scene and the planners as the fragment of an address. */
export async function toFragment(app: App): Promise<string> {
  const { scene, settings } = app;
  const { world } = scene;
  let shared: Shared['scene'];
  if (world.kind === 'workspace') {
    shared = { ...scene, world };
  } else {
    const { free, ...rest } = world;
    shared = { ...scene, world: { ...rest, bits: packBits(free) } };
  }
  const content: Shared = {
    v: 1,
    scene: shared,
    planners: app.planners,
    active: app.active,
    vehicle: settings.vehicle,
    speed: settings.speed,
  };
  const packed = await through(
    new TextEncoder().encode(JSON.stringify(content)),
    new CompressionStream('deflate-raw'),
  );
  return prefix + toBase64(packed).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

export interface Restored {
  scene: Scene;
  planners: Planner[];
  active: number;
  settings: Pick<Settings, 'vehicle' | 'speed'>;
}

/** The content of such a fragment; nothing, if it is none. Throws an Error if it is damaged. */
export async function fromFragment(fragment: string): Promise<Restored | null> {
  if (!fragment.startsWith(prefix)) return null;
  let content: Shared;
  try {
    const packed = fromBase64(
      fragment.slice(prefix.length).replaceAll('-', '+').replaceAll('_', '/'),
    );
    content = JSON.parse(
      new TextDecoder().decode(await through(packed, new DecompressionStream('deflate-raw'))),
    ) as Shared;
  } catch {
    throw new Error('The address of this page is damaged: its scene cannot be read.');
  }
  if (content.v !== 1)
    throw new Error('The address of this page is of another version of the playground.');
  if (!isComplete(content)) throw new Error('The address of this page lacks a part of its scene.');
  const { world } = content.scene;
  const restored: Scene =
    world.kind === 'workspace'
      ? { ...content.scene, world }
      : {
          ...content.scene,
          world: {
            ...withoutBits(world),
            free: unpackBits(world.bits, world.width * world.height),
          },
        };
  return {
    scene: restored,
    planners: content.planners,
    active: content.active,
    settings: { vehicle: content.vehicle, speed: content.speed },
  };
}

/** Whether what the page relies on is there. The engine checks the rest. */
function isComplete({ scene, planners, vehicle, speed }: Shared): boolean {
  const isPoint = (value: unknown): boolean =>
    Array.isArray(value) && value.length === 2 && value.every(Number.isFinite);
  const isWorld = (world: Partial<Shared['scene']['world']> | undefined): boolean =>
    world?.kind === 'workspace'
      ? Array.isArray(world.obstacles) && Array.isArray(world.bounds)
      : world?.kind === 'cells' &&
        typeof world.bits === 'string' &&
        isPoint(world.origin) &&
        Number.isInteger(world.width) &&
        Number.isInteger(world.height) &&
        // One character of base64 holds six cells.
        Number(world.width) * Number(world.height) <= 6 * world.bits.length;
  return (
    isWorld(scene?.world) &&
    isPoint(scene.start) &&
    isPoint(scene.goal) &&
    Number.isFinite(scene.radius) &&
    Array.isArray(planners) &&
    planners.length > 0 &&
    planners.every(({ id, search, stages }) => Number.isInteger(id) && search && stages) &&
    Boolean(vehicle && speed)
  );
}

function withoutBits({
  bits: _,
  ...rest
}: Omit<CellWorld, 'free'> & { bits: string }): Omit<CellWorld, 'free'> {
  return rest;
}
