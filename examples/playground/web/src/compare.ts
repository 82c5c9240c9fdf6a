// SPDX-License-Identifier: MIT

import { html, nothing, type TemplateResult } from 'lit-html';
import type { App } from './app.ts';
import { plannerName, type Planner } from './choices.ts';
import { duration, fixed } from './format.ts';
import { planTime, verdict } from './status.ts';

const columns = [
  'planner',
  'proof',
  'length [m]',
  'to optimum',
  'curvature [1/m]',
  'clearance ≥ [m]',
  'turning [°]',
  'drive [s]',
  'time',
  'expanded',
];

function row(app: App, planner: Planner): TemplateResult {
  const outcome = app.outcomes.get(planner.id);
  const reply = outcome?.reply;
  const result = reply?.result;
  const { tone, word } = verdict(app, outcome);
  const isActive = planner.id === app.active;
  const speed = reply?.speed;
  const metrics = result?.metrics;
  const turning = metrics ? (metrics.turning_angle * 180) / Math.PI : undefined;
  return html`<tr
    data-testid="row"
    class=${isActive ? 'active' : ''}
    @click=${() => app.activate(planner.id)}
  >
    <th scope="row">
      <button type="button" class="plain" aria-pressed=${isActive}>
        <span class="swatch" style="background:${app.theme.curve(planner.id)}"></span
        >${plannerName(planner)}
      </button>
    </th>
    <td class=${tone} title=${outcome?.error ?? result?.detail ?? ''}>${word}</td>
    <td>${fixed(metrics?.length)}</td>
    <td>${result?.optimum ? result.optimum.ratio.toFixed(4) : '–'}</td>
    <td>${fixed(metrics?.max_curvature)}</td>
    <td>${fixed(result?.certificate?.lower)}</td>
    <td>${fixed(turning, 0)}</td>
    <td>${speed && 'duration' in speed ? speed.duration.toFixed(1) : '–'}</td>
    <td>${result ? duration(planTime(result)) : '–'}</td>
    <td>${result ? result.stats.expanded : '–'}</td>
  </tr>`;
}

/** All planners side by side. */
export function comparison(app: App): TemplateResult {
  return html`<div class="table-box" tabindex="0" role="region" aria-label="Comparison of planners">
    <table data-testid="comparison">
      <thead>
        <tr>
          ${columns.map((name) => html`<th scope="col" title=${name === 'time' ? 'Browsers measure time in steps of 0.1 ms' : nothing}>${name}</th>`)}
        </tr>
      </thead>
      <tbody>
        ${app.planners.map((planner) => row(app, planner))}
      </tbody>
    </table>
  </div>`;
}
