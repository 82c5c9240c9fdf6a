// SPDX-License-Identifier: MIT

import createEngine from '@engine/engine.js';
import { Engine } from './engine.ts';

/** The first message to the worker: the engine's binary, compiled. */
export interface StartMessage {
  wasm: WebAssembly.Module;
}
/** Later ones: a request in JSON. */
export interface CallMessage {
  request: string;
  bytes?: Uint8Array;
}
/** One answer to every call, in order; `stopped` if the engine can no longer be used. */
export type WorkerMessage =
  { reply: string; bytes?: Uint8Array<ArrayBuffer> } | { stopped: string };

interface WorkerScope {
  onmessage: ((event: MessageEvent<StartMessage | CallMessage>) => void) | null;
  postMessage(message: WorkerMessage): void;
}
const scope = self as unknown as WorkerScope;
let engine: Promise<Engine> | null = null;

async function answer(message: CallMessage): Promise<void> {
  try {
    const loaded = await engine;
    if (!loaded) throw new Error('the engine has no binary');
    scope.postMessage(loaded.call(message.request, message.bytes));
  } catch (error) {
    scope.postMessage({ stopped: error instanceof Error ? error.message : String(error) });
  }
}

scope.onmessage = ({ data }) => {
  if ('wasm' in data) engine = Engine.load(createEngine, data.wasm);
  else void answer(data);
};
