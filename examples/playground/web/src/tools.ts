// SPDX-License-Identifier: MIT

import type { App, ToolName } from './app.ts';
import { addObstacle, itemPoint, moveItem, paint, splitEdge, type Item } from './edit.ts';
import { armPixels, itemAt, nearestEdge } from './hit.ts';
import type { Point } from './protocol.ts';
import { boundsOf, type Scene } from './scene.ts';

/** What the pointer is doing between press and release. */
type Drag =
  | { kind: 'pan'; last: Point }
  | { kind: 'item'; item: Item; grip: Point; scene: Scene; moved: boolean }
  | { kind: 'disc'; centre: Point; scene: Scene }
  | { kind: 'paint'; last: Point; free: boolean };

export function toolProblem(app: App, tool: ToolName): string | null {
  const isCells = app.scene.world.kind === 'cells';
  if ((tool === 'polygon' || tool === 'disc') && isCells)
    return 'This is a grid map: paint its cells instead.';
  if ((tool === 'paint' || tool === 'erase') && !isCells)
    return 'This map has no cells: draw polygons and discs instead.';
  return null;
}

/** Pointer tools on the canvas: mouse, pen and touch. */
export class PointerTools {
  /** Vertices of a polygon that is being drawn. */
  draft: Point[] = [];
  /** Where the pointer is, or the cross that the keyboard moves. */
  pointer: Point | null = null;
  private hover: Item | null = null;
  private drag: Drag | null = null;
  private touches = new Map<number, Point>();
  /** The distance of two fingers, and their middle. */
  private pinch = 0;
  private lastMiddle: Point | null = null;

  constructor(
    private readonly app: App,
    private readonly canvas: HTMLCanvasElement,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', (event) => this.up(event));
    canvas.addEventListener('pointerleave', () => this.leave());
    canvas.addEventListener('dblclick', (event) => this.doubleClick(event));
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
  }

  choose(tool: ToolName): void {
    const problem = toolProblem(this.app, tool);
    if (problem) {
      this.app.notice = { kind: 'note', text: problem };
    } else {
      this.app.tool = tool;
      this.app.notice = null;
      this.draft = [];
    }
    this.app.redraw();
  }

  /** Adds a vertex to the polygon that is being drawn. */
  addVertex(at: Point): void {
    const last = this.draft.at(-1);
    if (last && Math.hypot(last[0] - at[0], last[1] - at[1]) * this.app.view.scale < 2) return;
    this.draft = [...this.draft, at];
    this.app.redraw();
  }
  closePolygon(): void {
    if (this.draft.length >= 3) {
      this.app.edit(addObstacle(this.app.scene, { polygon: this.draft }));
      this.selectLast();
    }
    this.draft = [];
    this.app.redraw();
  }
  cancelDraft(): void {
    this.draft = [];
    this.app.selection = null;
    this.app.redraw();
  }
  /** Whether the next click closes the polygon. */
  closesAt(pixel: Point): boolean {
    const first = this.draft[0];
    if (!first || this.draft.length < 3) return false;
    const [x, y] = this.app.view.toScreen(first);
    return Math.hypot(x - pixel[0], y - pixel[1]) < 14;
  }

  private selectLast(): void {
    const { world } = this.app.scene;
    if (world.kind === 'workspace')
      this.app.selection = { kind: 'obstacle', index: world.obstacles.length - 1 };
  }

  private pixel(event: MouseEvent): Point {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  private down(event: PointerEvent): void {
    if (event.button > 1) return;
    this.canvas.setPointerCapture(event.pointerId);
    const pixel = this.pixel(event);
    this.touches.set(event.pointerId, pixel);
    if (this.touches.size === 2) {
      this.finish();
      this.pinch = this.spread();
      this.lastMiddle = null;
      return;
    }
    if (this.touches.size > 2) return;
    this.pointer = this.app.view.toWorld(pixel);
    this.start(pixel, event);
    this.app.redraw();
  }

  private start(pixel: Point, event: PointerEvent): void {
    const { app } = this;
    const at = app.view.toWorld(pixel);
    if (event.button === 1) {
      this.drag = { kind: 'pan', last: pixel };
      return;
    }
    switch (app.tool) {
      case 'polygon':
        if (this.closesAt(pixel)) this.closePolygon();
        else this.addVertex(at);
        return;
      case 'disc':
        app.beginGesture();
        this.drag = { kind: 'disc', centre: at, scene: app.scene };
        return;
      case 'paint':
      case 'erase':
        app.beginGesture();
        this.drag = { kind: 'paint', last: at, free: app.tool === 'erase' };
        app.edit(paint(app.scene, at, at, app.settings.brush, app.tool === 'erase'));
        return;
      case 'select':
        this.grab(pixel, at, event.pointerType === 'mouse' ? 11 : 22);
    }
  }

  private grab(pixel: Point, at: Point, reach: number): void {
    const { app } = this;
    const item = itemAt(app.scene, app.view, pixel, app.selection, app.hasVehicles, reach);
    if (!item) {
      app.selection = null;
      this.drag = { kind: 'pan', last: pixel };
      return;
    }
    app.selection = item;
    const origin = itemPoint(app.scene, item, armPixels / app.view.scale) ?? at;
    const isObstacle = item.kind === 'obstacle';
    this.drag = {
      kind: 'item',
      item,
      grip: isObstacle ? [at[0] - origin[0], at[1] - origin[1]] : [0, 0],
      scene: app.scene,
      moved: false,
    };
  }

  private move(event: PointerEvent): void {
    const { app } = this;
    const pixel = this.pixel(event);
    if (this.touches.has(event.pointerId)) this.touches.set(event.pointerId, pixel);
    if (this.touches.size === 2) {
      this.pinchTo();
      return;
    }
    const at = app.view.toWorld(pixel);
    this.pointer = at;
    if (this.drag) this.dragTo(this.drag, pixel, at);
    else
      this.hover =
        app.tool === 'select'
          ? itemAt(app.scene, app.view, pixel, app.selection, app.hasVehicles, 11)
          : null;
    this.canvas.style.cursor = this.cursor();
    app.redraw();
  }

  private dragTo(drag: Drag, pixel: Point, at: Point): void {
    const { app } = this;
    switch (drag.kind) {
      case 'pan':
        app.view.pan(pixel[0] - drag.last[0], pixel[1] - drag.last[1]);
        drag.last = pixel;
        return;
      case 'item':
        if (!drag.moved) app.beginGesture();
        drag.moved = true;
        app.edit(moveItem(app.scene, drag.item, [at[0] - drag.grip[0], at[1] - drag.grip[1]]));
        return;
      case 'disc': {
        const radius = Math.hypot(at[0] - drag.centre[0], at[1] - drag.centre[1]);
        if (radius * app.view.scale > 3)
          app.edit(addObstacle(drag.scene, { center: drag.centre, radius }));
        return;
      }
      case 'paint':
        app.edit(paint(app.scene, drag.last, at, app.settings.brush, drag.free));
        drag.last = at;
    }
  }

  private up(event: PointerEvent): void {
    this.touches.delete(event.pointerId);
    if (this.drag?.kind === 'disc' && this.app.scene !== this.drag.scene) this.selectLast();
    this.finish();
    if (event.pointerType !== 'mouse') this.pointer = null;
    this.app.redraw();
  }

  private finish(): void {
    this.drag = null;
    if (this.app.inGesture) this.app.endGesture();
  }

  private leave(): void {
    if (this.drag) return;
    this.pointer = null;
    this.hover = null;
    this.app.redraw();
  }

  private spread(): number {
    const [a, b] = [...this.touches.values()];
    return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  }

  private pinchTo(): void {
    const [a, b] = [...this.touches.values()];
    if (!a || !b) return;
    const middle: Point = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    const spread = this.spread();
    if (this.lastMiddle)
      this.app.view.pan(middle[0] - this.lastMiddle[0], middle[1] - this.lastMiddle[1]);
    if (this.pinch > 0) this.app.view.zoomAt(middle, spread / this.pinch);
    this.pinch = spread;
    this.lastMiddle = middle;
    this.app.redraw();
  }

  private doubleClick(event: MouseEvent): void {
    const { app } = this;
    if (app.tool === 'polygon') {
      this.closePolygon();
      return;
    }
    if (app.tool !== 'select' || !app.selection || !('index' in app.selection)) return;
    const at = app.view.toWorld(this.pixel(event));
    const nearest = nearestEdge(app.scene, app.selection.index, at);
    if (!nearest || app.selection.kind === 'vertex') return;
    const split = splitEdge(app.scene, nearest);
    const added: Item =
      nearest.kind === 'vertex' ? { ...nearest, vertex: nearest.vertex + 1 } : nearest;
    app.edit(moveItem(split, added, at));
    app.selection = added;
    app.redraw();
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const step = event.deltaMode === 1 ? event.deltaY * 16 : event.deltaY;
    this.app.view.zoomAt(
      this.pixel(event),
      Math.exp(-Math.max(-120, Math.min(120, step)) * 0.0022),
    );
    this.app.redraw();
  }

  private cursor(): string {
    if (this.app.tool !== 'select') return 'crosshair';
    if (this.drag) return 'grabbing';
    return this.hover ? 'grab' : 'default';
  }

  /** The middle of the map, where the keyboard's cross starts. */
  ensurePointer(): Point {
    if (!this.pointer) {
      const [x0, y0, x1, y1] = boundsOf(this.app.scene.world);
      this.pointer = [(x0 + x1) / 2, (y0 + y1) / 2];
    }
    return this.pointer;
  }
}
