// SPDX-License-Identifier: MIT

import type { SearchEvents } from './protocol.ts';

/** How many coordinates an event has: a point, or two. */
export function coordinatesOf(kind: string | undefined): number {
  return kind === 'e' || kind === 'g' ? 2 : 4;
}

/** What the letters of events stand for. */
export const eventNames: Record<string, string> = {
  e: 'expanded a node',
  g: 'generated a node',
  i: 'expanded an interval',
  I: 'expanded an interval from the goal',
  r: 'expanded a rectangle',
  R: 'expanded a rectangle from the goal',
  t: 'added an edge to the tree',
};

/** Plays the events of a search. `shown` of them are on the map. */
export class Player {
  events: SearchEvents | null = null;
  shown = 0;
  isPlaying = false;
  /** A factor: at 1 the whole search takes about eight seconds. */
  speed = 1;
  /** Where the coordinates of each event start. */
  offsets = new Uint32Array(0);
  private fraction = 0;

  get count(): number {
    return this.events?.kinds.length ?? 0;
  }

  /** Keeps the position, or stays at the end. */
  load(events: SearchEvents | null): void {
    if (events === this.events) return;
    const wasAtEnd = this.shown >= this.count;
    this.events = events;
    this.offsets = new Uint32Array(this.count);
    let offset = 0;
    for (let i = 0; i < this.count; ++i) {
      this.offsets[i] = offset;
      offset += coordinatesOf(events?.kinds[i]);
    }
    this.shown = wasAtEnd ? this.count : Math.min(this.shown, this.count);
    if (this.count === 0) this.isPlaying = false;
  }

  toggle(): void {
    if (this.shown >= this.count) this.shown = 0;
    this.isPlaying = !this.isPlaying && this.count > 0;
  }
  step(by: number): void {
    this.isPlaying = false;
    this.seek(this.shown + by);
  }
  seek(shown: number): void {
    this.shown = Math.min(Math.max(Math.round(shown), 0), this.count);
  }

  /** Moves on by a time in seconds. */
  advance(seconds: number): void {
    if (!this.isPlaying) return;
    this.fraction += seconds * this.speed * Math.max(this.count / 8, 12);
    const whole = Math.floor(this.fraction);
    this.fraction -= whole;
    this.seek(this.shown + whole);
    if (this.shown >= this.count) this.isPlaying = false;
  }

  /** The last event that is shown, in words. */
  describe(): string {
    const kind = this.events?.kinds[this.shown - 1];
    const offset = this.offsets[this.shown - 1];
    if (kind === undefined || offset === undefined) return 'before the first event';
    const values = this.events?.coordinates.slice(offset, offset + coordinatesOf(kind)) ?? [];
    const at = values.map((value) => Number(value.toFixed(3))).join(', ');
    return `${eventNames[kind] ?? kind} at (${at})`;
  }
}
