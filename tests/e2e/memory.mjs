// Edits and changes of page leave nothing behind: as many elements and listeners after many of them as after a few, and no
// more memory.

import assert from "node:assert/strict";
import { pageTest } from "./harness.mjs";

/** Elements, listeners and bytes of the page after garbage is collected. */
async function held(page, session) {
  await page.waitForTimeout(500);
  // twice, because what finalizers free is collected the second time
  await session.send("HeapProfiler.collectGarbage");
  await page.waitForTimeout(200);
  await session.send("HeapProfiler.collectGarbage");
  const { metrics } = await session.send("Performance.getMetrics");
  const metric = (name) => metrics.find((metric) => metric.name === name).value;
  return { nodes: metric("Nodes"), listeners: metric("JSEventListeners"), bytes: metric("JSHeapUsedSize") };
}

/** Fails if `after` holds more than `before`: a hundredth of the elements and listeners, and 1 MB, are assumed to be noise. */
function assertNoMore(before, after) {
  const told = JSON.stringify({ before, after });
  assert.ok(after.nodes <= before.nodes * 1.01, told);
  assert.ok(after.listeners <= before.listeners * 1.01, told);
  assert.ok(after.bytes <= before.bytes + 1e6, told);
}

/** Measures after few and after many repetitions. */
async function repeat(page, few, many, step) {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  for (let count = 0; count < few; count += 1) {
    await step(count);
  }
  const before = await held(page, session);
  for (let count = 0; count < many; count += 1) {
    await step(count);
  }
  const after = await held(page, session);
  if (process.env.MSAPE_PRINT) {
    console.log(JSON.stringify({ before, after }));
  }
  assertNoMore(before, after);
}

const many = Number(process.env.MSAPE_MANY ?? 1);

pageTest("edits leave nothing behind", async (page) => {
  await page.locator(".headline .freshness", { hasText: "up to date" }).waitFor();
  await page.getByLabel("Input Vehicle Diameter (m)", { exact: true }).focus();
  // up and down in turn, more than the undo stack holds
  await repeat(page, 150, 250 * many, async (count) => {
    await page.keyboard.press(count % 2 === 0 ? "ArrowUp" : "ArrowDown");
  });
});

for (const [name, place] of [
  ["Library", "#/library/vehicles"],
  ["Aerodynamics", "#/library/aerodynamics"],
  ["Benchmark", "#/benchmark"],
]) {
  pageTest(`the page ${name}, opened and left again, leaves nothing behind`, async (page) => {
    await page.locator(".headline .freshness", { hasText: "up to date" }).waitFor();
    await repeat(page, 5, 25 * many, async () => {
      await page.evaluate((place) => (location.hash = place), place);
      await page.locator(".headline").waitFor({ state: "detached" });
      await page.evaluate(() => (location.hash = "#/design"));
      await page.locator(".headline").waitFor();
    });
  }, { allowed: /software WebGL|GPU stall due to ReadPixels|GL Driver Message/ });
}
