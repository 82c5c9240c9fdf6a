// SPDX-License-Identifier: MIT

/** engine.wasm, gzip and base64. Made by vite.config.ts, as are the maps. */
declare module 'virtual:engine-wasm' {
  const gzip: string;
  export default gzip;
}
declare module 'virtual:maps' {
  const maps: import('./embedded.ts').EmbeddedMaps;
  export default maps;
}
declare module '@engine/engine.js' {
  const createEngine: import('./engine.ts').EngineFactory;
  export default createEngine;
}
