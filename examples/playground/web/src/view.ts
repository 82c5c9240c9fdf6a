// SPDX-License-Identifier: MIT

import type { Point } from './protocol.ts';
import type { Bounds } from './scene.ts';

/** Which part of the world the canvas shows. Screen coordinates are CSS pixels. */
export class View {
  width = 1;
  height = 1;
  /** Pixels per metre. */
  scale = 1;
  yDown = false;
  private centre: Point = [0, 0];

  get key(): string {
    return [this.width, this.height, this.scale, this.yDown, ...this.centre].join();
  }

  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
  }

  fit([x0, y0, x1, y1]: Bounds): void {
    const margin = Math.min(24, 0.04 * Math.min(this.width, this.height) + 4);
    const wide = (this.width - 2 * margin) / Math.max(x1 - x0, 1e-9);
    const high = (this.height - 2 * margin) / Math.max(y1 - y0, 1e-9);
    this.scale = Math.max(Math.min(wide, high), 1e-6);
    this.centre = [(x0 + x1) / 2, (y0 + y1) / 2];
  }

  /** Pixels per metre along y, negative where y points up. */
  private get scaleY(): number {
    return this.yDown ? this.scale : -this.scale;
  }

  toScreen = ([x, y]: Point): Point => [
    this.width / 2 + (x - this.centre[0]) * this.scale,
    this.height / 2 + (y - this.centre[1]) * this.scaleY,
  ];

  toWorld = ([px, py]: Point): Point => [
    this.centre[0] + (px - this.width / 2) / this.scale,
    this.centre[1] + (py - this.height / 2) / this.scaleY,
  ];

  pan(dx: number, dy: number): void {
    this.centre = [this.centre[0] - dx / this.scale, this.centre[1] - dy / this.scaleY];
  }

  /** Keeps the world's point at this pixel. */
  zoomAt([px, py]: Point, factor: number): void {
    const before = this.toWorld([px, py]);
    this.scale = Math.min(Math.max(this.scale * factor, 1e-4), 1e6);
    const after = this.toWorld([px, py]);
    this.centre = [this.centre[0] + before[0] - after[0], this.centre[1] + before[1] - after[1]];
  }

  zoom(factor: number): void {
    this.zoomAt([this.width / 2, this.height / 2], factor);
  }

  /** Makes world coordinates the coordinates of the context. */
  apply(context: CanvasRenderingContext2D, pixelRatio: number): void {
    const k = pixelRatio;
    context.setTransform(
      k * this.scale,
      0,
      0,
      k * this.scaleY,
      k * (this.width / 2 - this.centre[0] * this.scale),
      k * (this.height / 2 - this.centre[1] * this.scaleY),
    );
  }
}
