// SPDX-License-Identifier: MIT

import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import type { App } from './app.ts';
import { choose, type Planner } from './choices.ts';
import type { Client } from './client.ts';
import { editable } from './editable.ts';
import {
  acceptedFiles,
  openFiles,
  withScenario,
  type FileSettings,
  type NamedBytes,
} from './files.ts';
import { presets, type PresetContent } from './presets.ts';
import type { ScenariosReply } from './protocol.ts';

/** Opens maps: built-in ones and files. */
export class MapSection {
  private scenarios: ScenariosReply['scenarios'] = [];
  private scenario = 0;
  private wktColumn = '';
  private files: NamedBytes[] = [];
  private requests = 0;
  /** Where the map comes from. */
  private source = '';
  /** The preset that was opened last, and the name of its scene. */
  preset = 'maze';
  private presetScene = '';

  constructor(
    private readonly app: App,
    private readonly client: Client,
  ) {}

  private get fileSettings(): FileSettings {
    const { terrain, unknown } = this.app.settings;
    return { terrain, unknown, wktColumn: this.wktColumn };
  }

  async openPreset(id: string): Promise<void> {
    const preset = presets.find((each) => each.id === id);
    if (!preset) return;
    this.preset = id;
    this.files = [];
    this.scenarios = [];
    const request = ++this.requests;
    await this.guarded(async () => {
      const content = await preset.load(this.client, this.fileSettings);
      if (request !== this.requests) return; // another map was chosen meanwhile
      this.app.notice = null;
      this.show(content);
    });
  }

  private show({ scene, planner, vehicle, note }: PresetContent): void {
    const { app } = this;
    this.source = note ?? '';
    if (vehicle) app.settings = { ...app.settings, vehicle };
    if (planner) this.replacePlanners(planner);
    else if (app.hasVehicles && this.preset !== '') this.replacePlanners(defaultPlanner);
    this.presetScene = scene.name;
    app.open(scene);
  }

  private replacePlanners(planner: Omit<Planner, 'id' | 'visible'>): void {
    this.app.planners = [];
    this.app.outcomes.clear();
    this.app.addPlanner(planner);
  }

  /** Opens files that were chosen or dropped together. */
  async open(files: Iterable<File>): Promise<void> {
    await this.guarded(async () => {
      this.files = await Promise.all(
        [...files].map(async (file) => ({
          name: file.name,
          bytes: new Uint8Array(await file.arrayBuffer()),
        })),
      );
      await this.reopen();
    });
  }

  private async reopen(): Promise<void> {
    if (this.files.length === 0) return;
    const { scene, scenarios, warnings } = await openFiles(
      this.client,
      this.files,
      this.fileSettings,
    );
    this.app.notice = warnings.length > 0 ? { kind: 'note', text: warnings.join('\n') } : null;
    if (scene) {
      this.preset = '';
      this.show({ scene });
    }
    this.scenarios = scenarios;
    if (scenarios.length > 0) this.chooseScenario(scenarios.length - 1);
    this.app.redraw();
  }

  private async guarded(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      this.app.notice = {
        kind: 'error',
        text: error instanceof Error ? error.message : String(error),
      };
    }
    this.app.redraw();
  }

  private chooseScenario(index: number): void {
    const scenario = this.scenarios[index];
    if (!scenario) return;
    this.scenario = index;
    this.app.edit(withScenario(this.app.scene, scenario));
  }

  private setFileOption(change: Partial<FileSettings>): void {
    const { wktColumn, ...rest } = change;
    if (wktColumn !== undefined) this.wktColumn = wktColumn;
    this.app.changeSettings(rest);
    void this.guarded(() => this.reopen());
  }

  template(): TemplateResult {
    const groups = [...new Set(presets.map(({ group }) => group))];
    const { settings, scene } = this.app;
    const preset = scene.name === this.presetScene ? this.preset : '';
    return html`<div class="row">
        <label for="preset">Map</label>
        <select
          id="preset"
          data-testid="preset"
          .value=${live(preset)}
          @change=${(event: Event) => void this.openPreset((event.target as HTMLSelectElement).value)}
        >
          ${preset === '' ? html`<option value="" selected>${scene.name}</option>` : nothing}
          ${groups.map(
            (group) =>
              html`<optgroup label=${group}>
                ${presets
                  .filter((each) => each.group === group)
                  .map(
                    ({ id, label }) =>
                      html`<option value=${id} ?selected=${id === preset}>${label}</option>`,
                  )}
              </optgroup>`,
          )}
        </select>
      </div>
      ${this.source ? html`<p class="sentence" data-testid="source">${this.source}</p>` : nothing}
      <div class="row">
        <label for="file">File</label>
        <input
          type="file"
          id="file"
          data-testid="file"
          multiple
          accept=${acceptedFiles}
          @change=${(event: Event) => {
            const input = event.target as HTMLInputElement;
            void this.open(input.files ?? []).then(() => (input.value = ''));
          }}
        />
      </div>
      <p class="sentence">
        Or drop files on the map: .json, .geojson, .wkt, .csv, .map, .scen, and a ROS .yaml together
        with its image.
      </p>
      ${this.scenarioTemplate()}
      <details>
        <summary>How files are read</summary>
        <div class="option-grid">
          <label for="terrain">Swamp and water of .map</label
          ><span class="value"
            ><select
              id="terrain"
              @change=${(event: Event) => this.setFileOption({ terrain: (event.target as HTMLSelectElement).value as FileSettings['terrain'] })}
            >
              ${(['blocked', 'free', 'refused'] as const).map((value) => html`<option value=${value} ?selected=${value === settings.terrain}>${value}</option>`)}
            </select></span
          >
          <label for="unknown">Unknown cells of ROS maps</label
          ><span class="value"
            ><select
              id="unknown"
              @change=${(event: Event) => this.setFileOption({ unknown: (event.target as HTMLSelectElement).value as FileSettings['unknown'] })}
            >
              ${(['blocked', 'free'] as const).map((value) => html`<option value=${value} ?selected=${value === settings.unknown}>${value}</option>`)}
            </select></span
          >
          <label for="wkt-column">Column of .csv with WKT</label
          ><span class="value"
            ><input
              id="wkt-column"
              type="text"
              size="8"
              placeholder="found by name"
              ${editable(this.wktColumn)}
              @change=${(event: Event) => this.setFileOption({ wktColumn: (event.target as HTMLInputElement).value })}
          /></span>
        </div>
      </details>`;
  }

  private scenarioTemplate(): TemplateResult | typeof nothing {
    const count = this.scenarios.length;
    if (count === 0) return nothing;
    const optimum = this.scenarios[this.scenario]?.optimum;
    return html`<div class="row">
      <label for="scenario">Scenario</label>
      <input
        type="number"
        id="scenario"
        data-testid="scenario"
        min="1"
        max=${count}
        ${editable(String(this.scenario + 1))}
        @change=${(event: Event) => void this.guarded(async () => this.chooseScenario(Math.min(Math.max(Number((event.target as HTMLInputElement).value), 1), count) - 1))}
      />
      <span class="sentence">of ${count}; shortest octile path ${optimum?.toFixed(2)} cells</span>
    </div>`;
  }
}

/** What the page starts with: the library's own default. */
export const defaultPlanner: Omit<Planner, 'id' | 'visible'> = {
  search: choose('auto'),
  stages: [choose('clothoid')],
  seed: 1,
};
