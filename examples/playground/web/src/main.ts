// SPDX-License-Identifier: MIT

import { html, nothing, render } from 'lit-html';
import wasmText from 'virtual:engine-wasm';
import EngineWorker from './worker.ts?worker&inline';
import './style.css';
import { alongAt, lengthOf, speedOf, timeAt } from './along.ts';
import { plannerSection } from './algorithms.ts';
import { App, type DockTab } from './app.ts';
import { MapCanvas } from './canvas.ts';
import { Client, required } from './client.ts';
import { comparison } from './compare.ts';
import { compile } from './embedded.ts';
import { openHelp } from './help.ts';
import { Keyboard } from './keyboard.ts';
import { defaultPlanner, MapSection } from './map_section.ts';
import { largestRadius, layerSection, robotSection, selectionSection } from './panel.ts';
import { Planning } from './planning.ts';
import { playerBar } from './player_bar.ts';
import { Plots, profile } from './plots.ts';
import type { Scene } from './scene.ts';
import { fromFragment } from './share.ts';
import { ShareSection } from './share_section.ts';
import { describe } from './status.ts';
import { exposeForTests } from './test_interface.ts';
import { toolbar } from './toolbar.ts';
import { PointerTools } from './tools.ts';
import { Tour } from './tour.ts';

/** What there is before the first map has come from the engine. */
const nothingYet: Scene = {
  name: '',
  world: { kind: 'workspace', bounds: [0, 0, 1, 1], obstacles: [] },
  radius: 0,
  movement: 'no_cut',
  yDown: false,
  start: [0, 0],
  goal: [1, 1],
  startHeading: 0,
  goalHeading: 0,
};
/** After this time of one plan the page offers to cancel it [ms]. */
const patience = 1500;

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no ${id}`);
  return found as T;
}

const wasm = compile(wasmText);
const makeClient = (): Client => new Client(() => new EngineWorker(), wasm);
const client = makeClient();
const app = new App(nothingYet);
const planning = new Planning(app, client, makeClient);
const mapCanvas = new MapCanvas(app, element<HTMLCanvasElement>('map'));
const pointer = new PointerTools(app, mapCanvas.canvas);
const plotCanvas = document.createElement('canvas');
plotCanvas.setAttribute('role', 'img');
plotCanvas.setAttribute('aria-label', 'Curvature, clearance and speed along the path');
const plots = new Plots(app, plotCanvas);
const maps = new MapSection(app, client);
const share = new ShareSection(app, planning, mapCanvas.canvas);
const tour = new Tour(app);
const help = (): void => openHelp(element<HTMLDialogElement>('help'), app.catalogue?.version ?? '');
const toggleTheme = (): void => {
  app.theme.toggle();
  app.redraw();
};
const keyboard = new Keyboard(
  app,
  pointer,
  {
    help,
    theme: toggleTheme,
    play: () => {
      app.settings.showSearch = true;
      app.player.toggle();
      app.redraw();
    },
    step: (by) => {
      app.settings.showSearch = true;
      app.player.step(by);
    },
    changeRadius: (steps) => {
      const most = largestRadius(app);
      app.edit({
        ...app.scene,
        radius: Math.min(Math.max(app.scene.radius + (steps * most) / 50, 0), most),
      });
    },
  },
  mapCanvas.canvas,
);

// Frames are drawn on demand. A busy page draws one after the other, so that their rate is known.
let wanted = false;
let lastFrame = 0;
let busyUntil = 0;
let interval = 0;

function want(): void {
  busyUntil = performance.now() + 300;
  if (wanted) return;
  wanted = true;
  requestAnimationFrame(frame);
}

function frame(now: number): void {
  const elapsed = now - lastFrame;
  lastFrame = now;
  const isSequel = elapsed < 200;
  if (isSequel) interval = interval === 0 ? elapsed : interval + 0.1 * (elapsed - interval);
  wanted = false;
  if (mapCanvas.resize()) app.fit();
  app.player.advance(isSequel ? elapsed / 1000 : 0);
  drive(isSequel ? elapsed / 1000 : 0);
  planning.frame();
  mapCanvas.draw(pointer, keyboard);
  // The first plan does not wait for the controls.
  if (app.catalogue) showPage();
  if (app.tab === 'profile') plots.draw(mapCanvas.pixelRatio);
  if (app.player.isPlaying || app.driving || planning.busyFor > 0)
    busyUntil = performance.now() + 300;
  if (performance.now() < busyUntil && !wanted) {
    wanted = true;
    requestAnimationFrame(frame);
  }
}

/** Moves the robot along the path, as fast as the speed profile says. */
function drive(seconds: number): void {
  if (!app.driving) return;
  const speed = speedOf(app.activeReply);
  if (!speed || app.along === null) {
    app.driving = speed !== null;
    return;
  }
  const time = Math.max(timeAt(speed, app.along), 1e-3) + seconds;
  app.along = alongAt(speed, time);
  if (time >= speed.duration) {
    app.along = lengthOf(app.activeReply);
    app.driving = false;
  }
}

const tabs: [DockTab, string][] = [
  ['comparison', 'Comparison'],
  ['profile', 'Along the path'],
  ['search', 'Search events'],
];
let spoken = '';

function showPage(): void {
  const status = describe(app);
  render(toolbar(app, pointer), element('toolbar'));
  const statusLine = element('status');
  if (statusLine.textContent !== status.text) statusLine.textContent = status.text;
  statusLine.className = status.tone;
  // A reader of the screen hears the state once nothing changes any more.
  if (!app.inGesture && app.outcomes.get(app.active)?.complete && spoken !== status.text) {
    spoken = status.text;
    element('announcer').textContent = spoken;
  }
  render(
    html`${
      app.notice
        ? html`<div
            class="notice ${app.notice.kind}"
            data-testid="notice"
            role=${app.notice.kind === 'error' ? 'alert' : 'status'}
          >
            <span>${app.notice.text}</span>
            <button
              type="button"
              class="small"
              @click=${() => {
                app.notice = null;
                app.redraw();
              }}
            >
              Close
            </button>
          </div>`
        : nothing
    }
    ${
      planning.busyFor > patience
        ? html`<div class="notice" role="status">
            <span>Planning takes ${(planning.busyFor / 1000).toFixed(0)} s.</span>
            <button
              type="button"
              class="small"
              data-testid="cancel"
              @click=${() => planning.cancel()}
            >
              Cancel
            </button>
          </div>`
        : nothing
    }${tour.template()}`,
    element('notices'),
  );
  element('rate').textContent =
    interval > 0 ? `${Math.min(Math.round(1000 / interval), 240)} frames/s` : '';
  render(
    html`<div class="tabs" role="tablist">
        ${tabs.map(
          ([tab, text]) =>
            html`<button
              type="button"
              role="tab"
              id="tab-${tab}"
              data-testid="tab-${tab}"
              aria-selected=${app.tab === tab}
              aria-controls="tab-panel"
              @click=${() => {
                app.tab = tab;
                app.redraw();
              }}
            >
              ${text}
            </button>`,
        )}
      </div>
      <div id="tab-panel" role="tabpanel" aria-labelledby="tab-${app.tab}">
        ${app.tab === 'comparison' ? comparison(app) : app.tab === 'profile' ? profile(app, plotCanvas) : playerBar(app)}
      </div>`,
    element('dock'),
  );
  render(
    html`<details open>
        <summary>Map</summary>
        ${maps.template()}${layerSection(app)}
      </details>
      <details open>
        <summary>Robot</summary>
        ${robotSection(app)}
      </details>
      <details open>
        <summary>Planners</summary>
        ${app.catalogue ? plannerSection(app) : nothing}
      </details>
      <details ?open=${matchMedia('(min-width: 900px)').matches}>
        <summary>Selection</summary>
        ${selectionSection(app)}
      </details>
      <details open>
        <summary>Share and save</summary>
        ${share.template()}
      </details>`,
    element('panel-content'),
  );
  const theme = element('theme');
  const text = app.theme.isDark ? 'Light' : 'Dark';
  if (theme.textContent !== text) theme.textContent = text;
}

function acceptDrops(): void {
  window.addEventListener('dragover', (event) => event.preventDefault());
  window.addEventListener('drop', (event) => {
    event.preventDefault();
    const files = event.dataTransfer?.files;
    if (files && files.length > 0) void maps.open(files);
  });
}

/** Shows the scene of the address, or the first map. */
async function openFirst(): Promise<void> {
  try {
    const restored = await fromFragment(location.hash);
    if (restored) {
      app.settings = { ...app.settings, ...restored.settings };
      app.planners = restored.planners;
      app.active = restored.active;
      maps.preset = '';
      app.open(restored.scene);
      return;
    }
  } catch (error) {
    app.notice = { kind: 'error', text: error instanceof Error ? error.message : String(error) };
  }
  const { notice } = app;
  app.addPlanner(defaultPlanner);
  await maps.openPreset('maze');
  app.notice ??= notice;
}

async function start(): Promise<void> {
  app.listen(want, want);
  mapCanvas.resize();
  element('help-button').addEventListener('click', help);
  element('tour-button').addEventListener('click', () => tour.start());
  element('theme').addEventListener('click', toggleTheme);
  element('panel-button').addEventListener('click', (event) => {
    const isOpen = document.body.classList.toggle('panel-closed');
    (event.currentTarget as HTMLElement).setAttribute('aria-expanded', String(!isOpen));
    want();
  });
  mapCanvas.canvas.addEventListener('blur', want);
  mapCanvas.canvas.addEventListener('focus', want);
  window.addEventListener('focusout', want);
  new ResizeObserver(want).observe(mapCanvas.canvas);
  window.addEventListener('hashchange', () => location.reload());
  acceptDrops();
  const opened = openFirst();
  const catalogue = required(client.call({ do: 'catalogue' }));
  await opened;
  app.catalogue = (await catalogue).reply;
  app.history.clear();
  app.planAgain();
  planning.frame();
}

const started = start();
started.catch((error: unknown) => {
  const reason = error instanceof Error ? error.message : String(error);
  element('status').textContent = `This browser cannot run the playground: ${reason}`;
});
exposeForTests(app, planning, started);
