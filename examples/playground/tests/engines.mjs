// SPDX-License-Identifier: MIT
// The engine of the page in this process, and the one of this machine as a process of its own.

import { spawn } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

/** The engine in `folder` (engine.js, engine.wasm): a function from a request to a reply. */
export async function wasmEngine(folder) {
  // Emscripten writes a module whose name does not say so.
  const copies = mkdtempSync(join(tmpdir(), "engine-"));
  const copy = join(copies, "engine.mjs");
  copyFileSync(join(folder, "engine.js"), copy);
  const { default: create } = await import(pathToFileURL(copy).href);
  rmSync(copies, { recursive: true });
  const engine = await create({
    wasmBinary: readFileSync(join(folder, "engine.wasm")),
  });
  return async (request, bytes = new Uint8Array()) => {
    const text = JSON.stringify(request);
    const size = engine.lengthBytesUTF8(text) + 1;
    const textAt = engine._malloc(size);
    engine.stringToUTF8(text, textAt, size);
    const bytesAt = engine._malloc(bytes.length + 1);
    engine.HEAPU8.set(bytes, bytesAt);
    engine._tutavia_call(textAt, bytesAt, bytes.length);
    engine._free(textAt);
    engine._free(bytesAt);
    const from = engine._tutavia_reply_bytes();
    return {
      json: JSON.parse(engine.UTF8ToString(engine._tutavia_reply())),
      bytes: engine.HEAPU8.slice(
        from,
        from + engine._tutavia_reply_bytes_size(),
      ),
    };
  };
}

/** The same of tutavia-playground-engine, with `close()`. Requests wait for each other. */
export function nativeEngine(program) {
  const process = spawn(program, [], { stdio: ["pipe", "pipe", "inherit"] });
  let received = Buffer.alloc(0);
  let arrived = () => {};
  let failed = () => {};
  process.stdout.on("data", (data) => {
    received = Buffer.concat([received, data]);
    arrived();
  });
  process.on("error", (error) => failed(error));
  process.on("exit", (code) =>
    failed(new Error(`${program} ended with ${code}`)),
  );
  const more = () =>
    new Promise((resolve, reject) => {
      arrived = resolve;
      failed = reject;
    });
  const take = async (size) => {
    while (received.length < size) await more();
    const part = received.subarray(0, size);
    received = received.subarray(size);
    return part;
  };
  const line = async () => {
    for (;;) {
      const end = received.indexOf(10);
      if (end >= 0) return (await take(end + 1)).toString().trim();
      await more();
    }
  };
  const call = async (request, bytes = new Uint8Array()) => {
    const text = Buffer.from(JSON.stringify(request));
    process.stdin.write(`${text.length} ${bytes.length}\n`);
    process.stdin.write(text);
    process.stdin.write(bytes);
    const [jsonSize, bytesSize] = (await line()).split(" ").map(Number);
    const json = JSON.parse((await take(jsonSize)).toString());
    return { json, bytes: new Uint8Array(await take(bytesSize)) };
  };
  return Object.assign(call, { close: () => process.stdin.end() });
}
