// SPDX-License-Identifier: MIT

import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { defineConfig, type Plugin } from 'vite';
import { embeddedMaps } from './embed/maps.ts';

const here = dirname(fileURLToPath(import.meta.url));
const testData = resolve(here, '../../../tests/data');

function engineFolder(): string {
  const folder = process.env.TUTAVIA_ENGINE_DIR;
  if (!folder)
    throw new Error('TUTAVIA_ENGINE_DIR must name the folder of engine.js and engine.wasm');
  for (const name of ['engine.js', 'engine.wasm']) {
    if (!existsSync(join(folder, name))) throw new Error(`${join(folder, name)} does not exist`);
  }
  return resolve(folder);
}

/** Modules whose text is made here: the engine's binary and the maps. */
function embeddedData(folder: string): Plugin {
  const texts = new Map<string, () => unknown>([
    [
      'virtual:engine-wasm',
      () => gzipSync(readFileSync(join(folder, 'engine.wasm')), { level: 9 }).toString('base64'),
    ],
    ['virtual:maps', () => embeddedMaps(testData, process.env.TUTAVIA_MOVINGAI_DIR)],
  ]);
  return {
    name: 'embedded-data',
    resolveId: (id) => (texts.has(id) ? `\0${id}` : undefined),
    load(id) {
      const text = texts.get(id.slice(1));
      return text ? `export default ${JSON.stringify(text())};` : undefined;
    },
  };
}

/** The engine gets its binary from the page; without this the bundler would add the file once more. */
function withoutBinaryFile(): Plugin {
  return {
    name: 'without-binary-file',
    enforce: 'pre',
    transform: (code, id) =>
      id.endsWith('/engine.js')
        ? code.replace(/new URL\("engine\.wasm",\s*import\.meta\.url\)/, '"engine.wasm"')
        : undefined,
  };
}

/** The licences of what the page contains, which have to go with it. */
function notices(): string {
  const licences = ['lit-html', 'yaml'].map((name) => {
    const text = readFileSync(join(here, 'node_modules', name, 'LICENSE'), 'utf8');
    return `${name}\n\n${text.trim()}\n`;
  });
  const text = [readFileSync(join(here, 'NOTICES.txt'), 'utf8'), ...licences].join('\n');
  if (text.includes('-->')) throw new Error('a notice would end the comment that holds it');
  return text;
}

/** Moves script and style into the page, because pages of file:// cannot load modules. */
function singleFile(): Plugin {
  return {
    name: 'single-file',
    enforce: 'post',
    generateBundle(_, bundle) {
      const page = bundle['index.html'];
      if (page?.type !== 'asset') throw new Error('index.html is missing');
      let html = String(page.source);
      for (const [name, file] of Object.entries(bundle)) {
        if (file === page) continue;
        if (file.type === 'chunk') {
          // A closing tag within a string of the script would end the script.
          const code = file.code.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
          html = html.replace(/<script type="module"[^>]*src="[^"]*"[^>]*><\/script>/, '');
          html = html.replace('</body>', () => `<script type="module">${code}</script>\n</body>`);
        } else if (name.endsWith('.css')) {
          html = html.replace(
            /<link rel="stylesheet"[^>]*>/,
            () => `<style>${file.source}</style>`,
          );
        }
        delete bundle[name];
      }
      page.source = `${html}\n<!--\n${notices()}\n-->\n`;
    },
  };
}

export default defineConfig(() => {
  const folder = engineFolder();
  return {
    root: here,
    base: './',
    resolve: { alias: { '@engine': folder } },
    plugins: [embeddedData(folder), singleFile()],
    worker: { format: 'iife' as const, plugins: () => [withoutBinaryFile()] },
    build: {
      target: 'es2022',
      outDir: process.env.TUTAVIA_PLAYGROUND_DIR ?? 'dist',
      emptyOutDir: false,
      assetsInlineLimit: 1 << 30,
      cssCodeSplit: false,
      modulePreload: false,
      reportCompressedSize: false,
      chunkSizeWarningLimit: 4096,
    },
  };
});
