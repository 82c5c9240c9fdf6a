// SPDX-License-Identifier: MIT

import type { Movement } from './protocol.ts';

/** A grid of a paper: `#` is blocked, row 0 is y = 0. */
export interface EmbeddedGrid {
  name: string;
  movement: Movement;
  /** Width of the border of blocked cells that the paper lays around obstacles. */
  buffer: number;
  start: [number, number];
  goal: [number, number];
  rows: string[];
}

/** A MovingAI map, gzip and base64. Start and goal are columns and rows from the top. */
export interface EmbeddedFile {
  name: string;
  gzip: string;
  start?: [number, number];
  goal?: [number, number];
}

/** The maps in the page, see embed/maps.ts. */
export interface EmbeddedMaps {
  /** EmbeddedGrid[] as JSON, gzip and base64. */
  grids: string;
  gridNames: string[];
  ros: { yaml: string; name: string; image: string };
  parking: string;
  movingAi: EmbeddedFile[];
}

export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

function inflate(text: string): ReadableStream<Uint8Array<ArrayBuffer>> {
  return new Blob([fromBase64(text)]).stream().pipeThrough(new DecompressionStream('gzip'));
}

/** Inflates gzip data in base64. */
export async function unpack(text: string): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await new Response(inflate(text)).arrayBuffer());
}

/** Compiles a binary that is packed like that, while it is inflated. */
export function compile(text: string): Promise<WebAssembly.Module> {
  return WebAssembly.compileStreaming(
    new Response(inflate(text), { headers: { 'Content-Type': 'application/wasm' } }),
  );
}
