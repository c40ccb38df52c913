// The benchmark page measures every job. The times themselves are not tested.

import assert from "node:assert/strict";
import { assertAccessible, pageTest } from "./harness.mjs";

const progress = (page) => page.locator("main [role=status]");

pageTest(
  "every job of the benchmark gets a ratio to the first",
  async (page) => {
    await page.getByRole("heading", { name: "Benchmark", level: 2 }).waitFor();
    await progress(page).getByText(/^Done/).waitFor({ timeout: 60_000 });
    const ratios = (await page.locator("td.ratio").allInnerTexts()).map(Number);
    assert.ok(ratios.length >= 5, `${ratios.length} rows`);
    assert.deepEqual(ratios.filter((ratio) => !(Number.isFinite(ratio) && ratio > 0)), []);
    assert.equal(ratios[0], 1, "the first is the reference");
    await page.locator("dd").getByText(/^\d+ ms$/).waitFor();
    await assertAccessible(page);
  },
  { hash: "#/benchmark" },
);

pageTest("the benchmark is reached from the design, can be stopped, and leads back", async (page) => {
  await page.getByRole("link", { name: "Benchmark" }).click();
  await progress(page).getByText(/^Measuring/).waitFor();
  await page.getByRole("button", { name: "Cancel" }).click();
  await progress(page).getByText("Cancelled.").waitFor();
  await page.getByRole("button", { name: "Run again" }).click();
  await progress(page).getByText(/^Measuring [2-9]/).waitFor();
  await page.getByRole("link", { name: "Back to the design" }).click();
  await page.locator(".headline .freshness", { hasText: "up to date" }).waitFor();
});

for (const colorScheme of ["light", "dark"]) {
  pageTest(
    `the benchmark page fits 360 px and is accessible in ${colorScheme}`,
    async (page) => {
      await progress(page).getByText(/^Measuring [2-9]/).waitFor();
      await page.getByRole("button", { name: "Cancel" }).click();
      await progress(page).getByText("Cancelled.").waitFor();
      await assertAccessible(page);
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.equal(overflow, 0, "nothing is wider than the screen");
    },
    { hash: "#/benchmark", context: { colorScheme, viewport: { width: 360, height: 740 } } },
  );
}
