// SPDX-License-Identifier: MIT

import { isForVehicles, matched, type Planner } from './choices.ts';
import type { Item } from './edit.ts';
import { Player } from './player.ts';
import type { CatalogueReply, PlanReply, SpeedLimits, VehicleChoice } from './protocol.ts';
import { boundsOf, History, type Scene } from './scene.ts';
import { Theme } from './theme.ts';
import { View } from './view.ts';

export type ToolName = 'select' | 'polygon' | 'disc' | 'paint' | 'erase';

/** What became of a planner's last request. */
export interface Outcome {
  reply?: PlanReply;
  error?: string;
  /** Has the optimum, the events and the speed profile, too. */
  complete: boolean;
  /** Counts the states of the page that plans were asked for. */
  version: number;
}

export interface Settings {
  vehicle: VehicleChoice;
  speed: SpeedLimits;
  /** [s] */
  timeLimit: number;
  brush: number;
  terrain: 'refused' | 'blocked' | 'free';
  unknown: 'blocked' | 'free';
  showZone: boolean;
  showRoute: boolean;
  showBand: boolean;
  showSearch: boolean;
  showUnchecked: boolean;
}

export type DockTab = 'comparison' | 'profile' | 'search';

/** The state of the page. Whoever changes it says so by `planAgain` or `redraw`. */
export class App {
  readonly view = new View();
  readonly player = new Player();
  readonly history = new History();
  readonly theme: Theme;
  catalogue: CatalogueReply | null = null;
  planners: Planner[] = [];
  outcomes = new Map<number, Outcome>();
  /** Counts the states of the page that plans were asked for. */
  version = 0;
  active = 0;
  tool: ToolName = 'select';
  selection: Item | null = null;
  /** Arc length along the path of the active planner, where the robot is shown. */
  along: number | null = null;
  driving = false;
  tab: DockTab = 'comparison';
  /** Of files: an error, or warnings. */
  notice: { kind: 'error' | 'note'; text: string } | null = null;
  /** An edit is under way, such as a drag. */
  inGesture = false;
  settings: Settings = {
    vehicle: { min_turning_radius: 1, reverse: true },
    speed: {
      max_speed: 1,
      max_acceleration: 0.5,
      max_deceleration: 0.5,
      max_lateral_acceleration: 0.5,
    },
    timeLimit: 5,
    brush: 2,
    terrain: 'blocked',
    unknown: 'blocked',
    showZone: true,
    showRoute: true,
    showBand: true,
    showSearch: false,
    showUnchecked: false,
  };
  private isDirty = false;
  private lastId = -1;
  private listeners: { redraw: () => void; plan: () => void }[] = [];

  constructor(private current: Scene) {
    this.theme = new Theme(() => this.redraw());
  }

  listen(redraw: () => void, plan: () => void): void {
    this.listeners.push({ redraw, plan });
  }
  redraw(): void {
    for (const { redraw } of this.listeners) redraw();
  }
  /** The scene, a planner or a setting of plans has changed. */
  planAgain(): void {
    this.isDirty = true;
    for (const { plan } of this.listeners) plan();
    this.redraw();
  }
  /** Whether plans are out of date; they count as planned from now on. */
  takeDirty(): boolean {
    const was = this.isDirty;
    this.isDirty = false;
    return was;
  }

  get scene(): Scene {
    return this.current;
  }
  /** Shows another map. */
  open(scene: Scene): void {
    this.history.push(this.current);
    this.current = scene;
    this.outcomes.clear();
    this.selection = null;
    this.along = null;
    if (
      scene.world.kind === 'cells'
        ? ['polygon', 'disc'].includes(this.tool)
        : ['paint', 'erase'].includes(this.tool)
    )
      this.tool = 'select';
    this.fit();
    this.planAgain();
  }
  /** One edit. Between beginGesture and endGesture edits make one step of the history. */
  edit(scene: Scene): void {
    if (scene === this.current) return;
    if (!this.inGesture) this.history.push(this.current);
    this.current = scene;
    this.planAgain();
  }
  beginGesture(): void {
    this.history.push(this.current);
    this.inGesture = true;
  }
  endGesture(): void {
    this.inGesture = false;
    this.history.dropUnchanged(this.current);
    this.redraw();
  }
  undo(): void {
    this.travel(this.history.undo(this.current));
  }
  redo(): void {
    this.travel(this.history.redo(this.current));
  }
  private travel(scene: Scene): void {
    if (scene === this.current) return;
    const isOther =
      String(boundsOf(scene.world)) !== String(boundsOf(this.current.world)) ||
      scene.yDown !== this.current.yDown;
    this.current = scene;
    // Obstacles have other numbers now.
    if (this.selection && 'index' in this.selection) this.selection = null;
    if (isOther) this.fit();
    this.planAgain();
  }
  fit(): void {
    this.view.yDown = this.current.yDown;
    this.view.fit(boundsOf(this.current.world));
    this.redraw();
  }

  get activePlanner(): Planner | undefined {
    return this.planners.find(({ id }) => id === this.active);
  }
  /** Whether an outcome is of what is shown. While something is dragged, plans follow the mouse. */
  isFresh({ version }: Outcome): boolean {
    return this.inGesture || version === this.version;
  }
  get activeReply(): PlanReply | undefined {
    return this.outcomes.get(this.active)?.reply;
  }
  get hasVehicles(): boolean {
    return this.planners.some((planner) => isForVehicles(this.catalogue, planner));
  }
  activate(id: number): void {
    this.active = id;
    this.along = null;
    this.player.load(this.activeReply?.events ?? null);
    this.redraw();
  }
  changePlanner(changed: Planner): void {
    const planner = this.catalogue ? matched(this.catalogue, changed) : changed;
    this.planners = this.planners.map((old) => (old.id === planner.id ? planner : old));
    this.outcomes.delete(planner.id);
    this.planAgain();
  }
  addPlanner(like: Omit<Planner, 'id' | 'visible'>): void {
    // No planner gets replies to the questions of one that was removed.
    const id = Math.max(this.lastId, ...this.planners.map((planner) => planner.id)) + 1;
    this.lastId = id;
    this.planners = [...this.planners, { ...like, id, visible: true }];
    this.active = id;
    this.planAgain();
  }
  removePlanner(id: number): void {
    if (this.planners.length < 2) return;
    this.planners = this.planners.filter((planner) => planner.id !== id);
    this.outcomes.delete(id);
    if (this.active === id) this.activate(this.planners[0]?.id ?? 0);
    else this.redraw();
  }
  changeSettings(change: Partial<Settings>): void {
    this.settings = { ...this.settings, ...change };
    if (change.vehicle || change.speed || change.timeLimit || 'showUnchecked' in change)
      this.planAgain();
    else this.redraw();
  }
}
