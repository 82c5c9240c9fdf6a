// SPDX-License-Identifier: MIT

import { makeCanvas, type Context } from './draw_scene.ts';
import type { Player } from './player.ts';
import type { SearchEvents } from './protocol.ts';
import type { Palette } from './theme.ts';
import type { View } from './view.ts';

/** Draws the events of a search. Events that follow are added to the picture of those before. */
export class EventPainter {
  private layer = makeCanvas(1, 1);
  private events: SearchEvents | null = null;
  private key = '';
  private drawn = 0;

  draw(
    target: Context,
    player: Player,
    view: View,
    palette: Palette,
    pixelRatio: number,
    square: boolean,
  ): void {
    const { events, shown } = player;
    if (!events || shown === 0) return;
    const { width, height } = target.canvas;
    const key = [view.key, palette.visited, pixelRatio, width, height, square].join();
    const { canvas, context } = this.layer;
    if (this.events !== events || this.key !== key || this.drawn > shown) {
      canvas.width = width;
      canvas.height = height;
      this.events = events;
      this.key = key;
      this.drawn = 0;
    }
    if (this.drawn < shown) {
      const brush = new EventBrush(context, events, view, palette, pixelRatio, square);
      for (let i = this.drawn; i < shown; ++i)
        brush.draw(events.kinds[i], player.offsets[i] ?? 0, false);
      this.drawn = shown;
    }
    target.setTransform(1, 0, 0, 1, 0, 0);
    target.drawImage(canvas, 0, 0);
    if (shown < player.count) {
      new EventBrush(target, events, view, palette, pixelRatio, square).draw(
        events.kinds[shown - 1],
        player.offsets[shown - 1] ?? 0,
        true,
      );
    }
  }
}

/** Draws single events. */
class EventBrush {
  private readonly side: number;

  constructor(
    private readonly context: Context,
    private readonly events: SearchEvents,
    private readonly view: View,
    private readonly palette: Palette,
    pixelRatio: number,
    private readonly square: boolean,
  ) {
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    context.globalAlpha = 1;
    context.setLineDash([]);
    this.side = Math.max(events.cell_size * view.scale, 1.5);
  }

  /** `current` events have the colour of the one that the player has come to. */
  draw(kind: string | undefined, offset: number, current: boolean): void {
    const at = (i: number): number => this.events.coordinates[offset + i] ?? 0;
    const [x, y] = this.view.toScreen([at(0), at(1)]);
    const { palette, context } = this;
    if (kind === 'e' || kind === 'g') {
      context.fillStyle = current
        ? palette.current
        : kind === 'e'
          ? palette.visited
          : palette.generated;
      this.node(x, y, kind === 'e' || current ? 1 : 0.6);
      return;
    }
    const [x1, y1] = this.view.toScreen([at(2), at(3)]);
    if (kind === 'r' || kind === 'R') {
      this.rectangle(
        x,
        y,
        x1,
        y1,
        current
          ? palette.current
          : kind === 'r'
            ? palette.forwardRectangle
            : palette.backwardRectangle,
      );
      return;
    }
    const passage = kind === 'i' ? palette.forwardPassage : palette.backwardPassage;
    this.line(
      x,
      y,
      x1,
      y1,
      current ? palette.current : kind === 't' ? palette.tree : passage,
      kind === 't' ? 1 : 2.5,
    );
  }

  /** Squares fill cells; the nodes of a lattice are dots. */
  private node(x: number, y: number, size: number): void {
    const side = this.side * size;
    if (this.square || side < 4) {
      this.context.fillRect(x - side / 2, y - side / 2, side, side);
      return;
    }
    this.context.beginPath();
    this.context.arc(x, y, 0.37 * side, 0, 2 * Math.PI);
    this.context.fill();
  }

  private rectangle(x0: number, y0: number, x1: number, y1: number, colour: string): void {
    const { context } = this;
    context.fillStyle = colour;
    context.strokeStyle = colour;
    context.lineWidth = 0.8;
    context.globalAlpha = 0.13;
    context.fillRect(x0, y0, x1 - x0, y1 - y0);
    context.globalAlpha = 0.8;
    context.strokeRect(x0, y0, x1 - x0, y1 - y0);
    context.globalAlpha = 1;
  }

  private line(
    x0: number,
    y0: number,
    x1: number,
    y1: number,
    colour: string,
    width: number,
  ): void {
    const { context } = this;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.lineCap = 'round';
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
  }
}
