// SPDX-License-Identifier: MIT

import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import type { App, ToolName } from './app.ts';
import { toolProblem, type PointerTools } from './tools.ts';

const tools: [ToolName, string, string][] = [
  ['select', 'Select', 'V'],
  ['polygon', 'Polygon', 'O'],
  ['disc', 'Disc', 'D'],
  ['paint', 'Paint', 'B'],
  ['erase', 'Erase', 'E'],
];

export function toolbar(app: App, pointer: PointerTools): TemplateResult {
  return html`<div class="group" role="group" aria-label="Tools">
      ${tools.map(([tool, text, key]) => {
        const problem = toolProblem(app, tool);
        return html`<button
          type="button"
          data-testid="tool-${tool}"
          aria-pressed=${app.tool === tool}
          aria-disabled=${problem !== null}
          title=${problem ?? `${text} (${key})`}
          @click=${() => pointer.choose(tool)}
        >
          ${text}
        </button>`;
      })}
    </div>
    ${
      app.tool === 'paint' || app.tool === 'erase'
        ? html`<label
            >brush
            <input
              type="range"
              min="1"
              max="15"
              step="1"
              data-testid="brush"
              .value=${live(String(app.settings.brush))}
              aria-valuetext="${app.settings.brush} cells"
              @input=${(event: Event) => app.changeSettings({ brush: Number((event.target as HTMLInputElement).value) })}
          /></label>`
        : nothing
    }
    ${
      app.tool === 'polygon' && pointer.draft.length > 0
        ? html`<div class="group">
            <button
              type="button"
              ?disabled=${pointer.draft.length < 3}
              @click=${() => pointer.closePolygon()}
            >
              Close polygon
            </button>
            <button type="button" @click=${() => pointer.cancelDraft()}>Cancel</button>
          </div>`
        : nothing
    }
    <div class="group" role="group" aria-label="History">
      <button
        type="button"
        data-testid="undo"
        ?disabled=${!app.history.canUndo}
        @click=${() => app.undo()}
      >
        Undo
      </button>
      <button
        type="button"
        data-testid="redo"
        ?disabled=${!app.history.canRedo}
        @click=${() => app.redo()}
      >
        Redo
      </button>
    </div>
    <div class="group" role="group" aria-label="View">
      <button
        type="button"
        aria-label="Zoom in"
        @click=${() => {
          app.view.zoom(1.25);
          app.redraw();
        }}
      >
        +
      </button>
      <button
        type="button"
        aria-label="Zoom out"
        @click=${() => {
          app.view.zoom(0.8);
          app.redraw();
        }}
      >
        −
      </button>
      <button type="button" data-testid="fit" @click=${() => app.fit()}>Whole map</button>
    </div>`;
}
