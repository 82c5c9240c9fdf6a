// SPDX-License-Identifier: MIT

import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import type { App, Settings } from './app.ts';
import { editable } from './editable.ts';
import {
  itemName,
  itemPoint,
  itemsOf,
  moveItem,
  obstacleAt,
  partsOf,
  removeItem,
  sameItem,
  splitEdge,
  type Item,
} from './edit.ts';
import { degrees, radians, short } from './format.ts';
import type { Movement, Point, SpeedLimits, VehicleChoice } from './protocol.ts';
import { boundsOf, toGridFrame, toMapFrame } from './scene.ts';

export interface NumberField {
  id: string;
  label: string;
  unit: string;
  value: number | undefined;
  min?: number;
  max?: number;
  step?: number;
  /** What stands in an empty field; without it the field must not be empty. */
  empty?: string;
  set: (value: number | undefined) => void;
}

/** A field for a number with its unit. */
export function numberField({
  id,
  label,
  unit,
  value,
  min,
  max,
  step,
  empty,
  set,
}: NumberField): TemplateResult {
  const change = (event: Event): void => {
    const { value: text } = event.target as HTMLInputElement;
    const number = Number(text);
    if (text === '') {
      if (empty !== undefined) set(undefined);
    } else if (Number.isFinite(number)) {
      set(Math.min(Math.max(number, min ?? -Infinity), max ?? Infinity));
    }
  };
  return html`<label for=${id}>${label}</label
    ><span class="value"
      ><input
        type="number"
        id=${id}
        data-testid=${id}
        step=${step ?? 'any'}
        min=${min ?? nothing}
        max=${max ?? nothing}
        placeholder=${empty ?? nothing}
        ${editable(value === undefined ? '' : short(value))}
        @change=${change}
      /><span class="unit">${unit}</span></span
    >`;
}

/** The slider of the radius goes up to a tenth of the map. */
export function largestRadius(app: App): number {
  const [x0, y0, x1, y1] = boundsOf(app.scene.world);
  return Number((Math.min(x1 - x0, y1 - y0) / 10).toPrecision(2));
}

function radiusSlider(app: App): TemplateResult {
  const most = largestRadius(app);
  const slide = (event: Event): void => {
    if (!app.inGesture) app.beginGesture();
    app.edit({ ...app.scene, radius: Number((event.target as HTMLInputElement).value) });
  };
  return html`<label for="radius-slider">Safety radius</label>
    <span class="value"
      ><input
        type="range"
        id="radius-slider"
        data-testid="radius"
        min="0"
        max=${most}
        step=${most / 200}
        .value=${live(String(app.scene.radius))}
        aria-valuetext="${short(app.scene.radius)} metres"
        @input=${slide}
        @change=${() => app.endGesture()}
    /></span>
    ${numberField({ id: 'radius-number', label: 'as a number', unit: 'm', value: app.scene.radius, min: 0, step: 0.01, set: (radius) => app.edit({ ...app.scene, radius: radius ?? 0 }) })}`;
}

const movements: [Movement, string][] = [
  ['no_cut', 'both sides free'],
  ['no_squeeze', 'one side free'],
  ['allow', 'always'],
  ['four_connected', 'never'],
];

export function robotSection(app: App): TemplateResult {
  const { vehicle, speed } = app.settings;
  const { scene } = app;
  const setVehicle = (change: Partial<VehicleChoice>): void =>
    app.changeSettings({ vehicle: { ...vehicle, ...change } });
  const setSpeed = (key: keyof SpeedLimits, value: number | undefined): void => {
    const { [key]: _, ...rest } = speed;
    app.changeSettings({
      speed: { ...rest, ...(value !== undefined && { [key]: value }) } as SpeedLimits,
    });
  };
  const heading = (key: 'startHeading' | 'goalHeading', label: string): TemplateResult =>
    numberField({
      id: key,
      label,
      unit: '°',
      value: degrees(scene[key]),
      step: 5,
      set: (value) => app.edit({ ...scene, [key]: radians(value ?? 0) }),
    });
  const limit = (
    key: keyof SpeedLimits,
    label: string,
    unit: string,
    empty?: string,
  ): TemplateResult =>
    numberField({
      id: key,
      label,
      unit,
      value: speed[key],
      min: 0.01,
      ...(empty && { empty }),
      set: (value) => setSpeed(key, value),
    });
  return html`<div class="option-grid">
      ${radiusSlider(app)} <label for="movement">Diagonal steps</label
      ><span class="value"
        ><select
          id="movement"
          .value=${live(scene.movement)}
          @change=${(event: Event) => app.edit({ ...scene, movement: (event.target as HTMLSelectElement).value as Movement })}
        >
          ${movements.map(([value, text]) => html`<option value=${value} ?selected=${value === scene.movement}>${text}</option>`)}
        </select></span
      >
      ${scene.world.kind === 'workspace' ? numberField({ id: 'lattice', label: 'Lattice spacing', unit: 'm', value: scene.world.resolution, min: 1e-3, empty: 'chosen', set: (resolution) => setResolution(app, resolution) }) : nothing}
    </div>
    ${
      app.hasVehicles
        ? html`<h3>Vehicle</h3>
            <div class="option-grid" data-testid="vehicle">
              ${heading('startHeading', 'Heading at start')}${heading('goalHeading', 'Heading at goal')}
              ${numberField({ id: 'turning-radius', label: 'Turning radius', unit: 'm', value: vehicle.min_turning_radius, min: 0, step: 0.1, set: (value) => setVehicle({ min_turning_radius: value ?? 1 }) })}
              <label for="reverse">May reverse</label
              ><span class="value"
                ><input
                  type="checkbox"
                  id="reverse"
                  .checked=${live(vehicle.reverse)}
                  @change=${(event: Event) => setVehicle({ reverse: (event.target as HTMLInputElement).checked })}
              /></span>
              <label for="car">Has a body</label
              ><span class="value"
                ><input
                  type="checkbox"
                  id="car"
                  .checked=${live(vehicle.car !== undefined)}
                  @change=${(event: Event) => toggleCar(app, (event.target as HTMLInputElement).checked)}
              /></span>
              ${
                vehicle.car
                  ? (['length', 'width', 'wheelbase'] as const).map((key) =>
                      numberField({
                        id: `car-${key}`,
                        label: key[0]?.toUpperCase() + key.slice(1),
                        unit: 'm',
                        value: vehicle.car?.[key],
                        min: key === 'wheelbase' ? 0 : 0.01,
                        step: 0.1,
                        set: (value) =>
                          vehicle.car && setVehicle({ car: { ...vehicle.car, [key]: value ?? 1 } }),
                      }),
                    )
                  : nothing
              }
            </div>`
        : nothing
    }
    <details>
      <summary>Limits of the drive</summary>
      <div class="option-grid">
        ${limit('max_speed', 'Speed', 'm/s')}${limit('max_acceleration', 'Acceleration', 'm/s²')}${limit('max_deceleration', 'Deceleration', 'm/s²')}
        ${limit('max_lateral_acceleration', 'Lateral acceleration', 'm/s²')}${limit('max_jerk', 'Jerk', 'm/s³', 'any')}
        ${numberField({ id: 'time-limit', label: 'Time for a plan', unit: 's', value: app.settings.timeLimit, min: 0.001, set: (value) => app.changeSettings({ timeLimit: value ?? 5 }) })}
      </div>
    </details>`;
}

function setResolution(app: App, resolution: number | undefined): void {
  const { world } = app.scene;
  if (world.kind !== 'workspace') return;
  const { resolution: _, ...rest } = world;
  app.edit({ ...app.scene, world: resolution === undefined ? rest : { ...rest, resolution } });
}

function toggleCar(app: App, has: boolean): void {
  const { car: _, ...rest } = app.settings.vehicle;
  app.changeSettings({
    vehicle: has ? { ...rest, car: { length: 4.5, width: 1.8, wheelbase: 2.7 } } : rest,
  });
}

function positionFields(app: App, item: Item): TemplateResult | typeof nothing {
  const { scene } = app;
  if (item.kind === 'startHeading' || item.kind === 'goalHeading') {
    return numberField({
      id: 'item-heading',
      label: 'heading',
      unit: '°',
      value: degrees(scene[item.kind]),
      step: 5,
      set: (value) => app.edit({ ...scene, [item.kind]: radians(value ?? 0) }),
    });
  }
  if (item.kind === 'size') {
    const disc = obstacleAt(scene, item.index);
    if (!disc || 'polygon' in disc) return nothing;
    return numberField({
      id: 'item-radius',
      label: 'radius',
      unit: 'm',
      value: disc.radius,
      min: 1e-3,
      set: (r) =>
        app.edit(moveItem(scene, item, [disc.center[0] + (r ?? disc.radius), disc.center[1]])),
    });
  }
  const inGrid = itemPoint(scene, item, 0);
  if (!inGrid) return nothing;
  const at = toMapFrame(scene.world, inGrid);
  const set = (to: Point): void => app.edit(moveItem(scene, item, toGridFrame(scene.world, to)));
  return html`${numberField({ id: 'item-x', label: 'x', unit: 'm', value: at[0], set: (x) => set([x ?? at[0], at[1]]) })}
  ${numberField({ id: 'item-y', label: 'y', unit: 'm', value: at[1], set: (y) => set([at[0], y ?? at[1]]) })}`;
}

/** What is selected, with its coordinates: a way to edit all of the scene without a pointer. */
export function selectionSection(app: App): TemplateResult {
  const { scene, selection } = app;
  const parts = selection && 'index' in selection ? partsOf(scene, selection.index) : [];
  const items = [...itemsOf(scene, app.hasVehicles), ...parts];
  const choose = (event: Event): void => {
    app.selection = items[Number((event.target as HTMLSelectElement).value)] ?? null;
    app.redraw();
  };
  return html`<div class="option-grid">
      <label for="item">Selected</label
      ><span class="value"
        ><select
          id="item"
          data-testid="item"
          .value=${live(String(items.findIndex((item) => sameItem(item, selection))))}
          @change=${choose}
        >
          <option value="-1">nothing</option>
          ${items.map((item, i) => html`<option value=${i} ?selected=${sameItem(item, selection)}>${itemName(scene, item)}</option>`)}
        </select></span
      >
      ${selection ? positionFields(app, selection) : nothing}
    </div>
    ${
      selection && 'index' in selection
        ? html`<div class="row">
            <button
              type="button"
              data-testid="delete"
              @click=${() => {
                app.edit(removeItem(scene, selection));
                app.selection = null;
                app.redraw();
              }}
            >
              Remove
            </button>
            ${selection.kind === 'vertex' ? html`<button type="button" @click=${() => app.edit(splitEdge(scene, selection))}>Insert a vertex after it</button>` : nothing}
          </div>`
        : nothing
    }`;
}

export function layerSection(app: App): TemplateResult {
  const toggle = (
    key: 'showZone' | 'showRoute' | 'showBand' | 'showSearch' | 'showUnchecked',
    text: string,
  ): TemplateResult =>
    html`<label class="check">
      <input
        type="checkbox"
        .checked=${live(app.settings[key])}
        @change=${(event: Event) => app.changeSettings({ [key]: (event.target as HTMLInputElement).checked } as Partial<Settings>)}
      />
      ${text}</label
    >`;
  return html`<div class="row">
    ${toggle('showZone', 'safety zones')}${toggle('showRoute', 'routes')}${toggle('showBand', 'certificate')}${toggle('showSearch', 'search')}${toggle('showUnchecked', 'unchecked spline')}
  </div>`;
}
