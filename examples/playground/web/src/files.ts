// SPDX-License-Identifier: MIT

import { required, type Client } from './client.ts';
import { defaultEnds } from './ends.ts';
import type { OpenReply, Point, ScenariosReply } from './protocol.ts';
import { boundsOf, type Scene, type World } from './scene.ts';
import { isCellFile, parseCellFile } from './cell_file.ts';
import { rootValue, yamlNodes } from './yaml_nodes.ts';

export interface FileSettings {
  terrain: 'refused' | 'blocked' | 'free';
  unknown: 'blocked' | 'free';
  wktColumn: string;
}

/** A file by its name and content, from wherever it comes. */
export interface NamedBytes {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

export interface Opened {
  /** None, if there were scenarios only. */
  scene: Scene | null;
  scenarios: ScenariosReply['scenarios'];
  warnings: string[];
}

/** The kinds of files that the file chooser offers. */
export const acceptedFiles =
  '.json,.geojson,.wkt,.csv,.map,.scen,.yaml,.yml,.pgm,.ppm,.png,.bmp,.jpg,.jpeg';

function extension(name: string): string {
  return name.slice(name.lastIndexOf('.') + 1).toLowerCase();
}
function stem(name: string): string {
  return name.replace(/\.[^.]*$/, '');
}

/** The scene of a reply of the engine. What the file does not say is made up. */
export function sceneOf(
  reply: OpenReply,
  bytes: Uint8Array<ArrayBuffer> | undefined,
  name: string,
  yDown: boolean,
): Scene {
  const file = 'workspace' in reply ? reply.workspace : reply.cells;
  const world: World =
    'workspace' in reply
      ? {
          kind: 'workspace',
          bounds: reply.workspace.bounds,
          obstacles: reply.workspace.obstacles,
          ...(reply.workspace.resolution !== undefined && {
            resolution: reply.workspace.resolution,
          }),
        }
      : {
          kind: 'cells',
          width: reply.cells.width,
          height: reply.cells.height,
          resolution: reply.cells.resolution,
          origin: reply.cells.origin,
          ...(reply.cells.map && { map: reply.cells.map }),
          free: bytes ?? new Uint8Array(0),
        };
  const goal = file.goals?.[0];
  const ends =
    file.start && goal ? { start: file.start, goal } : defaultEnds(world, file.safety_radius);
  return {
    name: file.name || name,
    world,
    radius: file.safety_radius,
    movement: 'no_cut',
    yDown,
    start: file.start ?? ends.start,
    goal: goal ?? ends.goal,
    startHeading: 0,
    goalHeading: 0,
  };
}

/** The first column that looks as if it held WKT. */
function guessColumn(csv: string): string {
  const header = (csv.split(/\r?\n/, 1)[0] ?? '')
    .replace(/^\uFEFF/, '')
    .split(/[,;\t]/)
    .map((name) => name.replaceAll('"', '').trim());
  return (
    header.find((name) => /^(wkt|geom|geometry|the_geom|shape)/i.test(name)) ?? header[0] ?? ''
  );
}

async function openRos(
  client: Client,
  yaml: NamedBytes,
  files: NamedBytes[],
  settings: FileSettings,
): Promise<Opened> {
  const nodes = yamlNodes(new TextDecoder().decode(yaml.bytes));
  const base = rootValue(nodes, 'image')?.split('/').at(-1);
  const others = files.filter((file) => file !== yaml);
  const image = others.find(({ name }) => name === base);
  if (!image && base !== undefined)
    throw new Error(`choose or drop its image ${base} together with it`);
  const { reply, bytes } = await required(
    client.call(
      { do: 'open_ros', name: yaml.name, yaml: nodes, unknown: settings.unknown },
      image?.bytes,
    ),
  );
  return {
    scene: sceneOf(reply, bytes, stem(yaml.name), false),
    scenarios: [],
    warnings: reply.warnings,
  };
}

/** Adds the name of the file to an error, unless it is there. */
async function named<T>(name: string, work: Promise<T>): Promise<T> {
  try {
    return await work;
  } catch (error) {
    const text = error instanceof Error ? error.message : String(error);
    throw new Error(text.includes(name) ? text : `${name}: ${text}`);
  }
}

async function openMap(
  client: Client,
  { name, bytes }: NamedBytes,
  settings: FileSettings,
): Promise<Opened> {
  const kind = extension(name);
  const text = new TextDecoder().decode(bytes);
  if (kind === 'json' && isCellFile(text))
    return { scene: parseCellFile(text, name), scenarios: [], warnings: [] };
  const column = kind === 'csv' ? { wkt_column: settings.wktColumn || guessColumn(text) } : {};
  const opened = await required(
    client.call({ do: 'open', name, terrain: settings.terrain, ...column }, bytes),
  );
  return {
    scene: sceneOf(opened.reply, opened.bytes, stem(name), kind === 'map'),
    scenarios: [],
    warnings: opened.reply.warnings,
  };
}

/** Opens the files that were chosen or dropped together. Throws an Error with what is wrong. */
export async function openFiles(
  client: Client,
  files: NamedBytes[],
  settings: FileSettings,
): Promise<Opened> {
  const yaml = files.find(({ name }) => /^ya?ml$/.test(extension(name)));
  if (yaml) return named(yaml.name, openRos(client, yaml, files, settings));
  const scen = files.find(({ name }) => extension(name) === 'scen');
  const map = files.find((file) => file !== scen);
  const opened: Opened = map
    ? await named(map.name, openMap(client, map, settings))
    : { scene: null, scenarios: [], warnings: [] };
  if (scen) {
    const { reply } = await named(
      scen.name,
      required(client.call({ do: 'open_scenarios', name: scen.name }, scen.bytes)),
    );
    opened.scenarios = reply.scenarios;
  }
  return opened;
}

/** The scene with the start and goal of a scenario, both in the frame of the grid. */
export function withScenario(scene: Scene, { start, goal }: { start: Point; goal: Point }): Scene {
  if (scene.world.kind !== 'cells')
    throw new Error('Scenarios are for grid maps: open them together with their .map file.');
  const [x0, y0, x1, y1] = boundsOf(scene.world);
  const fits = [start, goal].every(([x, y]) => x > x0 && x < x1 && y > y0 && y < y1);
  if (!fits)
    throw new Error('The scenario lies outside of this map: open it together with its .map file.');
  return { ...scene, start, goal };
}
