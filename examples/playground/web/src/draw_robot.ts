// SPDX-License-Identifier: MIT

import type { App } from './app.ts';
import type { Context } from './draw_scene.ts';
import { obstacleAt, itemPoint, partsOf, sameItem, type Item } from './edit.ts';
import { isForVehicles } from './choices.ts';
import { armPixels } from './hit.ts';
import { robotAlong } from './along.ts';
import type { PlanReply, Point } from './protocol.ts';
import { obstaclePath } from './draw_scene.ts';
import { toGridFrame } from './scene.ts';

interface Pose {
  at: Point;
  heading: number;
}

/** The footprint of the robot, grown by nothing: its disc, or the discs and the rectangle of a vehicle. */
function drawRobot(
  context: Context,
  app: App,
  reply: PlanReply | undefined,
  { at, heading }: Pose,
  colour: string,
): void {
  const {
    view,
    scene,
    settings: { vehicle },
  } = app;
  const planner = app.activePlanner;
  const [c, s] = [Math.cos(heading), Math.sin(heading)];
  const place = ([ahead, left]: Point): Point =>
    view.toScreen([at[0] + c * ahead - s * left, at[1] + s * ahead + c * left]);
  context.strokeStyle = colour;
  context.fillStyle = colour;
  const discs =
    planner && isForVehicles(app.catalogue, planner)
      ? (reply?.footprint ?? [])
      : [{ offset: [0, 0] as Point, radius: scene.radius }];
  for (const { offset, radius } of discs) {
    const [x, y] = place(offset);
    context.beginPath();
    context.arc(x, y, Math.max(radius * view.scale, 1), 0, 2 * Math.PI);
    context.globalAlpha = 0.14;
    context.fill();
    context.globalAlpha = 0.6;
    context.lineWidth = 1;
    context.stroke();
  }
  context.globalAlpha = 1;
  if (!planner || !isForVehicles(app.catalogue, planner) || !vehicle.car) return;
  const { length, width, wheelbase } = vehicle.car;
  const [back, front] = [(wheelbase - length) / 2, (wheelbase + length) / 2];
  context.beginPath();
  (
    [
      [back, -width / 2],
      [front, -width / 2],
      [front, width / 2],
      [back, width / 2],
    ] as Point[]
  ).forEach((corner, i) => {
    const [x, y] = place(corner);
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.closePath();
  context.lineWidth = 1.6;
  context.stroke();
}

function drawHandle(
  context: Context,
  [x, y]: Point,
  size: number,
  fill: string,
  stroke: string,
): void {
  context.beginPath();
  context.arc(x, y, size, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  context.lineWidth = 2.6;
  context.strokeStyle = stroke;
  context.stroke();
}

function drawArrow(context: Context, from: Point, to: Point, colour: string): void {
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
  context.strokeStyle = colour;
  context.fillStyle = colour;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  context.stroke();
  context.beginPath();
  context.moveTo(to[0] + 7 * Math.cos(angle), to[1] + 7 * Math.sin(angle));
  for (const turn of [2.4, -2.4])
    context.lineTo(to[0] + 8 * Math.cos(angle + turn), to[1] + 8 * Math.sin(angle + turn));
  context.closePath();
  context.fill();
}

/** The obstacle that is selected, with handles for its parts. */
function drawSelection(context: Context, app: App, pixelRatio: number): void {
  const {
    selection,
    scene,
    view,
    theme: { palette },
  } = app;
  if (!selection || !('index' in selection)) return;
  const obstacle = obstacleAt(scene, selection.index);
  if (!obstacle) return;
  view.apply(context, pixelRatio);
  context.lineWidth = 2 / view.scale;
  context.strokeStyle = palette.select;
  context.stroke(obstaclePath(obstacle));
  context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
  for (const part of partsOf(scene, selection.index)) {
    const at = itemPoint(scene, part, 0);
    if (!at) continue;
    const [x, y] = view.toScreen(at);
    const half = sameItem(part, selection) ? 6 : 4;
    context.fillStyle = sameItem(part, selection) ? palette.select : palette.ground;
    context.fillRect(x - half, y - half, 2 * half, 2 * half);
    context.lineWidth = 1.5;
    context.strokeRect(x - half, y - half, 2 * half, 2 * half);
  }
}

/** Draws start, goal and headings, the robot along the path, and what is selected. */
export function drawRobots(context: Context, app: App, pixelRatio: number, focused: boolean): void {
  const {
    scene,
    view,
    theme: { palette },
    selection,
  } = app;
  const reply = app.activeReply;
  const colour = app.theme.curve(app.active);
  drawSelection(context, app, pixelRatio);
  const ends: [Item['kind'], Point, number][] = [
    ['start', scene.start, scene.startHeading],
    ['goal', scene.goal, scene.goalHeading],
  ];
  for (const [kind, at, heading] of ends) {
    const isStart = kind === 'start';
    drawRobot(context, app, reply, { at, heading }, isStart ? palette.ink : colour);
    const pixel = view.toScreen(at);
    if (app.hasVehicles) {
      const arm = armPixels / view.scale;
      const tip = view.toScreen([at[0] + arm * Math.cos(heading), at[1] + arm * Math.sin(heading)]);
      drawArrow(
        context,
        pixel,
        tip,
        selection?.kind === `${kind}Heading` ? palette.select : palette.ink,
      );
    }
    if (selection?.kind === kind) drawHandle(context, pixel, 12, 'transparent', palette.select);
    drawHandle(
      context,
      pixel,
      7,
      isStart ? palette.ground : colour,
      isStart ? palette.ink : palette.ground,
    );
  }
  const safe = reply?.result.nearest_safe_point;
  if (safe)
    drawHandle(
      context,
      view.toScreen(toGridFrame(scene.world, safe)),
      5,
      palette.proof,
      palette.ground,
    );
  const pose = app.along === null ? null : robotAlong(reply, app.along);
  if (pose) {
    drawRobot(context, app, reply, pose, palette.current);
    drawHandle(context, view.toScreen(pose.at), 4, palette.current, palette.ground);
  }
  if (focused) {
    context.strokeStyle = palette.select;
    context.lineWidth = 2;
    context.strokeRect(2, 2, view.width - 4, view.height - 4);
  }
}
