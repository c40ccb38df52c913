// Starts the toolbox, as worker-start.js starts the solver. When it listens it posts "ready".
import init from "./tools.js";

await init({ module_or_path: new URL("./tools_bg.wasm", import.meta.url) });
