// SPDX-License-Identifier: MIT

import type { ErrorReply } from './protocol.ts';

/** What the page uses of the module that the compiler makes. */
export interface EngineModule {
  /** A new array after the memory has grown: read it again after every call. */
  readonly HEAPU8: Uint8Array;
  _malloc(size: number): number;
  _free(pointer: number): void;
  _tutavia_call(json: number, bytes: number, size: number): void;
  _tutavia_reply(): number;
  _tutavia_reply_bytes(): number;
  _tutavia_reply_bytes_size(): number;
  UTF8ToString(pointer: number): string;
  stringToUTF8(text: string, pointer: number, size: number): void;
  lengthBytesUTF8(text: string): number;
}

export type EngineFactory = (options: {
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
}) => Promise<EngineModule>;

/** A reply of the engine, as JSON text, with the bytes that came with it. */
export interface Answer {
  reply: string;
  bytes?: Uint8Array<ArrayBuffer>;
}

export function isError(reply: unknown): reply is ErrorReply {
  return typeof reply === 'object' && reply !== null && 'error' in reply;
}

/** The planning engine. Calls throw if the engine itself stops, such as without memory; make a new
 * one then. */
export class Engine {
  private constructor(private readonly module: EngineModule) {}

  /** The binary is compiled once, for all engines. */
  static async load(create: EngineFactory, binary: WebAssembly.Module): Promise<Engine> {
    const instantiate = new Promise<EngineModule>((resolve, reject) => {
      const instantiateWasm: Parameters<EngineFactory>[0]['instantiateWasm'] = (
        imports,
        receive,
      ) => {
        WebAssembly.instantiate(binary, imports).then(
          (instance) => receive(instance, binary),
          reject,
        );
        return {};
      };
      create({ instantiateWasm }).then(resolve, reject);
    });
    return new Engine(await instantiate);
  }

  /** `request` is JSON. */
  call(request: string, bytes?: Uint8Array): Answer {
    const { module } = this;
    const json = this.textInMemory(request);
    const size = bytes?.length ?? 0;
    const data = size > 0 ? module._malloc(size) : 0;
    if (size > 0 && data === 0) throw new Error('there is not enough memory');
    if (size > 0 && bytes) module.HEAPU8.set(bytes, data);
    module._tutavia_call(json, data, size);
    module._free(json);
    if (data !== 0) module._free(data);
    const reply = module.UTF8ToString(module._tutavia_reply());
    const count = module._tutavia_reply_bytes_size();
    if (count === 0) return { reply };
    const first = module._tutavia_reply_bytes();
    return { reply, bytes: module.HEAPU8.slice(first, first + count) as Uint8Array<ArrayBuffer> };
  }

  private textInMemory(text: string): number {
    const size = this.module.lengthBytesUTF8(text) + 1;
    const pointer = this.module._malloc(size);
    this.module.stringToUTF8(text, pointer, size);
    return pointer;
  }
}
