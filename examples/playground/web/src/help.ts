// SPDX-License-Identifier: MIT

import { html, render } from 'lit-html';
import { shortcuts } from './keyboard.ts';

/** Shows the shortcuts in a dialog. */
export function openHelp(dialog: HTMLDialogElement, version: string): void {
  render(
    html`<h2>Keys and gestures</h2>
      <p>The keys work while the map has the focus; undo, redo and this list everywhere.</p>
      <table class="keys">
        ${shortcuts.map(
          ([keys, text]) =>
            html`<tr>
              <th scope="row">${keys}</th>
              <td>${text}</td>
            </tr>`,
        )}
      </table>
      <p>
        Mouse and touch: drag start, goal, headings, obstacles and vertices; drag the ground to move
        the map; wheel or two fingers zoom. A double click on the border of a selected polygon adds
        a vertex, and closes a polygon that is being drawn.
      </p>
      <p>
        tutavia ${version}, MIT licence. Those of its parts stand at the end of the source of this
        page.
      </p>
      <form method="dialog"><button class="primary" autofocus>Close</button></form>`,
    dialog,
  );
  dialog.showModal();
}
