// SPDX-License-Identifier: MIT

import type { App } from './app.ts';
import type { Planning } from './planning.ts';
import type { PlanReply, Point } from './protocol.ts';
import { resultText, sceneText } from './export.ts';
import type { Scene } from './scene.ts';

/** What tests of the page read. It is no interface for other programs. */
export interface TestInterface {
  state(): {
    scene: Scene;
    active: number;
    inGesture: boolean;
    /** Counts the states of the page that plans were asked for. */
    version: number;
    /** Of every planner, in the order of the table. */
    replies: { id: number; complete: boolean; error?: string; reply?: PlanReply }[];
    shownEvents: number;
    events: number;
    plans: number;
    /** [ms] from the start of navigation to the first plan on the canvas */
    firstPlan: number | null;
  };
  resultText(): string;
  sceneText(): string;
  view: { toScreen(point: Point): Point; toWorld(pixel: Point): Point };
  /** The first map is open. */
  ready: Promise<void>;
}

declare global {
  interface Window {
    tutaviaPlayground: TestInterface;
  }
}

export function exposeForTests(app: App, planning: Planning, ready: Promise<void>): void {
  let firstPlan: number | null = null;
  planning.onPlan = () => {
    if (firstPlan === null) requestAnimationFrame((now) => (firstPlan ??= now));
  };
  window.tutaviaPlayground = {
    state: () => ({
      scene: app.scene,
      active: app.active,
      inGesture: app.inGesture,
      version: planning.currentVersion,
      shownEvents: app.player.shown,
      events: app.player.count,
      plans: planning.plans,
      firstPlan,
      replies: app.planners.map(({ id }) => {
        const outcome = app.outcomes.get(id);
        return {
          id,
          complete: (outcome?.complete ?? false) && outcome?.version === planning.currentVersion,
          ...(outcome?.error && { error: outcome.error }),
          ...(outcome?.reply && { reply: outcome.reply }),
        };
      }),
    }),
    resultText: () => resultText(app),
    sceneText: () => sceneText(app.scene),
    view: app.view,
    ready,
  };
}
