// SPDX-License-Identifier: MIT

import type { App, ToolName } from './app.ts';
import {
  addObstacle,
  itemPoint,
  itemsOf,
  moveItem,
  paint,
  partsOf,
  removeItem,
  sameItem,
  splitEdge,
  type Item,
} from './edit.ts';
import type { Point } from './protocol.ts';
import { boundsOf } from './scene.ts';
import type { PointerTools } from './tools.ts';

/** The shortcuts, for the help dialog. */
export const shortcuts: [string, string][] = [
  [
    'Arrow keys',
    'move the selected start, goal, obstacle or vertex, turn a heading; without a selection move the map',
  ],
  ['Shift with arrows', 'move ten times as far'],
  ['Alt with arrows', 'move a tenth as far'],
  ['N, P', 'select the next or previous of start, goal, headings and obstacles'],
  ['Enter, Escape', 'go to the vertices of a polygon or the radius of a disc, and back'],
  ['S, G', 'select the start, the goal'],
  ['Delete', 'remove the selected obstacle or vertex'],
  ['I', 'insert a vertex after the selected one'],
  ['V, O, D, B, E', 'tools: select, polygon, disc, paint blocked cells, erase to free cells'],
  ['Arrow keys, Enter', 'with a drawing tool: move the cross; set a vertex, a disc, or paint'],
  ['C', 'close the polygon that is being drawn'],
  ['[ and ]', 'smaller and larger radius of the robot'],
  ['+, -, 0', 'zoom in, zoom out, show the whole map'],
  ['Space', 'play or pause the search'],
  [', and .', 'one event of the search back or forward'],
  ['Ctrl+Z, Ctrl+Y', 'undo, redo'],
  ['T', 'light or dark'],
  ['?', 'this list'],
];

const tools: Record<string, ToolName> = {
  v: 'select',
  o: 'polygon',
  d: 'disc',
  b: 'paint',
  e: 'erase',
};
const arrows: Record<string, Point> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** What the keyboard starts besides edits. */
export interface KeyboardActions {
  play(): void;
  step(by: number): void;
  help(): void;
  theme(): void;
  changeRadius(steps: number): void;
}

/** Keys on the canvas. Undo and redo work on the whole page. */
export class Keyboard {
  /** The last thing was a key on the canvas, not the pointer. */
  isInUse = false;
  private settle = 0;

  constructor(
    private readonly app: App,
    private readonly pointer: PointerTools,
    private readonly actions: KeyboardActions,
    canvas: HTMLCanvasElement,
  ) {
    canvas.addEventListener('keydown', (event) => this.key(event));
    canvas.addEventListener('pointerdown', () => (this.isInUse = false));
    window.addEventListener('keydown', (event) => this.anywhere(event));
  }

  private anywhere(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    const isText = target.matches('input:not([type=range]):not([type=checkbox]), textarea, select');
    if (isText) return;
    if (event.ctrlKey || event.metaKey) {
      const key = event.key.toLowerCase();
      if (key === 'z' && !event.shiftKey) this.app.undo();
      else if (key === 'y' || (key === 'z' && event.shiftKey)) this.app.redo();
      else return;
      event.preventDefault();
    } else if (event.key === '?') {
      event.preventDefault();
      this.actions.help();
    }
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey) return;
    this.isInUse = true;
    if (!this.handle(event)) return;
    event.preventDefault();
    this.app.redraw();
  }

  /** Whether the key means something. */
  private handle(event: KeyboardEvent): boolean {
    const direction = arrows[event.key];
    const { app } = this;
    if (direction) {
      this.arrow(direction, event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
      return true;
    }
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const tool = tools[key];
    if (tool) {
      this.pointer.choose(tool);
      if (app.tool !== 'select') this.pointer.ensurePointer();
      return true;
    }
    switch (key) {
      case 'n':
        this.cycle(1);
        return true;
      case 'p':
        this.cycle(-1);
        return true;
      case 's':
        app.selection = { kind: 'start' };
        return true;
      case 'g':
        app.selection = { kind: 'goal' };
        return true;
      case 'i':
        this.insert();
        return true;
      case 'c':
        this.pointer.closePolygon();
        return true;
      case 'Enter':
        this.enter();
        return true;
      case 'Escape':
        this.escape();
        return true;
      case 'Delete':
      case 'Backspace':
        this.remove();
        return true;
      case '[':
        this.actions.changeRadius(-1);
        return true;
      case ']':
        this.actions.changeRadius(1);
        return true;
      case '+':
      case '=':
        app.view.zoom(1.25);
        return true;
      case '-':
        app.view.zoom(0.8);
        return true;
      case '0':
        app.fit();
        return true;
      case ' ':
        this.actions.play();
        return true;
      case ',':
        this.actions.step(-1);
        return true;
      case '.':
        this.actions.step(1);
        return true;
      case 't':
        this.actions.theme();
        return true;
      default:
        return false;
    }
  }

  /** A cell, or a hundredth of the shorter side. */
  private get step(): number {
    const { world } = this.app.scene;
    if (world.kind === 'cells') return world.resolution;
    const [x0, y0, x1, y1] = boundsOf(world);
    return Number((Math.min(x1 - x0, y1 - y0) / 100).toPrecision(1));
  }

  private arrow([dx, dy]: Point, factor: number): void {
    const { app } = this;
    const length = this.step * factor;
    const up = app.view.yDown ? -dy : dy;
    const by: Point = [dx * length, up * length];
    if (app.tool !== 'select') {
      const [x, y] = this.pointer.ensurePointer();
      this.pointer.pointer = [x + by[0], y + by[1]];
      return;
    }
    const { selection } = app;
    if (!selection) {
      app.view.pan(-dx * 40 * factor, dy * 40 * factor);
      return;
    }
    if (!app.inGesture) app.beginGesture();
    if (selection.kind === 'startHeading' || selection.kind === 'goalHeading') {
      const turn = ((dx !== 0 ? -dx : up) * factor * 5 * Math.PI) / 180;
      app.edit({ ...app.scene, [selection.kind]: app.scene[selection.kind] + turn });
    } else {
      const at = itemPoint(app.scene, selection, 0);
      if (at) app.edit(moveItem(app.scene, selection, [at[0] + by[0], at[1] + by[1]]));
    }
    // Keys that follow at once belong to one step of the history.
    clearTimeout(this.settle);
    this.settle = window.setTimeout(() => app.endGesture(), 400);
  }

  private cycle(by: number): void {
    const { app } = this;
    const { selection, scene } = app;
    app.tool = 'select';
    const isPart = selection?.kind === 'vertex' || selection?.kind === 'size';
    const items: Item[] = isPart
      ? partsOf(scene, selection.index)
      : itemsOf(scene, app.hasVehicles);
    const now = items.findIndex((item) => sameItem(item, selection));
    const next =
      now < 0 ? (by > 0 ? 0 : items.length - 1) : (now + by + items.length) % items.length;
    app.selection = items[next] ?? null;
  }

  private enter(): void {
    const { app } = this;
    const { selection } = app;
    const at = this.pointer.pointer;
    if (app.tool === 'select') {
      if (selection?.kind === 'obstacle')
        app.selection = partsOf(app.scene, selection.index)[0] ?? selection;
    } else if (!at) {
      this.pointer.ensurePointer();
    } else if (app.tool === 'polygon') {
      if (this.pointer.closesAt(app.view.toScreen(at))) this.pointer.closePolygon();
      else this.pointer.addVertex(at);
    } else if (app.tool === 'disc') {
      app.edit(addObstacle(app.scene, { center: at, radius: this.step * 5 }));
      const { world } = app.scene;
      if (world.kind === 'workspace')
        app.selection = { kind: 'size', index: world.obstacles.length - 1 };
      app.tool = 'select';
    } else {
      app.edit(paint(app.scene, at, at, app.settings.brush, app.tool === 'erase'));
    }
  }

  private escape(): void {
    const { app } = this;
    const { selection } = app;
    if (this.pointer.draft.length > 0) this.pointer.draft = [];
    else if (app.tool !== 'select') app.tool = 'select';
    else if (selection?.kind === 'vertex' || selection?.kind === 'size')
      app.selection = { kind: 'obstacle', index: selection.index };
    else app.selection = null;
  }

  private insert(): void {
    const { selection } = this.app;
    if (selection?.kind !== 'vertex') return;
    this.app.edit(splitEdge(this.app.scene, selection));
    this.app.selection = { ...selection, vertex: selection.vertex + 1 };
  }

  private remove(): void {
    const { app } = this;
    if (!app.selection) return;
    app.edit(removeItem(app.scene, app.selection));
    app.selection = null;
  }
}
