// Starts the app. A file and not an inline script, so that the page's policy needs no exception;
// the names of the files stand in the page, because the build decides them.
const { js, wasm } = document.getElementById("app-files").dataset;

try {
  const { default: init } = await import(new URL(js, document.baseURI));
  await init({ module_or_path: new URL(wasm, document.baseURI) });
} catch (error) {
  const status = document.querySelector("#skeleton [role=status]");
  if (status) {
    status.textContent = `M-SAPE could not start: ${error}. It needs a browser of 2023 or later with WebAssembly.`;
  }
  throw error;
}
