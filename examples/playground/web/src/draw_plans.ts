// SPDX-License-Identifier: MIT

import type { App } from './app.ts';
import type { Context } from './draw_scene.ts';
import { metres } from './format.ts';
import type { JudgedCurve, Point, Samples } from './protocol.ts';
import { toGridFrame } from './scene.ts';
import type { View } from './view.ts';

type Discs = { offset: Point; radius: number }[];

/** A point that stays with the robot, for every sample. */
function pathOf(samples: Samples, view: View, [ahead, left]: Point = [0, 0]): Path2D {
  const path = new Path2D();
  samples.x.forEach((x, i) => {
    const heading = samples.heading[i] ?? 0;
    const [c, s] = [Math.cos(heading), Math.sin(heading)];
    const [px, py] = view.toScreen([
      x + c * ahead - s * left,
      (samples.y[i] ?? 0) + s * ahead + c * left,
    ]);
    if (i === 0) path.moveTo(px, py);
    else path.lineTo(px, py);
  });
  return path;
}

/** What the robot sweeps: its disc, or all discs of its footprint, grown by the safety radius. */
function drawBand(
  context: Context,
  curve: Samples,
  view: View,
  footprint: Discs,
  radius: number,
  colour: string,
  alpha: number,
): void {
  const bands = new Map<number, Path2D>();
  for (const disc of footprint.length > 0 ? footprint : [{ offset: [0, 0] as Point, radius: 0 }]) {
    const width = Math.max(2 * (disc.radius + radius) * view.scale, 2);
    const band = bands.get(width) ?? new Path2D();
    band.addPath(pathOf(curve, view, disc.offset));
    bands.set(width, band);
  }
  context.save();
  context.globalAlpha = alpha / Math.sqrt(bands.size);
  context.strokeStyle = colour;
  context.lineCap = 'round';
  context.lineJoin = 'round';
  for (const [width, band] of bands) {
    context.lineWidth = width;
    context.stroke(band);
  }
  context.restore();
}

function stroke(
  context: Context,
  path: Path2D,
  colour: string,
  width: number,
  dash: number[] = [],
): void {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.lineCap = dash.length > 0 ? 'butt' : 'round';
  context.lineJoin = 'round';
  context.setLineDash(dash);
  context.stroke(path);
  context.setLineDash([]);
}

function label(context: Context, app: App, [x, y]: Point, text: string, colour: string): void {
  context.font = '600 12px system-ui, sans-serif';
  const width = context.measureText(text).width;
  const left = Math.min(x + 12, app.view.width - width - 8);
  const top = Math.max(y - 12, 16);
  context.lineWidth = 4;
  context.lineJoin = 'round';
  context.strokeStyle = app.theme.palette.ground;
  context.strokeText(text, left, top);
  context.fillStyle = colour;
  context.fillText(text, left, top);
}

/** The point where the clearance is smallest. */
function drawWitness(
  context: Context,
  app: App,
  at: Point,
  clearance: number | null,
  colour: string,
): void {
  const [x, y] = app.view.toScreen(at);
  context.beginPath();
  context.arc(x, y, 6, 0, 2 * Math.PI);
  context.lineWidth = 2.5;
  context.strokeStyle = app.theme.palette.ground;
  context.stroke();
  context.lineWidth = 1.6;
  context.strokeStyle = colour;
  context.stroke();
  context.beginPath();
  context.arc(x, y, 1.8, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.fill();
  label(
    context,
    app,
    [x, y],
    clearance === null ? 'no obstacle' : `clearance ${metres(clearance)}`,
    colour,
  );
}

function drawCross(context: Context, [x, y]: Point, colour: string, ground: string): void {
  for (const [width, style] of [
    [5, ground],
    [2.5, colour],
  ] as const) {
    context.beginPath();
    context.moveTo(x - 6, y - 6);
    context.lineTo(x + 6, y + 6);
    context.moveTo(x + 6, y - 6);
    context.lineTo(x - 6, y + 6);
    context.lineWidth = width;
    context.strokeStyle = style;
    context.stroke();
  }
}

/** Curves have dashes where a vehicle drives in reverse. */
function drawCurve(
  context: Context,
  curve: Samples,
  view: View,
  colour: string,
  width: number,
): void {
  if (!curve.gear?.includes(-1)) {
    stroke(context, pathOf(curve, view), colour, width);
    return;
  }
  for (const gear of [1, -1]) {
    const path = new Path2D();
    let isDrawing = false;
    curve.x.forEach((x, i) => {
      const point = view.toScreen([x, curve.y[i] ?? 0]);
      const isHere = curve.gear?.[i] === gear;
      if (isHere || isDrawing)
        (isDrawing ? path.lineTo.bind(path) : path.moveTo.bind(path))(...point);
      isDrawing = isHere;
    });
    stroke(context, path, colour, width, gear < 0 ? [8, 5] : []);
  }
}

/** A curve beside the plan's: red, with the point where it is not safe. */
function drawJudged(
  context: Context,
  app: App,
  { curve, certificate }: JudgedCurve,
  name: string,
): void {
  const {
    view,
    theme: { palette },
  } = app;
  const isSafe = certificate.status === 'proved';
  stroke(context, pathOf(curve, view), isSafe ? palette.route : palette.refused, 2, [7, 5]);
  if (isSafe) return;
  const at = view.toScreen(toGridFrame(app.scene.world, certificate.point));
  drawCross(context, at, palette.refused, palette.ground);
  label(context, app, at, `${name}: clearance ${metres(certificate.upper)}`, palette.refused);
}

/** Draws all plans, the active one on top with its proof. */
export function drawPlans(context: Context, app: App, pixelRatio: number): void {
  const { view, scene, settings, theme } = app;
  context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
  const shown = app.planners.filter(({ id, visible }) => visible || id === app.active);
  const ordered = [
    ...shown.filter(({ id }) => id !== app.active),
    ...shown.filter(({ id }) => id === app.active),
  ];
  for (const { id } of ordered) {
    const outcome = app.outcomes.get(id);
    const reply = outcome?.reply;
    // What was proved of another scene is not drawn over this one.
    if (!reply || !app.isFresh(outcome)) continue;
    const isActive = id === app.active;
    const colour = theme.curve(id);
    const isProved = reply.result.certificate?.status === 'proved';
    if (reply.curve && settings.showBand && isActive && isProved) {
      drawBand(
        context,
        reply.curve,
        view,
        reply.footprint ?? [],
        reply.result.safety_radius,
        colour,
        theme.isDark ? 0.28 : 0.2,
      );
    }
    if (reply.route && settings.showRoute) {
      stroke(
        context,
        pathOf(reply.route, view),
        isActive ? theme.palette.route : colour,
        1.2,
        [4, 3],
      );
    }
    if (reply.curve)
      drawCurve(
        context,
        reply.curve,
        view,
        isProved ? colour : theme.palette.refused,
        isActive ? 3.2 : 2.2,
      );
    if (!isActive) continue;
    if (reply.unchecked) drawJudged(context, app, reply.unchecked, 'unchecked');
    if (reply.refused) drawJudged(context, app, reply.refused, 'refused');
    const { certificate } = reply.result;
    if (certificate && isProved && settings.showBand) {
      drawWitness(
        context,
        app,
        toGridFrame(scene.world, certificate.point),
        certificate.upper,
        theme.palette.proof,
      );
    } else if (certificate && !isProved) {
      drawCross(
        context,
        view.toScreen(toGridFrame(scene.world, certificate.point)),
        theme.palette.refused,
        theme.palette.ground,
      );
    }
  }
}
