// SPDX-License-Identifier: MIT

import { ringsOf } from './edit.ts';
import type { Obstacle, Point } from './protocol.ts';
import { boundsOf, type CellWorld, type PolygonWorld, type Scene, type World } from './scene.ts';
import type { Palette } from './theme.ts';
import type { View } from './view.ts';

/** The context of a canvas that is in the page or is not. */
export type Context = CanvasRenderingContext2D;

export function makeCanvas(
  width: number,
  height: number,
): { canvas: HTMLCanvasElement; context: Context } {
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(width, 1);
  canvas.height = Math.max(height, 1);
  const context = canvas.getContext('2d');
  if (!context) throw new Error('this browser has no canvas');
  return { canvas, context };
}

function addRing(path: Path2D, ring: Point[]): void {
  ring.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  path.closePath();
}

export function obstaclePath(obstacle: Obstacle): Path2D {
  const path = new Path2D();
  if ('polygon' in obstacle) ringsOf(obstacle).forEach((ring) => addRing(path, ring));
  else path.arc(obstacle.center[0], obstacle.center[1], obstacle.radius, 0, 2 * Math.PI);
  return path;
}

/** The edges between blocked and free cells as few long lines. The border of the map is none. */
function blockedEdges(world: CellWorld): Path2D {
  const path = new Path2D();
  const {
    width,
    height,
    free,
    resolution: h,
    origin: [ox, oy],
  } = world;
  const differs = (a: number, b: number): boolean => free[a] !== free[b];
  for (let y = 1; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const first = x;
      while (x < width && differs(y * width + x, (y - 1) * width + x)) ++x;
      if (x === first) continue;
      path.moveTo(ox + first * h, oy + y * h);
      path.lineTo(ox + x * h, oy + y * h);
    }
  }
  for (let x = 1; x < width; ++x) {
    for (let y = 0; y < height; ++y) {
      const first = y;
      while (y < height && differs(y * width + x, y * width + x - 1)) ++y;
      if (y === first) continue;
      path.moveTo(ox + x * h, oy + first * h);
      path.lineTo(ox + x * h, oy + y * h);
    }
  }
  return path;
}

/** One pixel a cell: blocked cells in the colour of obstacles, the others clear. */
function cellImage(world: CellWorld, colour: string): HTMLCanvasElement {
  const { canvas, context } = makeCanvas(world.width, world.height);
  const image = context.createImageData(world.width, world.height);
  const words = new Uint32Array(image.data.buffer);
  const value = Number.parseInt(colour.slice(1), 16);
  // The bytes of a word are red, green, blue, alpha, the first one lowest.
  const word = (0xff000000 | ((value & 0xff) << 16) | (value & 0xff00) | (value >> 16)) >>> 0;
  for (let i = 0; i < words.length; ++i) words[i] = world.free[i] === 1 ? 0 : word;
  context.putImageData(image, 0, 0);
  return canvas;
}

/** What of a world does not depend on the view. */
interface Prepared {
  world: World;
  colour: string;
  obstacles: Path2D[];
  edges: Path2D | null;
  cells: HTMLCanvasElement | null;
}

/** Draws the map: obstacles, cells and their safety zones. It keeps the picture until something changes. */
export class ScenePainter {
  private prepared: Prepared | null = null;
  private layer = makeCanvas(1, 1);
  private key: { world: World; text: string } | null = null;

  draw(
    target: Context,
    scene: Scene,
    view: View,
    palette: Palette,
    pixelRatio: number,
    showZone: boolean,
  ): void {
    const { width, height } = target.canvas;
    const text = [
      view.key,
      scene.radius,
      palette.ground,
      pixelRatio,
      showZone,
      width,
      height,
    ].join();
    if (this.key?.world !== scene.world || this.key.text !== text) {
      this.key = { world: scene.world, text };
      const { canvas, context } = this.layer;
      if (canvas.width !== width || canvas.height !== height) {
        canvas.width = width;
        canvas.height = height;
      }
      this.paint(context, scene, view, palette, pixelRatio, showZone);
    }
    target.setTransform(1, 0, 0, 1, 0, 0);
    target.drawImage(this.layer.canvas, 0, 0);
  }

  private paint(
    context: Context,
    scene: Scene,
    view: View,
    palette: Palette,
    pixelRatio: number,
    showZone: boolean,
  ): void {
    const prepared = this.prepare(scene.world, palette);
    const [x0, y0, x1, y1] = boundsOf(scene.world);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = palette.page;
    context.fillRect(0, 0, context.canvas.width, context.canvas.height);
    context.save();
    view.apply(context, pixelRatio);
    context.fillStyle = palette.ground;
    context.fillRect(x0, y0, x1 - x0, y1 - y0);
    context.beginPath();
    context.rect(x0, y0, x1 - x0, y1 - y0);
    context.clip();
    if (scene.world.kind === 'workspace')
      paintObstacles(context, scene.world, prepared, scene.radius, palette, showZone);
    else paintCells(context, scene.world, prepared, scene.radius, palette, showZone, view);
    context.restore();
    view.apply(context, pixelRatio);
    context.strokeStyle = palette.outline;
    context.lineWidth = 1.2 / view.scale;
    context.strokeRect(x0, y0, x1 - x0, y1 - y0);
  }

  private prepare(world: World, palette: Palette): Prepared {
    if (this.prepared?.world === world && this.prepared.colour === palette.obstacle)
      return this.prepared;
    const isCells = world.kind === 'cells';
    this.prepared = {
      world,
      colour: palette.obstacle,
      obstacles: isCells ? [] : world.obstacles.map(obstaclePath),
      edges: isCells ? blockedEdges(world) : null,
      cells: isCells ? cellImage(world, palette.obstacle) : null,
    };
    return this.prepared;
  }
}

function paintObstacles(
  context: Context,
  world: PolygonWorld,
  { obstacles }: Prepared,
  radius: number,
  palette: Palette,
  showZone: boolean,
): void {
  if (showZone && radius > 0) {
    context.fillStyle = palette.zone;
    context.strokeStyle = palette.zone;
    context.lineWidth = 2 * radius;
    context.lineJoin = 'round';
    obstacles.forEach((path, i) => {
      const obstacle = world.obstacles[i];
      // The zone of a disc is a disc; a stroke wider than the disc would leave a hole.
      if (obstacle && !('polygon' in obstacle)) {
        context.beginPath();
        context.arc(
          obstacle.center[0],
          obstacle.center[1],
          obstacle.radius + radius,
          0,
          2 * Math.PI,
        );
        context.fill();
        return;
      }
      context.fill(path, 'evenodd');
      context.stroke(path);
    });
  }
  context.fillStyle = palette.obstacle;
  for (const path of obstacles) context.fill(path, 'evenodd');
}

function paintCells(
  context: Context,
  world: CellWorld,
  prepared: Prepared,
  radius: number,
  palette: Palette,
  showZone: boolean,
  view: View,
): void {
  const {
    width,
    height,
    resolution: h,
    origin: [x, y],
  } = world;
  if (showZone && radius > 0 && prepared.edges) {
    context.strokeStyle = palette.zone;
    context.lineWidth = 2 * radius;
    context.lineCap = 'round';
    context.stroke(prepared.edges);
  }
  context.imageSmoothingEnabled = false;
  if (prepared.cells) context.drawImage(prepared.cells, x, y, width * h, height * h);
  if (h * view.scale < 9) return;
  context.strokeStyle = palette.faint;
  context.lineWidth = 0.6 / view.scale;
  context.beginPath();
  for (let i = 1; i < width; ++i) {
    context.moveTo(x + i * h, y);
    context.lineTo(x + i * h, y + height * h);
  }
  for (let i = 1; i < height; ++i) {
    context.moveTo(x, y + i * h);
    context.lineTo(x + width * h, y + i * h);
  }
  context.stroke();
}
