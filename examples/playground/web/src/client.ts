// SPDX-License-Identifier: MIT

import { isError } from './engine.ts';
import type {
  BuiltinRequest,
  CatalogueReply,
  CatalogueRequest,
  ErrorReply,
  OpenReply,
  OpenRequest,
  OpenRosRequest,
  OpenScenariosRequest,
  PlanReply,
  PlanRequest,
  Request,
  SceneReply,
  SceneRequest,
  ScenariosReply,
  SvgReply,
  SvgRequest,
} from './protocol.ts';
import type { CallMessage, StartMessage, WorkerMessage } from './worker.ts';

/** The reply to a request. */
export type ReplyTo<R extends Request> = R extends CatalogueRequest
  ? CatalogueReply
  : R extends SceneRequest
    ? SceneReply
    : R extends PlanRequest
      ? PlanReply
      : R extends OpenScenariosRequest
        ? ScenariosReply
        : R extends OpenRequest | OpenRosRequest | BuiltinRequest
          ? OpenReply
          : R extends SvgRequest
            ? SvgReply
            : never;

export type Replied<R extends Request> = {
  reply: ReplyTo<R> | ErrorReply;
  bytes?: Uint8Array<ArrayBuffer>;
};

interface Job {
  request: Request;
  bytes?: Uint8Array;
  done: (reply: unknown, bytes?: Uint8Array<ArrayBuffer>) => void;
}

/**
 * One worker with an engine. One request at a time is with the worker; the others wait here, so that
 * a newer scene, and a newer plan of the same slot, can take the place of an older one.
 */
export class Client {
  private worker: Worker | null = null;
  private inFlight: Job | null = null;
  private since = 0;
  private scene: Job | null = null;
  /** The scene that a new worker needs again. */
  private lastScene: Job | null = null;
  private calls: Job[] = [];
  private plans = new Map<number, Job>();

  constructor(
    private readonly makeWorker: () => Worker,
    private readonly wasm: Promise<WebAssembly.Module>,
  ) {
    void this.start();
  }

  /** How long the current request has been with the worker, in milliseconds; 0 without one. */
  get busyFor(): number {
    return this.inFlight ? performance.now() - this.since : 0;
  }

  setScene(
    request: SceneRequest,
    bytes: Uint8Array | undefined,
    done: (reply: SceneReply | ErrorReply) => void,
  ): void {
    this.scene = {
      request,
      ...(bytes && { bytes }),
      done: (reply) => done(reply as SceneReply | ErrorReply),
    };
    this.lastScene = this.scene;
    this.send();
  }

  /** Of several plans that wait for one slot, the newest is made. The slots take turns. */
  plan(slot: number, request: PlanRequest, done: (reply: PlanReply | ErrorReply) => void): void {
    this.plans.set(slot, { request, done: (reply) => done(reply as PlanReply | ErrorReply) });
    this.send();
  }

  forgetPlans(): void {
    this.plans.clear();
  }

  call<R extends Request>(request: R, bytes?: Uint8Array): Promise<Replied<R>> {
    return new Promise((resolve) => {
      const done: Job['done'] = (reply, replyBytes) =>
        resolve({
          reply: reply as ReplyTo<R> | ErrorReply,
          ...(replyBytes && { bytes: replyBytes }),
        });
      this.calls.push({ request, ...(bytes && { bytes }), done });
      this.send();
    });
  }

  /** Ends the worker, whatever it does, and starts another one. */
  cancel(): void {
    this.restart('cancelled');
  }

  private async start(): Promise<void> {
    const worker = this.makeWorker();
    worker.onmessage = ({ data }: MessageEvent<WorkerMessage>) => {
      if (worker === this.worker) this.receive(data);
    };
    worker.onerror = (event) => {
      if (worker === this.worker) this.restart(event.message);
    };
    const message: StartMessage = { wasm: await this.wasm };
    worker.postMessage(message);
    this.worker = worker;
    this.send();
  }

  private restart(reason: string): void {
    const failed = this.inFlight;
    this.worker?.terminate();
    this.worker = null;
    this.inFlight = null;
    const dropped = [...this.plans.values()];
    this.plans.clear();
    this.scene ??= failed === this.lastScene ? null : this.lastScene;
    failed?.done({ error: reason });
    for (const job of dropped) job.done({ error: reason });
    void this.start();
  }

  private send(): void {
    if (!this.worker || this.inFlight) return;
    const job = this.next();
    if (!job) return;
    this.inFlight = job;
    this.since = performance.now();
    const message: CallMessage = {
      request: JSON.stringify(job.request),
      ...(job.bytes && { bytes: job.bytes }),
    };
    this.worker.postMessage(message);
  }

  /** The scene goes first, because the others are about it. */
  private next(): Job | undefined {
    if (this.scene) {
      const job = this.scene;
      this.scene = null;
      return job;
    }
    const call = this.calls.shift();
    if (call) return call;
    const first = this.plans.entries().next();
    if (first.done) return undefined;
    this.plans.delete(first.value[0]);
    return first.value[1];
  }

  private receive(message: WorkerMessage): void {
    if ('stopped' in message) {
      this.restart(`The engine stopped: ${message.stopped}`);
      return;
    }
    const job = this.inFlight;
    this.inFlight = null;
    const reply: unknown = JSON.parse(message.reply);
    // The worker plans on while the page shows this reply.
    this.send();
    job?.done(reply, message.bytes);
  }
}

/** The reply, or an exception with the text of the error. */
export async function required<R extends Request>(
  replied: Promise<Replied<R>>,
): Promise<{ reply: ReplyTo<R>; bytes?: Uint8Array<ArrayBuffer> }> {
  const { reply, bytes } = await replied;
  if (isError(reply)) throw new Error(reply.error);
  return { reply: reply as ReplyTo<R>, ...(bytes && { bytes }) };
}
