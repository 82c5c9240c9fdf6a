// SPDX-License-Identifier: MIT

import { html, nothing, type TemplateResult } from 'lit-html';
import type { App } from './app.ts';
import { exportPng, exportResults, exportScene, exportSvg } from './export.ts';
import type { Planning } from './planning.ts';
import { toFragment } from './share.ts';

/** Longer addresses do not get through many programs. */
const longAddress = 8000;

/** A link to the scene, and files of scene, results and pictures. */
export class ShareSection {
  private link = '';
  private message = '';

  constructor(
    private readonly app: App,
    private readonly planning: Planning,
    private readonly canvas: HTMLCanvasElement,
  ) {}

  private async share(): Promise<void> {
    const fragment = await toFragment(this.app);
    history.replaceState(null, '', fragment);
    this.link = location.href;
    const size = `The address has ${this.link.length} characters${this.link.length > longAddress ? ', which is too long for some programs: send the scene as a file instead' : ''}.`;
    try {
      await navigator.clipboard.writeText(this.link);
      this.message = `Copied. ${size}`;
    } catch {
      this.message = `Copy the address. ${size}`;
    }
    this.app.redraw();
  }

  private async guarded(work: Promise<void>): Promise<void> {
    try {
      await work;
    } catch (error) {
      this.message = error instanceof Error ? error.message : String(error);
    }
    this.app.redraw();
  }

  template(): TemplateResult {
    const { app, planning, canvas } = this;
    return html`<div class="row">
        <button type="button" data-testid="share" @click=${() => void this.guarded(this.share())}>
          Share by address
        </button>
        <button type="button" data-testid="export-scene" @click=${() => exportScene(app)}>
          Scene, JSON
        </button>
        <button type="button" data-testid="export-json" @click=${() => exportResults(app)}>
          Results, JSON
        </button>
        <button
          type="button"
          data-testid="export-svg"
          @click=${() => void this.guarded(exportSvg(app, planning))}
        >
          SVG
        </button>
        <button
          type="button"
          data-testid="export-png"
          @click=${() => void this.guarded(exportPng(app, canvas))}
        >
          PNG
        </button>
      </div>
      ${this.link ? html`<input class="link" data-testid="link" readonly aria-label="Address of this scene" .value=${this.link} @focus=${(event: Event) => (event.target as HTMLInputElement).select()} />` : nothing}
      <p class="sentence" role="status">${this.message}</p>`;
  }
}
