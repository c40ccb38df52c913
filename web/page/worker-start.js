// Starts the solver: `new Worker(<this file>, { type: "module" })`. When it listens it posts, as bytes, what a case may name.
import init from "./worker.js";

await init({ module_or_path: new URL("./worker_bg.wasm", import.meta.url) });
