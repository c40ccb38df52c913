// Starts the worker: `new Worker(<this file>, { type: "module" })`. The worker posts "ready" when it listens.
import init from "./worker.js";

await init({ module_or_path: new URL("./worker_bg.wasm", import.meta.url) });
