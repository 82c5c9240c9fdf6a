// SPDX-License-Identifier: MIT

import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import type { App } from './app.ts';
import { plannerName } from './choices.ts';

const legend: [string, string, string][] = [
  ['e', 'expanded', 'visited'],
  ['g', 'generated', 'generated'],
  ['t', 'tree', 'tree'],
  ['r', 'rectangle', 'forwardRectangle'],
  ['R', 'rectangle from the goal', 'backwardRectangle'],
  ['i', 'interval', 'forwardPassage'],
  ['I', 'interval from the goal', 'backwardPassage'],
];

function show(app: App, change: () => void): void {
  change();
  app.settings.showSearch = true;
  app.redraw();
}

/** Controls that play the events of the active planner's search. */
export function playerBar(app: App): TemplateResult {
  const { player } = app;
  const name = app.activePlanner ? plannerName(app.activePlanner) : '';
  const kinds = new Set(player.events?.kinds ?? '');
  const palette = app.theme.palette;
  return html`<div class="player" role="group" aria-label="Events of the search">
    <div class="row">
      <button
        type="button"
        data-testid="play"
        ?disabled=${player.count === 0}
        @click=${() => show(app, () => player.toggle())}
      >
        ${player.isPlaying ? 'Pause' : 'Play'}
      </button>
      <button
        type="button"
        data-testid="step-back"
        ?disabled=${player.count === 0}
        @click=${() => show(app, () => player.step(-1))}
      >
        Step back
      </button>
      <button
        type="button"
        data-testid="step"
        ?disabled=${player.count === 0}
        @click=${() => show(app, () => player.step(1))}
      >
        Step
      </button>
      <button
        type="button"
        data-testid="rewind"
        ?disabled=${player.count === 0}
        @click=${() =>
          show(app, () => {
            player.isPlaying = false;
            player.seek(0);
          })}
      >
        To the start
      </button>
      <label
        >Speed
        <select
          data-testid="player-speed"
          .value=${live(String(player.speed))}
          @change=${(event: Event) => {
            player.speed = Number((event.target as HTMLSelectElement).value);
            app.redraw();
          }}
        >
          ${[0.1, 0.25, 0.5, 1, 2, 4].map((speed) => html`<option value=${speed} ?selected=${speed === player.speed}>× ${speed}</option>`)}
        </select></label
      >
      <label class="check"
        ><input
          type="checkbox"
          data-testid="show-search"
          .checked=${live(app.settings.showSearch)}
          @change=${(event: Event) => app.changeSettings({ showSearch: (event.target as HTMLInputElement).checked })}
        />
        on the map</label
      >
    </div>
    <label class="wide"
      >event
      <input
        data-testid="scrub"
        type="range"
        min="0"
        max=${player.count}
        step="1"
        .value=${live(String(player.shown))}
        ?disabled=${player.count === 0}
        aria-valuetext=${`${player.shown} of ${player.count}, ${player.describe()}`}
        @input=${(event: Event) =>
          show(app, () => {
            player.isPlaying = false;
            player.seek(Number((event.target as HTMLInputElement).value));
          })}
    /></label>
    <p class="readout" data-testid="event">
      ${player.count === 0 ? `The search of ${name} reports no events.` : `${name}: event ${player.shown} of ${player.count}${player.shown > 0 ? `, ${player.describe()}` : ''}.`}
      ${player.events && player.events.left_out > 0 ? `${player.events.left_out} more events are left out.` : nothing}
    </p>
    <p class="legend">
      ${legend.filter(([kind]) => kinds.has(kind)).map(([, text, colour]) => html`<span><span class="swatch" style="background:${palette[colour as keyof typeof palette]}"></span>${text}</span>`)}
    </p>
  </div>`;
}
