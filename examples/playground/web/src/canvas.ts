// SPDX-License-Identifier: MIT

import type { App } from './app.ts';
import { EventPainter } from './draw_events.ts';
import { drawPlans } from './draw_plans.ts';
import { drawRobots } from './draw_robot.ts';
import { ScenePainter } from './draw_scene.ts';
import { drawTools } from './draw_tools.ts';
import type { Keyboard } from './keyboard.ts';
import { boundsOf } from './scene.ts';
import type { PointerTools } from './tools.ts';

/** The picture of the map, from the ground to the handles. */
export class MapCanvas {
  private readonly context: CanvasRenderingContext2D;
  private readonly scenes = new ScenePainter();
  private readonly events = new EventPainter();

  constructor(
    private readonly app: App,
    readonly canvas: HTMLCanvasElement,
  ) {
    const context = canvas.getContext('2d', { alpha: false });
    if (!context) throw new Error('this browser has no canvas');
    this.context = context;
  }

  /** Whether the size of the canvas in the page has changed. */
  resize(): boolean {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const ratio = this.pixelRatio;
    const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (width === 0 || (this.canvas.width === w && this.canvas.height === h)) return false;
    this.canvas.width = w;
    this.canvas.height = h;
    this.app.view.resize(width, height);
    return true;
  }

  /** More than two pixels for one cost time and show no more. */
  get pixelRatio(): number {
    return Math.min(window.devicePixelRatio || 1, 2);
  }

  /** Draws within the bounds of the map. */
  private clipped(draw: () => void): void {
    const { app, context } = this;
    const [x0, y0, x1, y1] = boundsOf(app.scene.world);
    context.save();
    app.view.apply(context, this.pixelRatio);
    context.beginPath();
    context.rect(x0, y0, x1 - x0, y1 - y0);
    context.clip();
    draw();
    context.restore();
  }

  draw(pointer: PointerTools, keyboard: Keyboard): void {
    const { app, context, pixelRatio } = this;
    const { palette } = app.theme;
    this.scenes.draw(context, app.scene, app.view, palette, pixelRatio, app.settings.showZone);
    if (app.settings.showSearch && app.outcomes.get(app.active)?.complete) {
      this.clipped(() =>
        this.events.draw(
          context,
          app.player,
          app.view,
          palette,
          pixelRatio,
          app.scene.world.kind === 'cells',
        ),
      );
    }
    drawPlans(context, app, pixelRatio);
    drawRobots(
      context,
      app,
      pixelRatio,
      keyboard.isInUse && document.activeElement === this.canvas,
    );
    drawTools(context, app, pointer, pixelRatio, keyboard.isInUse);
  }
}
