// The tabs of structure and landing, by keyboard.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { assertAccessible, pageTest } from "./harness.mjs";

/** Messages logged while the arrow keys pass the tab of the 3-D view. */
const software = /software WebGL|GPU stall due to ReadPixels|GL Driver Message/;

const fresh = async (page) => {
  await page.locator(".headline .freshness", { hasText: "up to date" }).waitFor();
  await page.locator('[data-output="total_entry_mass_kg"] .value', { hasText: /\d/ }).waitFor();
};
const region = (page, name) => page.getByRole("region", { name, exact: true });
const level = (page, key) => page.locator(`[data-level="${key}"] .value`);
const numberOf = async (locator) => Number((await locator.innerText()).replace("−", "-").split(" ")[0]);

/** Opens a tab with the keyboard: the row of tabs is one tab stop, arrow keys move along it. */
async function open(page, name) {
  await fresh(page);
  await page.locator('.panel-vehicle [role="tab"][tabindex="0"]').focus();
  for (let i = 0; i < 8; i += 1) {
    if ((await page.evaluate(() => document.activeElement.textContent)) === name) break;
    await page.keyboard.press("ArrowRight");
  }
  await page.getByRole("tabpanel", { name, exact: true }).waitFor();
  assert.equal(await page.evaluate(() => document.activeElement.textContent), name);
}

/** Fills in a field of the form and waits for the answer. */
async function type(page, label, text) {
  await page.getByRole("textbox", { name: label, exact: true }).fill(text);
  await page.keyboard.press("Tab");
}

pageTest("each wall has its rules and its shell model, by keyboard", async (page) => {
  await open(page, "Structure");
  const walls = region(page, "Walls").locator("tbody tr");
  assert.equal(await walls.count(), 3);
  for (const row of await walls.all()) {
    assert.ok((await numberOf(row.locator("td .value").first())) > 0, "a thickness");
    assert.ok((await row.locator("td").nth(1).innerText()).length > 3, "what sized it");
  }
  await page.locator(".panel-vehicle .mark", { hasText: "assumed" }).waitFor();

  // the margin is capacity over demand minus one; the smallest, except that of the gauge, is marked
  const checks = region(page, "Checks of the forebody carrier").locator("tbody tr");
  const rows = await checks.evaluateAll((rows) => rows.map((row) => [row.cells[0].textContent, ...[2, 3, 5].map((i) => Number(row.cells[i].textContent.replaceAll("−", "-"))), row.classList.contains("least")]));
  assert.ok(rows.length >= 7, `${rows.length} checks`);
  for (const [name, demand, capacity, margin] of rows) {
    const expected = capacity / demand - 1;
    assert.ok(Math.abs(margin - expected) < 0.01 + 0.06 * Math.abs(expected), `${name}: ${margin} of ${expected}`);
  }
  const marked = rows.filter((row) => row[4]);
  assert.equal(marked.length, 1);
  assert.equal(marked[0][3], Math.min(...rows.filter((row) => !row[0].startsWith("minimum gauge")).map((row) => row[3])));

  const title = page.getByRole("heading", { name: "Stress of the forebody carrier" });
  await title.waitFor();
  await page.getByRole("radio", { name: "Forebody carrier" }).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.getByRole("heading", { name: "Stress of the primary structure" }).waitFor();
  await region(page, "Checks of the primary structure").getByText("buckling of the cylinder").first().waitFor();
  // entry and four corners of the launch loads
  assert.equal(await region(page, "Checks of the primary structure").locator("tbody tr", { hasText: "buckling of the cylinder" }).count(), 5);

  const chart = page.getByRole("application", { name: /^Stress of the primary structure/ });
  await chart.focus();
  await page.keyboard.press("Home");
  await page.locator(".panel-vehicle .reading", { hasText: /Distance from the nose .*entry .*MPa; launch .*MPa/ }).waitFor();
  assert.equal(await page.locator(".frequencies tbody tr").count(), 5);
  assert.equal(await page.locator(".frequencies tr.least").count(), 1);
}, { allowed: software });

pageTest("the peak of the table is on the curve's table twin, and the curve is a file", async (page) => {
  await open(page, "Structure");
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "CSV of Stress of the forebody carrier" }).click()]);
  const lines = (await readFile(await download.path(), "utf8")).trim().split("\n");
  assert.match(lines[0], /Distance from the axis \(mm\)/);
  const entry = lines.slice(1).map((line) => Number(line.split(",")[1]));
  const parts = region(page, "Stress by part").locator("tbody tr", { hasText: "entry" });
  const peaks = await parts.evaluateAll((rows) => rows.map((row) => Number(row.cells[2].textContent)));
  const ratio = Math.max(...entry) / Math.max(...peaks);
  assert.ok(ratio > 0.5 && ratio < 1.001, `${ratio} of the peak at the Gauss points`);
}, { allowed: software });

pageTest("a heavier payload asks more of the walls, live", async (page) => {
  await open(page, "Structure");
  const row = region(page, "Stress by part").locator("tbody tr", { hasText: "entry" }).first();
  const before = await numberOf(row.locator("td").nth(1));
  await type(page, "Payload Mass (kg)", "20");
  await page.waitForFunction((before) => {
    const cell = document.querySelector('[aria-label="Stress by part"] tbody tr td:nth-of-type(2)');
    return Number(cell.textContent) > 1.05 * before;
  }, before);
}, { allowed: software });

pageTest("equations and dynamics of the landing stand side by side", async (page) => {
  await open(page, "Landing");
  const [limit, peak] = [await numberOf(level(page, "crush_load_limit_earth_g")), await numberOf(level(page, "rigid_surface_peak_load_earth_g"))];
  assert.ok(limit > 0 && peak > 0);
  const row = region(page, "Equations and dynamics").locator("tbody tr", { has: page.locator('[data-level="crush_load_limit_earth_g"]') });
  const ratio = Number(await row.locator("td").last().innerText());
  assert.ok(Math.abs(ratio - peak / limit) < 0.006, `${ratio} is ${peak} over ${limit}`);
  const strokes = region(page, "Stroke in the impact foam").locator("tbody tr");
  assert.equal(await strokes.count(), 3);
  const stroke = await numberOf(strokes.nth(1).locator("td").first());
  assert.ok(Math.abs(stroke / (10 * (await numberOf(level(page, "rigid_surface_stroke_m")))) - 1) < 0.01, "one stroke in both tables");
  assert.equal(await page.locator(".panel-vehicle .chart-panel").count(), 3);
  const chart = page.getByRole("application", { name: /^Payload deceleration over time: rigid surface/ });
  await chart.focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("Shift+ArrowRight");
  await page.locator(".panel-vehicle .reading", { hasText: /Time .*ms: dynamics .*Earth g/ }).waitFor();
}, { allowed: software });

pageTest("another ground is chosen by keyboard, told with its source, and can be taken back", async (page) => {
  await open(page, "Landing");
  const ground = page.locator(".panel-vehicle .ground");
  await ground.getByText(/α of equation 1: 28, range 27 to 29/).waitFor();
  const before = await level(page, "peak_impact_deceleration_earth_g").innerText();
  await ground.getByLabel("Ground").focus();
  await page.keyboard.type("Rigid");
  // on rigid ground both surfaces are the same
  await page.waitForFunction(() => {
    const text = (key) => document.querySelector(`[data-level="${key}"] .value`)?.textContent;
    return text("peak_impact_deceleration_earth_g") === text("rigid_surface_peak_load_earth_g");
  });
  await ground.getByText(/No penetration/).waitFor();
  await page.getByRole("button", { name: "Undo: Ground" }).click();
  await page.waitForFunction((before) => document.querySelector('[data-level="peak_impact_deceleration_earth_g"] .value')?.textContent === before, before);
}, { allowed: software });

pageTest(
  "foam that is too weak stiffens, and the tab says so",
  async (page) => {
    await open(page, "Landing");
    await region(page, "Stroke in the impact foam").locator("tbody tr", { hasText: "stiffens" }).first().waitFor();
    await page.locator("#panel-landing .notes li.note-outside").first().waitFor();
    await page.locator("#panel-landing .solver").getByRole("button", { name: "Go to Stroke Efficiency" }).first().focus();
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => document.activeElement?.id === "in-design-stroke_efficiency");
  },
  { allowed: software, hash: "#/design?v=0.2&p=msr-eev-pica&design.density_kg_m3.impact_foam=60" },
);

pageTest("a vehicle that does not close leaves the last one's structure and landing in view", async (page) => {
  await open(page, "Structure");
  await type(page, "Payload Diameter / Vehicle Diameter", "0.95");
  await page.locator(".panel-vehicle .reason", { hasText: "This is the last vehicle that closed" }).waitFor();
  assert.equal(await region(page, "Walls").locator("tbody tr").count(), 3);
  await page.getByRole("tab", { name: "Landing", exact: true }).click();
  assert.ok((await numberOf(level(page, "rigid_surface_peak_load_earth_g"))) > 0);
}, { allowed: software, hash: "#/design?p=run-page" });

for (const colorScheme of ["light", "dark"]) {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 360, height: 740 }]) {
    pageTest(`structure and landing are accessible in ${colorScheme} at ${viewport.width} px`, async (page) => {
      for (const name of ["Structure", "Landing"]) {
        await open(page, name);
        await assertAccessible(page);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.equal(overflow, 0, `${name}: nothing is wider than the screen`);
      }
    }, { context: { colorScheme, viewport }, allowed: software });
  }
}
