// SPDX-License-Identifier: MIT

import { html, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { lengthOf, speedOf, timeAt, valueAlong } from './along.ts';
import type { App } from './app.ts';
import { fixed } from './format.ts';
import type { PlanReply } from './protocol.ts';

interface Line {
  s: number[];
  values: (number | null)[];
  colour: string;
  width: number;
}
interface Lane {
  title: string;
  unit: string;
  lines: Line[];
  /** A dashed line, such as the safety radius. */
  limit?: number;
  symmetric: boolean;
}

/** A plot on the canvas: left, right, bottom and top. */
interface Box {
  x0: number;
  x1: number;
  y0: number;
  y1: number;
}

/** Space for the labels of the axes [px]. */
const left = 46;
const right = 10;

function lanesOf(app: App): Lane[] {
  const shown = app.planners.filter(({ id, visible }) => visible || id === app.active);
  const line = (
    pick: (reply: PlanReply) => { s: number[]; values: (number | null)[] } | null,
  ): Line[] =>
    shown.flatMap(({ id }) => {
      const reply = app.outcomes.get(id)?.reply;
      const picked = reply ? pick(reply) : null;
      return picked
        ? [{ ...picked, colour: app.theme.curve(id), width: id === app.active ? 2 : 1.1 }]
        : [];
    });
  return [
    {
      title: 'curvature',
      unit: '1/m',
      symmetric: true,
      lines: line(({ curve }) => (curve ? { s: curve.s, values: curve.curvature } : null)),
    },
    {
      title: 'clearance',
      unit: 'm',
      symmetric: false,
      limit: app.scene.radius,
      lines: line(({ curve }) => (curve ? { s: curve.s, values: curve.clearance } : null)),
    },
    {
      title: 'speed',
      unit: 'm/s',
      symmetric: false,
      limit: app.settings.speed.max_speed,
      lines: line((reply) => {
        const speed = speedOf(reply);
        return speed ? { s: speed.s, values: speed.speed } : null;
      }),
    },
  ];
}

/** The largest value that the lane shows. Few samples at a sharp corner must not flatten all others. */
function extent({ lines, limit, symmetric }: Lane): number {
  const values = lines
    .flatMap((line) => line.values.filter((value): value is number => value !== null).map(Math.abs))
    .sort((a, b) => a - b);
  const most = values.at(-1) ?? 0;
  const usual = values[Math.floor((values.length - 1) * 0.97)] ?? 0;
  const high = symmetric && most > 12 * usual && usual > 0 ? 3 * usual : most;
  return Math.max(high * 1.12, (limit ?? 0) * 1.25, 1e-6);
}

/** Curvature, clearance and speed along the path, with a cursor that also moves the robot on the map. */
export class Plots {
  private readonly context: CanvasRenderingContext2D;

  constructor(
    private readonly app: App,
    readonly canvas: HTMLCanvasElement,
  ) {
    const context = canvas.getContext('2d');
    if (!context) throw new Error('this browser has no canvas');
    this.context = context;
    const follow = (event: PointerEvent): void => {
      const box = canvas.getBoundingClientRect();
      app.driving = false;
      app.along = this.toLength(event.clientX - box.left, event.clientY - box.top);
      app.redraw();
    };
    canvas.addEventListener('pointermove', (event) => {
      if (event.pointerType === 'mouse' || event.buttons > 0) follow(event);
    });
    canvas.addEventListener('pointerdown', follow);
    canvas.addEventListener('pointerleave', () => {
      app.along = null;
      app.redraw();
    });
  }

  private get longest(): number {
    return Math.max(
      ...this.app.planners.map(({ id }) => lengthOf(this.app.outcomes.get(id)?.reply)),
      1e-9,
    );
  }
  /** Side by side where there is room, else below each other. */
  private boxes(count: number): Box[] {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const isWide = width > 640;
    return Array.from({ length: count }, (_, i) => {
      const [x, y] = isWide ? [(i * width) / count, 0] : [0, (i * height) / count];
      const [w, h] = isWide ? [width / count, height] : [width, height / count];
      return { x0: x + left, x1: x + w - right, y0: y + h - 6, y1: y + 18 };
    });
  }
  private toLength(x: number, y: number): number {
    const box = this.boxes(3).find(({ x1, y0 }) => x <= x1 + right && y <= y0 + 6);
    const t = box ? (x - box.x0) / Math.max(box.x1 - box.x0, 1) : 1;
    return Math.min(Math.max(t * this.longest, 0), lengthOf(this.app.activeReply));
  }

  draw(pixelRatio: number): void {
    const { canvas, context, app } = this;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (width === 0) return;
    canvas.width = Math.round(width * pixelRatio);
    canvas.height = Math.round(height * pixelRatio);
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    context.font = '11px system-ui, sans-serif';
    const lanes = lanesOf(app);
    this.boxes(lanes.length).forEach((box, i) => {
      const lane = lanes[i];
      if (lane) this.drawLane(lane, box);
    });
  }

  private drawLane(lane: Lane, box: Box): void {
    const {
      context,
      app: {
        along,
        theme: { palette },
      },
    } = this;
    const { x0, x1, y0, y1 } = box;
    const high = extent(lane);
    const zero = lane.symmetric ? (y0 + y1) / 2 : y0;
    const toY = (value: number): number => zero - (value / high) * (zero - y1);
    const toX = (s: number): number => x0 + (s / this.longest) * (x1 - x0);
    context.fillStyle = palette.ink;
    context.textAlign = 'left';
    context.fillText(`${lane.title} [${lane.unit}]`, x0, y1 - 5);
    context.textAlign = 'right';
    context.fillStyle = palette.route;
    for (const value of lane.symmetric ? [high / 1.12, 0, -high / 1.12] : [high / 1.12, 0]) {
      context.fillText(String(Number(value.toPrecision(3))), x0 - 6, toY(value) + 4);
    }
    context.lineWidth = 1;
    context.strokeStyle = palette.faint;
    context.strokeRect(x0, y1, x1 - x0, y0 - y1);
    this.line(x0, toY(0), x1, toY(0), palette.faint);
    if (lane.limit) this.line(x0, toY(lane.limit), x1, toY(lane.limit), palette.refused, [5, 4]);
    context.save();
    context.beginPath();
    context.rect(x0, y1 - 1, x1 - x0, y0 - y1 + 2);
    context.clip();
    for (const line of lane.lines) this.curve(line, toX, toY);
    context.restore();
    if (along !== null) this.line(toX(along), y1, toX(along), y0, palette.current);
  }

  private curve(
    { s, values, colour, width }: Line,
    toX: (s: number) => number,
    toY: (value: number) => number,
  ): void {
    const { context } = this;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.lineJoin = 'round';
    context.beginPath();
    let isDrawing = false;
    s.forEach((at, i) => {
      const value = values[i];
      if (value === null || value === undefined) {
        isDrawing = false;
        return;
      }
      if (isDrawing) context.lineTo(toX(at), toY(value));
      else context.moveTo(toX(at), toY(value));
      isDrawing = true;
    });
    context.stroke();
  }

  private line(
    x0: number,
    y0: number,
    x1: number,
    y1: number,
    colour: string,
    dash: number[] = [],
  ): void {
    const { context } = this;
    context.strokeStyle = colour;
    context.lineWidth = dash.length > 0 ? 1 : 1.4;
    context.setLineDash(dash);
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
    context.setLineDash([]);
  }
}

function readout(app: App): string {
  const reply = app.activeReply;
  const speed = speedOf(reply);
  if (app.along === null || !reply?.curve) {
    if (reply?.speed && 'detail' in reply.speed) return `No speed profile: ${reply.speed.detail}.`;
    return speed
      ? `The drive takes ${speed.duration.toFixed(1)} s. Point at the plots to see the robot.`
      : '';
  }
  const { s, curvature, clearance } = reply.curve;
  const at = (list: (number | null)[]): string => fixed(valueAlong(s, list, app.along ?? 0));
  const driven = speed
    ? `, ${fixed(valueAlong(speed.s, speed.speed, app.along), 2)} m/s after ${timeAt(speed, app.along).toFixed(1)} s`
    : '';
  return `At ${app.along.toFixed(2)} m: curvature ${at(curvature)} 1/m, clearance ${at(clearance)} m${driven}.`;
}

/** The controls beside the plots. `canvas` is their picture. */
export function profile(app: App, canvas: HTMLCanvasElement): TemplateResult {
  const length = lengthOf(app.activeReply);
  const speed = speedOf(app.activeReply);
  return html`<div class="plots">
    ${canvas}
    <div class="row">
      <button
        type="button"
        data-testid="drive"
        ?disabled=${!speed}
        @click=${() => {
          app.driving = !app.driving;
          if (app.driving && (app.along === null || app.along >= length - 1e-6)) app.along = 0;
          app.redraw();
        }}
      >
        ${app.driving ? 'Stop' : 'Drive'}
      </button>
      <label class="wide"
        >along the path
        <input
          data-testid="along"
          type="range"
          min="0"
          max=${length || 1}
          step="any"
          .value=${live(String(app.along ?? 0))}
          aria-valuetext=${readout(app)}
          @input=${(event: Event) => {
            app.driving = false;
            app.along = Number((event.target as HTMLInputElement).value);
            app.redraw();
          }}
      /></label>
    </div>
    <p class="readout" data-testid="readout">${readout(app)}</p>
  </div>`;
}
