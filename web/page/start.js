// Starts the app. A file and not an inline script, so that the page's policy needs no exception.
try {
  const { default: init } = await import("./app.js");
  await init({ module_or_path: new URL("./app_bg.wasm", import.meta.url) });
} catch (error) {
  const status = document.querySelector("#skeleton [role=status]");
  if (status) {
    status.textContent = `M-SAPE could not start: ${error}. It needs a browser of 2023 or later with WebAssembly.`;
  }
  throw error;
}
