// SPDX-License-Identifier: MIT

import type { App } from './app.ts';
import { cellFile } from './cell_file.ts';
import { required } from './client.ts';
import type { Planning } from './planning.ts';
import { workspaceOf, type Scene } from './scene.ts';

/** Gives a file to the reader. */
export function download(name: string, content: BlobPart, type: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  // The download has started by then.
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function fileName(scene: Scene, ending: string): string {
  return `${scene.name.replace(/[^\w.-]+/g, '_') || 'scene'}.${ending}`;
}

/** A result file as tutavia-plan writes it, with the plans of all planners. */
export function resultText(app: App): string {
  const results = app.planners.flatMap(({ id }) => app.outcomes.get(id)?.reply?.result ?? []);
  return `${JSON.stringify({ tutavia: 1, results }, null, 1)}\n`;
}

export function sceneText(scene: Scene): string {
  const file =
    scene.world.kind === 'workspace'
      ? workspaceOf(scene, scene.world)
      : cellFile(scene, scene.world);
  return `${JSON.stringify(file, null, 1)}\n`;
}

export function exportResults(app: App): void {
  download(fileName(app.scene, 'results.json'), resultText(app), 'application/json');
}

export function exportScene(app: App): void {
  download(fileName(app.scene, 'json'), sceneText(app.scene), 'application/json');
}

/** The picture of the library, of the planners that are on the map. */
export async function exportSvg(app: App, planning: Planning): Promise<void> {
  const shown = app.planners.filter(({ id, visible }) => visible || id === app.active);
  const client = planning.prepareBackground();
  const { reply } = await required(
    client.call({ do: 'svg', plans: shown.map((planner) => planning.planRequest(planner)) }),
  );
  download(fileName(app.scene, 'svg'), reply.svg, 'image/svg+xml');
}

export function exportPng(app: App, canvas: HTMLCanvasElement): Promise<void> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (!blob) {
        reject(new Error('The browser could not make a picture.'));
        return;
      }
      download(fileName(app.scene, 'png'), blob, 'image/png');
      resolve();
    });
  });
}
