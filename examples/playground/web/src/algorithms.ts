// SPDX-License-Identifier: MIT

import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import type { App } from './app.ts';
import {
  choose,
  isForVehicles,
  plannerName,
  smoothersFor,
  unavailable,
  type Choice,
  type Planner,
} from './choices.ts';
import { editable } from './editable.ts';
import type { AlgorithmDescription, OptionDescription } from './protocol.ts';

type Change = (choice: Choice) => void;

function setOption(choice: Choice, option: OptionDescription, value: string, change: Change): void {
  const options = { ...choice.options };
  if (value === '' || value === option.default_value) delete options[option.name];
  else options[option.name] = value;
  change({ ...choice, options });
}

function control(
  choice: Choice,
  option: OptionDescription,
  id: string,
  change: Change,
): TemplateResult {
  const value = choice.options[option.name] ?? option.default_value;
  const set = (text: string): void => setOption(choice, option, text.trim(), change);
  const names = option.type.split('|');
  if (names.length === 2 && names.includes('true') && names.includes('false')) {
    return html`<input
      type="checkbox"
      id=${id}
      .checked=${live(value === 'true')}
      @change=${(event: Event) => set(String((event.target as HTMLInputElement).checked))}
    />`;
  }
  const isNumber = names[0] === 'number' || names[0] === 'whole number';
  if (!isNumber) {
    return html`<select
      id=${id}
      .value=${live(value)}
      @change=${(event: Event) => set((event.target as HTMLSelectElement).value)}
    >
      ${names.map((name) => html`<option value=${name} ?selected=${name === value}>${name}</option>`)}
    </select>`;
  }
  // A text field, because some numbers are written inf or none.
  return html`<input
    type="text"
    id=${id}
    size="8"
    inputmode="decimal"
    autocomplete="off"
    ${editable(value)}
    placeholder=${option.default_value}
    @change=${(event: Event) => set((event.target as HTMLInputElement).value)}
  />`;
}

/** The controls of an algorithm's options. Those of the vehicle have their own place in the panel. */
function optionForm(
  choice: Choice,
  algorithm: AlgorithmDescription | undefined,
  prefix: string,
  change: Change,
): TemplateResult | typeof nothing {
  const options = (algorithm?.options ?? []).filter(({ name }) => !name.startsWith('vehicle.'));
  if (options.length === 0) return nothing;
  const given = Object.keys(choice.options).length;
  return html`<details class="options">
    <summary>Options of ${choice.name}${given > 0 ? ` (${given} changed)` : ''}</summary>
    <div class="option-grid">
      ${options.map((option) => {
        const id = `${prefix}-${option.name}`;
        return html`<label for=${id} title=${option.sentence}
            >${option.name.replaceAll('_', ' ')}</label
          >
          <span class="value"
            >${control(choice, option, id, change)}<span class="unit">${option.unit}</span></span
          >
          <span class="sentence">${option.sentence}</span>`;
      })}
    </div>
    ${given > 0 ? html`<button type="button" class="small" @click=${() => change(choose(choice.name))}>Set to defaults</button>` : nothing}
  </details>`;
}

function searchSelect(app: App, planner: Planner): TemplateResult {
  const all = app.catalogue?.searches ?? [];
  const { world } = app.scene;
  const entry = (search: AlgorithmDescription): TemplateResult => {
    const problem = unavailable(search, world);
    return html`<option
      value=${search.name}
      ?disabled=${problem !== null}
      ?selected=${search.name === planner.search.name}
      title=${problem ?? search.sentence}
    >
      ${search.name}${problem ? `: ${problem}` : ''}
    </option>`;
  };
  return html`<select
    data-testid="search"
    id="search-${planner.id}"
    .value=${live(planner.search.name)}
    @change=${(event: Event) => app.changePlanner({ ...planner, search: choose((event.target as HTMLSelectElement).value) })}
  >
    <optgroup label="For a disc">
      ${all.filter((search) => !search.for_vehicles).map(entry)}
    </optgroup>
    <optgroup label="For a vehicle">
      ${all.filter((search) => search.for_vehicles).map(entry)}
    </optgroup>
  </select>`;
}

function stageSelect(app: App, planner: Planner, index: number): TemplateResult {
  const { catalogue } = app;
  const stage = planner.stages[index];
  const smoothers = catalogue ? smoothersFor(catalogue, isForVehicles(catalogue, planner)) : [];
  const replace = (name: string): void =>
    app.changePlanner({ ...planner, stages: planner.stages.with(index, choose(name)) });
  return html`<select
    data-testid=${index === 0 ? 'smoother' : 'smoother-stage'}
    id="smoother-${planner.id}-${index}"
    .value=${live(stage?.name ?? '')}
    aria-label=${index === 0 ? 'Smoother' : `Smoother ${index + 1}`}
    @change=${(event: Event) => replace((event.target as HTMLSelectElement).value)}
  >
    ${smoothers.map((smoother) => {
      const problem = unavailable(smoother, app.scene.world);
      return html`<option
        value=${smoother.name}
        ?disabled=${problem !== null}
        ?selected=${smoother.name === stage?.name}
        title=${problem ?? smoother.sentence}
      >
        ${smoother.name}${problem ? `: ${problem}` : ''}
      </option>`;
    })}
  </select>`;
}

function sentenceOf(list: AlgorithmDescription[] | undefined, name: string | undefined): string {
  return list?.find((algorithm) => algorithm.name === name)?.sentence ?? '';
}

/** The smoothers of a planner, each of which works on the result of the one before. */
function stages(app: App, planner: Planner): TemplateResult {
  const { catalogue } = app;
  const withStages = (list: Choice[]): void => app.changePlanner({ ...planner, stages: list });
  return html`${planner.stages.map(
      (stage, index) =>
        html` <div class="row">
            <label for="smoother-${planner.id}-${index}"
              >${index === 0 ? 'Smoother' : 'then'}</label
            >
            ${stageSelect(app, planner, index)}
            ${
              planner.stages.length > 1
                ? html`<button
                    type="button"
                    class="small"
                    aria-label="Remove smoother ${stage.name}"
                    @click=${() => withStages(planner.stages.toSpliced(index, 1))}
                  >
                    Remove
                  </button>`
                : nothing
            }
          </div>
          <p class="sentence">${sentenceOf(catalogue?.smoothers, stage.name)}</p>
          ${optionForm(
            stage,
            catalogue?.smoothers.find(({ name }) => name === stage.name),
            `option-${planner.id}-${index}`,
            (changed) => withStages(planner.stages.with(index, changed)),
          )}`,
    )}
    <button
      type="button"
      class="small"
      @click=${() => withStages([...planner.stages, choose('none')])}
    >
      Add a smoother after it
    </button>`;
}

function card(app: App, planner: Planner): TemplateResult {
  const { catalogue } = app;
  const search = catalogue?.searches.find(({ name }) => name === planner.search.name);
  const isActive = planner.id === app.active;
  const problem = search ? unavailable(search, app.scene.world) : null;
  return html`<fieldset
    class="planner ${isActive ? 'active' : ''}"
    data-testid="planner"
    @focusin=${() => !isActive && app.activate(planner.id)}
    @pointerdown=${() => !isActive && app.activate(planner.id)}
  >
    <legend>
      <span class="swatch" style="background:${app.theme.curve(planner.id)}"></span>
      ${plannerName(planner)}
    </legend>
    <div class="row">
      <label for="search-${planner.id}">Search</label>${searchSelect(app, planner)}
    </div>
    <p class="sentence">
      ${problem ? `${planner.search.name} ${problem}.` : (search?.sentence ?? '')}
    </p>
    ${optionForm(planner.search, search, `option-${planner.id}`, (changed) => app.changePlanner({ ...planner, search: changed }))}
    ${stages(app, planner)}
    <div class="row">
      <label for="seed-${planner.id}">Seed</label>
      <input
        id="seed-${planner.id}"
        type="number"
        min="0"
        step="1"
        ${editable(String(planner.seed))}
        @change=${(event: Event) => app.changePlanner({ ...planner, seed: Math.max(0, Math.trunc(Number((event.target as HTMLInputElement).value) || 0)) })}
      />
      <label class="check"
        ><input
          type="checkbox"
          .checked=${live(planner.visible)}
          @change=${(event: Event) => {
            planner.visible = (event.target as HTMLInputElement).checked;
            app.redraw();
          }}
        />
        on the map</label
      >
      <button
        type="button"
        class="small"
        ?disabled=${app.planners.length < 2}
        @click=${() => app.removePlanner(planner.id)}
      >
        Remove
      </button>
    </div>
  </fieldset>`;
}

/** Adds a planner for every search that works here, with the active planner's smoothers where they go. */
function addAll(app: App): void {
  const { catalogue, activePlanner: like } = app;
  if (!catalogue || !like) return;
  const vehicles = isForVehicles(catalogue, like);
  const present = new Set(app.planners.map(({ search }) => search.name));
  for (const search of catalogue.searches) {
    if (
      search.for_vehicles !== vehicles ||
      present.has(search.name) ||
      unavailable(search, app.scene.world)
    )
      continue;
    app.addPlanner({ search: choose(search.name), stages: like.stages, seed: like.seed });
  }
  app.activate(like.id);
}

export function plannerSection(app: App): TemplateResult {
  return html`${app.planners.map((planner) => card(app, planner))}
    <div class="row">
      <button
        type="button"
        data-testid="add-planner"
        @click=${() => {
          const like = app.activePlanner;
          if (like) app.addPlanner({ search: like.search, stages: like.stages, seed: like.seed });
        }}
      >
        Add a planner
      </button>
      <button type="button" data-testid="add-all" @click=${() => addAll(app)}>
        Add all searches
      </button>
      <button
        type="button"
        ?disabled=${app.planners.length < 2}
        @click=${() => {
          for (const { id } of app.planners) if (id !== app.active) app.removePlanner(id);
        }}
      >
        Keep the active one
      </button>
    </div>`;
}
