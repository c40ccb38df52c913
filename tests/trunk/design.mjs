// The app as Trunk builds it opens on the design that the command line gives. `cargo xtask test trunk` builds and serves
// it and sets MSAPE_URL and CHROMIUM.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { pageTest } from "../e2e/harness.mjs";

// built before the test, because a test is limited to two minutes
execFileSync("cargo", ["build", "--quiet", "--package", "msape-cli"], { stdio: "inherit", timeout: 1_200_000 });

async function downloaded(page, name) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name, exact: true }).click()]);
  return readFile(await download.path(), "utf8");
}

pageTest("the page that Trunk builds is solved, and its results are those of the command line", async (page) => {
  await page.locator(".headline .freshness", { hasText: "up to date" }).waitFor();
  const inputs = await downloaded(page, "Inputs (TOML)");
  const results = await downloaded(page, "Results (CSV, SI)");
  const words = ["run", "--quiet", "--package", "msape-cli", "--", "design", "-", "--csv-si"];
  const expected = execFileSync("cargo", words, { input: inputs, encoding: "utf8", stdio: ["pipe", "pipe", "inherit"], timeout: 60_000 });
  assert.equal(results, expected);
});
