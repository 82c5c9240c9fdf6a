// SPDX-License-Identifier: MIT

import { html, nothing, type TemplateResult } from 'lit-html';
import type { App, DockTab } from './app.ts';

interface Step {
  title: string;
  text: string;
  /** What the step is about; it gets a frame. */
  target: string;
  tab?: DockTab;
}

const steps: Step[] = [
  {
    title: 'Move the goal',
    target: '#map',
    text: 'Drag the filled circle, or press G and the arrow keys. Every frame is a new plan. The thin dashed line is the route of the search, the thick line the smooth curve.',
  },
  {
    title: 'Every path is proved',
    target: '#status',
    text: 'The band is what the robot sweeps. The ring marks where the clearance of the whole curve is smallest; it is computed for every point of the curve, not for samples of it. A curve that is not safe is refused and drawn red; tick "unchecked spline" to see one.',
  },
  {
    title: 'Change the world',
    target: '#toolbar',
    text: 'Draw polygons and discs, drag them and their vertices, or open a grid map and paint its cells. The slider changes the safety radius. Undo takes everything back.',
  },
  {
    title: 'Compare planners',
    target: '#dock',
    tab: 'comparison',
    text: 'Add planners in the panel, choose a search and smoothers, and change their options. The table shows them side by side: length, its ratio to the optimum, curvature, clearance and time.',
  },
  {
    title: 'See the search',
    target: '#dock',
    tab: 'search',
    text: 'Play, step and scrub the events of the search: expanded nodes, trees, rectangles and intervals. The next tab shows curvature, clearance and speed along the path.',
  },
];

/** Explains the page in five steps. */
export class Tour {
  private step = -1;

  constructor(private readonly app: App) {}

  start(): void {
    this.go(0);
  }

  private go(step: number): void {
    this.step = step < steps.length ? step : -1;
    const current = steps[this.step];
    for (const old of document.querySelectorAll('.toured')) old.classList.remove('toured');
    if (current) {
      document.querySelector(current.target)?.classList.add('toured');
      if (current.tab) this.app.tab = current.tab;
      if (current.tab === 'search') {
        this.app.settings.showSearch = true;
        this.app.player.seek(0);
        if (!this.app.player.isPlaying) this.app.player.toggle();
      }
    }
    this.app.redraw();
    requestAnimationFrame(() => document.querySelector<HTMLElement>('.tour .next')?.focus());
  }

  template(): TemplateResult | typeof nothing {
    const current = steps[this.step];
    if (!current) return nothing;
    const isLast = this.step === steps.length - 1;
    return html`<section
      class="tour"
      data-testid="tour-box"
      role="dialog"
      aria-label="Tour"
      @keydown=${(event: KeyboardEvent) => event.key === 'Escape' && this.go(steps.length)}
    >
      <h2>${this.step + 1} of ${steps.length}: ${current.title}</h2>
      <p aria-live="polite">${current.text}</p>
      <div class="row">
        <button type="button" @click=${() => this.go(steps.length)}>Close</button>
        <button type="button" ?disabled=${this.step === 0} @click=${() => this.go(this.step - 1)}>
          Back
        </button>
        <button
          type="button"
          class="next primary"
          data-testid="tour-next"
          @click=${() => this.go(this.step + 1)}
        >
          ${isLast ? 'Done' : 'Next'}
        </button>
      </div>
    </section>`;
  }
}
