// Attitude of the design: six degrees of freedom, charts, and the animated vehicle.

import assert from "node:assert/strict";
import { assertAccessible, pageTest } from "./harness.mjs";

const software = /software WebGL|GPU stall due to ReadPixels|GL Driver Message/;
const fresh = async (page) => {
  await page.locator(".headline .freshness", { hasText: "up to date" }).waitFor();
  await page.locator('[data-output="total_entry_mass_kg"] .value', { hasText: /\d/ }).waitFor();
};
const card = (page) => page.getByRole("region", { name: "Attitude", exact: true });
const rigid = (page) => card(page).getByRole("radio", { name: "6: rigid body" });
const time = (page) => card(page).getByRole("slider", { name: "Time of the flight" });
const value = (page, key) => page.locator(`[data-attitude="${key}"] .value`);
const alpha = (page) => card(page).getByRole("textbox", { name: "Angle of Attack (deg)" });
const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

async function fly(page) {
  await fresh(page);
  await rigid(page).check();
  await value(page, "initial_total_alpha_deg").waitFor();
}

/** Hash of the picture of the vehicle. */
async function picture(page) {
  await settled(page);
  const png = (await card(page).locator(".frame-3d canvas").screenshot()).toString("base64");
  return page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    return data.reduce((sum, byte) => (sum * 31 + byte) % 1_000_003, 0);
  }, png);
}

pageTest("a design flies as a rigid body from the attitude that is typed", async (page) => {
  await fly(page);
  // along the velocity, except for rounding
  const along = (await value(page, "initial_total_alpha_deg").innerText()).replace("\u2212", "-");
  assert.ok(Math.abs(Number(along)) < 1e-9, along);
  await alpha(page).fill("30");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => Number(document.querySelector('[data-attitude="initial_total_alpha_deg"] .value')?.textContent) === 30);
  const below = Number(await value(page, "first_below_10_deg_time_s").innerText());
  assert.ok(below > 0 && below < 60, `it turns into the wind after ${below} s`);
  // typed values have the limits of the input
  await alpha(page).fill("500");
  await page.keyboard.press("Tab");
  await card(page).getByText(/must be/).first().waitFor();
  await page.keyboard.press("ControlOrMeta+z");
  await page.waitForFunction(() => document.querySelector("#in-attitude-alpha_deg").value === "30");
  await card(page).getByRole("radio", { name: "3: point mass" }).check();
  await value(page, "initial_total_alpha_deg").waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Undo: Degrees of freedom" }).click();
  await value(page, "initial_total_alpha_deg").waitFor();
}, { allowed: software });

pageTest("vehicle and charts share one time, by slider, keyboard, chart and play", async (page) => {
  await fly(page);
  await alpha(page).fill("30");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => Number(document.querySelector('[data-attitude="initial_total_alpha_deg"] .value')?.textContent) === 30);
  const at = async () => Number(await time(page).inputValue());
  assert.equal(await at(), 0, "nothing runs by itself");
  await time(page).fill("0");
  const first = await picture(page);
  await time(page).fill("12");
  assert.notEqual(await picture(page), first, "another attitude, another picture");
  assert.ok((await page.locator(".chart-cursor circle").count()) >= 6, "charts of the attitude and of the design show the time");
  await time(page).focus();
  const before = await at();
  await page.keyboard.press("ArrowRight");
  assert.ok((await at()) > before, "an arrow key moves it");
  await card(page).getByRole("button", { name: "Back by a second" }).click();
  assert.ok(Math.abs((await at()) - (before - 0.95)) < 0.06);

  const chart = card(page).getByRole("application", { name: /^Total Angle of Attack over time/ });
  await chart.focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("Shift+ArrowRight");
  const by_chart = await at();
  assert.ok(by_chart > 5 && by_chart < 60, `the cursor of the chart moves the time: ${by_chart} s`);

  await card(page).getByRole("button", { name: "Play" }).click();
  await page.waitForFunction((t) => Number(document.querySelector('.player input[type="range"]').value) > t + 0.5, by_chart);
  await card(page).getByRole("button", { name: "Pause" }).click();
  const paused = await at();
  await settled(page);
  assert.equal(await at(), paused, "it stands");
}, { allowed: software });

pageTest("total angle of attack over the Knudsen number has a table", async (page) => {
  await fly(page);
  await card(page).getByRole("button", { name: "Table of Total Angle of Attack over Knudsen number" }).click();
  await card(page).locator(".chart-table tbody tr").first().waitFor();
  assert.equal(await card(page).locator(".chart-table th").first().innerText(), "Knudsen Number");
}, { allowed: software });

for (const colorScheme of ["light", "dark"]) {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 360, height: 740 }]) {
    pageTest(`the attitude is accessible in ${colorScheme} at ${viewport.width} px`, async (page) => {
      await fly(page);
      await time(page).fill("10");
      await assertAccessible(page);
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.equal(overflow, 0, "nothing is wider than the screen");
    }, { context: { colorScheme, viewport, reducedMotion: "reduce" }, allowed: software });
  }
}
