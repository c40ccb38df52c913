// Files of the export menu, equal byte for byte to those of the command line.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pageTest } from "./harness.mjs";

const cargo = (words, options) => execFileSync("cargo", words, { stdio: ["pipe", "pipe", "inherit"], ...options });
cargo(["build", "--quiet", "--package", "msape-cli"], { timeout: 1_200_000 });

/** Standard output of the command line for a case given as text. */
function printed(text, words) {
  return cargo(["run", "--quiet", "--package", "msape-cli", "--", ...words], { input: text, timeout: 60_000 });
}

/** File written by the command line for a case given as text. */
function exported(text, format) {
  const folder = mkdtempSync(join(tmpdir(), "msape-"));
  try {
    const [input, output] = [join(folder, "case.toml"), join(folder, `vehicle.${format}`)];
    writeFileSync(input, text);
    cargo(["run", "--quiet", "--package", "msape-cli", "--", "export", input, "--format", format === "glb" ? "gltf" : format, "-o", output], {
      timeout: 60_000,
    });
    return readFileSync(output);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

async function downloaded(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

/** Compares every file of the menu with that of the command line for `text`. */
async function compare(page, text) {
  const menu = page.locator("details.menu");
  await menu.locator("summary").click();
  const buttons = menu.getByRole("button");
  const count = await buttons.count();
  assert.ok(count >= 7, `${count} formats`);
  for (let i = 0; i < count; i += 1) {
    const format = (await buttons.nth(i).innerText()).toLowerCase();
    const file = await downloaded(page, buttons.nth(i));
    assert.ok(file.name.endsWith(`.${format}`), file.name);
    assert.ok(file.bytes.equals(exported(text, format)), `${format}: the same bytes`);
  }
}

pageTest("the files of a vehicle are those of the command line", async (page) => {
  await page.locator(".headline .freshness", { hasText: "up to date" }).waitFor();
  const inputs = await downloaded(page, page.getByRole("button", { name: "Inputs (TOML)", exact: true }));
  const text = inputs.bytes.toString("utf8");
  await compare(page, text);
  await page.getByRole("tab", { name: "Mass tree" }).click();
  const tree = await downloaded(page, page.getByRole("button", { name: "CSV of the mass tree" }));
  assert.ok(tree.bytes.equals(printed(text, ["design", "-", "--mass-tree"])), "the same mass tree");
});

pageTest(
  "the files of an outline are those of the command line",
  async (page) => {
    await page.locator("[data-flown]").first().waitFor();
    const text = await downloaded(page, page.getByRole("button", { name: "Case file (TOML)", exact: true }));
    await compare(page, text.bytes.toString("utf8"));
  },
  { hash: "#/library/vehicles?o=stardust", allowed: /software WebGL|GL Driver Message/ },
);
