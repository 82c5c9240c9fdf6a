// SPDX-License-Identifier: MIT

import type { App, Outcome } from './app.ts';
import { choiceText, isForVehicles, smootherText, type Planner } from './choices.ts';
import type { Client } from './client.ts';
import { isError } from './engine.ts';
import type { ErrorReply, PlanReply, PlanRequest, SceneReply } from './protocol.ts';
import { sameSpace, sceneRequest, type Scene } from './scene.ts';

/** How long nothing must change until the slower questions are asked [ms]. */
const settleTime = 250;
const maxEvents = 100000;

/** An engine with the scene that it was last told. */
interface Desk {
  client: Client;
  told: Scene | null;
}

/**
 * Keeps the plans up to date. After every change the live engine plans, with nothing but the plan
 * asked. Once nothing changes any more, a second engine is asked for the optimum, the events and the
 * speed profile, so that the next drag need not wait for them.
 */
export class Planning {
  private readonly live: Desk;
  private background: Desk | null = null;
  private version = 0;
  private timer = 0;
  private plansMade = 0;
  /** The first plan of an engine is slow, because its code is compiled on the way. */
  private isWarm = false;
  onPlan: (complete: boolean) => void = () => {};

  constructor(
    private readonly app: App,
    live: Client,
    private readonly makeClient: () => Client,
  ) {
    this.live = { client: live, told: null };
  }

  /** The engine for questions that may take long. */
  get backgroundClient(): Client {
    return this.backgroundDesk.client;
  }
  /** How long the engines have been at one request [ms]. */
  get busyFor(): number {
    return Math.max(this.live.client.busyFor, this.background?.client.busyFor ?? 0);
  }
  /** Counts the states of the page that plans were asked for. */
  get currentVersion(): number {
    return this.version;
  }
  get plans(): number {
    return this.plansMade;
  }

  /** Call once a frame. */
  frame(): void {
    if (!this.app.takeDirty() || this.app.planners.length === 0 || !this.app.catalogue) return;
    this.app.version = ++this.version;
    this.planOn(this.live, false);
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.complete(), settleTime);
  }

  cancel(): void {
    clearTimeout(this.timer);
    for (const desk of [this.live, this.background]) {
      if (desk && desk.client.busyFor > 0) desk.client.cancel();
    }
  }

  planRequest(planner: Planner): PlanRequest {
    const { scene, settings, catalogue } = this.app;
    const base: PlanRequest = {
      do: 'plan',
      search: choiceText(planner.search),
      smoother: smootherText(planner),
      start: scene.start,
      goal: scene.goal,
      seed: planner.seed,
      time_limit: settings.timeLimit,
      unchecked: settings.showUnchecked,
    };
    if (!isForVehicles(catalogue, planner)) return base;
    return {
      ...base,
      start_heading: scene.startHeading,
      goal_heading: scene.goalHeading,
      vehicle: settings.vehicle,
    };
  }

  /** Tells the background engine the scene, for questions such as `svg`. */
  prepareBackground(): Client {
    this.tell(this.backgroundDesk);
    return this.backgroundDesk.client;
  }

  private get backgroundDesk(): Desk {
    this.background ??= { client: this.makeClient(), told: null };
    return this.background;
  }

  private complete(): void {
    // The end of a drag is awaited, even if the pointer rests.
    if (this.app.inGesture) {
      this.timer = window.setTimeout(() => this.complete(), settleTime);
      return;
    }
    this.planOn(this.backgroundDesk, true);
  }

  private tell(desk: Desk): void {
    const { scene } = this.app;
    if (desk.told && sameSpace(desk.told, scene)) return;
    desk.told = scene;
    const { request, bytes } = sceneRequest(scene);
    const version = this.version;
    desk.client.setScene(request, bytes, (reply) => this.receiveScene(reply, version));
  }

  private planOn(desk: Desk, complete: boolean): void {
    this.tell(desk);
    const version = this.version;
    for (const planner of this.app.planners) {
      const request = this.planRequest(planner);
      if (complete)
        Object.assign(request, {
          optimum: true,
          events: maxEvents,
          speed: this.app.settings.speed,
          samples: 600,
        });
      desk.client.plan(planner.id, request, (reply) =>
        this.receive(planner, version, complete, reply),
      );
    }
  }

  private receiveScene(reply: SceneReply | ErrorReply, version: number): void {
    if (!isError(reply) || version !== this.version || reply.error === 'cancelled') return;
    this.app.notice = { kind: 'error', text: `This scene cannot be used: ${reply.error}` };
    // What was proved of another scene is not shown on this one.
    this.app.outcomes.clear();
    this.app.redraw();
  }

  private receive(
    planner: Planner,
    version: number,
    complete: boolean,
    reply: PlanReply | ErrorReply,
  ): void {
    const { app } = this;
    // The replies of the live engine follow the mouse; all others are for what is shown now.
    if (!app.planners.includes(planner) || (!app.inGesture && version !== this.version)) return;
    const { id } = planner;
    // What the background engine says of an older scene is of no use; the live engine's is the best there is.
    if (complete && version !== this.version) return;
    const known = app.outcomes.get(id);
    if (!complete && known?.complete && known.version === version) return;
    const isWorse = isError(reply) || reply.result.status !== 'success';
    if (complete && isWorse && known?.reply?.result.status === 'success') {
      known.complete = true; // recording may take a plan over its time limit
      app.redraw();
      return;
    }
    const outcome: Outcome = isError(reply)
      ? { error: reply.error, complete, version }
      : { reply, complete, version };
    if (complete && known?.reply && known.version === version && !isError(reply))
      keepTimes(reply, known.reply);
    app.outcomes.set(id, outcome);
    if (complete && id === app.active) app.player.load(outcome.reply?.events ?? null);
    ++this.plansMade;
    if (!complete && !this.isWarm) {
      this.isWarm = true;
      this.planOn(this.live, false);
    }
    this.onPlan(complete && id === app.active);
    app.redraw();
  }
}

/** Recording events slows a search down, so that the times of the live plan are the true ones. */
function keepTimes(reply: PlanReply, live: PlanReply): void {
  const { search_us, smooth_us, certify_us } = live.result.stats;
  Object.assign(reply.result.stats, { search_us, smooth_us, certify_us });
}
