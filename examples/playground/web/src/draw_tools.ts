// SPDX-License-Identifier: MIT

import type { App } from './app.ts';
import type { Context } from './draw_scene.ts';
import { cellAt, cellCentre } from './scene.ts';
import type { PointerTools } from './tools.ts';

/** Draws what the tools show beside the map: the draft of a polygon, the brush, the cross. */
export function drawTools(
  context: Context,
  app: App,
  tools: PointerTools,
  pixelRatio: number,
  keyboard: boolean,
): void {
  const {
    view,
    theme: { palette },
    scene,
  } = app;
  const { draft, pointer } = tools;
  context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
  const line = pointer && draft.length > 0 ? [...draft, pointer] : draft;
  context.strokeStyle = palette.select;
  context.lineWidth = 1.8;
  context.beginPath();
  line.forEach((point, i) =>
    i === 0 ? context.moveTo(...view.toScreen(point)) : context.lineTo(...view.toScreen(point)),
  );
  context.stroke();
  context.fillStyle = palette.select;
  for (const point of draft) {
    const [x, y] = view.toScreen(point);
    context.fillRect(x - 4, y - 4, 8, 8);
  }
  if (!pointer || app.tool === 'select') return;
  const [x, y] = view.toScreen(pointer);
  if (scene.world.kind === 'cells') {
    const { world } = scene;
    const centre = view.toScreen(cellCentre(world, cellAt(world, pointer)));
    context.beginPath();
    context.arc(
      ...centre,
      Math.max((app.settings.brush / 2) * world.resolution * view.scale, 3),
      0,
      2 * Math.PI,
    );
    context.stroke();
  }
  if (!keyboard) return;
  context.beginPath();
  for (const [dx, dy] of [
    [12, 0],
    [0, 12],
  ] as const) {
    context.moveTo(x - dx, y - dy);
    context.lineTo(x + dx, y + dy);
  }
  context.stroke();
}
