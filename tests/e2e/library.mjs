// The Library page: outlines, import with faults, flight.

import assert from "node:assert/strict";
import { assertAccessible, pageTest } from "./harness.mjs";

const software = /software WebGL|GPU stall due to ReadPixels|GL Driver Message/;
const hash = "#/library/vehicles";
const facts = (page) => page.locator("table.facts").last();
const flown = (page) => page.locator("[data-flown=peak_deceleration_earth_g] .value");

/** Chooses a file in the import. */
const choose = (page, name, text) =>
  page.getByLabel("Import an outline (CSV or DXF)").setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });

const cone = "x (mm), r (mm)\n0, 0\n500, 500\n500, 0\n";

pageTest("outlines are listed with their sources and are flown", async (page) => {
  await page.getByRole("navigation", { name: "Pages" }).getByRole("link", { name: "Library" }).click();
  await page.getByRole("heading", { name: "Vehicles", level: 2 }).waitFor();
  assert.ok((await page.locator(".outline-list li").count()) >= 7);
  await page.getByRole("button", { name: /Stardust/ }).click();
  await page.locator("table.facts").first().getByText("0.8128 m", { exact: true }).waitFor();
  await page.getByText("assumed", { exact: true }).first().waitFor();
  await flown(page).waitFor();
  const light = await flown(page).innerText();
  await page.getByLabel("Mass (kg)").fill("200");
  await page.waitForFunction((before) => document.querySelector("[data-flown=peak_deceleration_earth_g] .value").textContent !== before, light);
  await page.getByLabel("Mass (kg)").fill("-3");
  await page.locator(".flight-form .field-error", { hasText: "must be" }).waitFor();
  await page.reload();
  await page.getByRole("heading", { name: /Stardust/, level: 2 }).waitFor();
}, { allowed: software });

pageTest("an outline is imported, kept, removed and brought back", async (page) => {
  await choose(page, "cone.csv", cone);
  await page.getByRole("heading", { name: "cone", level: 2 }).waitFor();
  // π/3 · 0.5² · 0.5 = 0.1309 m³
  await facts(page).getByText(/^0\.13090 m³$/).waitFor();
  await page.locator(".saved", { hasText: "saved in this browser" }).waitFor();
  await page.reload();
  await page.getByRole("button", { name: "cone", exact: true }).waitFor();
  await page.getByRole("button", { name: "Remove cone" }).click();
  await page.getByRole("button", { name: "cone", exact: true }).waitFor({ state: "detached" });
  await page.keyboard.press("ControlOrMeta+z");
  await page.getByRole("button", { name: "cone", exact: true }).waitFor();
}, { hash, allowed: software });

pageTest("faults of a file are shown at their place, and the last good outline stays", async (page) => {
  await choose(page, "cone.csv", cone);
  await page.getByRole("heading", { name: "cone", level: 2 }).waitFor();
  await choose(page, "bad.csv", "x (m), r (m)\n0, 0\n1, one\n2\n3, 0\n");
  const alert = page.getByRole("alert");
  await alert.getByRole("heading", { name: /^bad\.csv has \d+ faults$/ }).waitFor();
  assert.ok((await alert.getByText(/^line 3: /).count()) >= 1);
  assert.ok((await alert.getByText(/^line 4: /).count()) >= 1);
  assert.match(await alert.locator(".fault-lines").innerText(), /3\s+1, one/);
  await page.getByRole("heading", { name: "cone", level: 2 }).waitFor();

  await page.getByLabel("Or paste points (CSV)").fill("x (m), r (m)\n0, 0\n1, 1\n2, 0.2\n1, 0.2\n2, 1\n3, 0\n");
  await page.getByRole("button", { name: "Import pasted points" }).click();
  await alert.getByText(/segment \d.*crosses.*segment \d/i).first().waitFor();
  await choose(page, "axis.csv", "x (m), r (m)\n0, 0\n1, 1\n2, -1\n3, 0\n");
  await alert.getByText(/axis/).first().waitFor();
  assert.equal(await page.locator(".outline-list").getByRole("button", { name: "cone", exact: true }).getAttribute("aria-pressed"), "true");
}, { hash, allowed: software });

pageTest("a drawing is imported", async (page) => {
  const line = (x0, y0, x1, y1) => `0\nLINE\n8\n0\n10\n${x0}\n20\n${y0}\n11\n${x1}\n21\n${y1}\n`;
  const dxf = `0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n${line(0, 0, 500, 500)}${line(500, 500, 500, 0)}0\nENDSEC\n0\nEOF\n`;
  await choose(page, "cone.dxf", dxf);
  await page.getByRole("heading", { name: "cone", level: 2 }).waitFor();
  await facts(page).getByText(/^0\.13090 m³$/).waitFor();
}, { hash, allowed: software });

for (const colorScheme of ["light", "dark"]) {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 360, height: 740 }]) {
    pageTest(`the library is accessible in ${colorScheme} at ${viewport.width} px`, async (page) => {
      await flown(page).waitFor();
      await choose(page, "bad.csv", "x (m), r (m)\n0, 0\n1, one\n3, 0\n");
      await page.getByRole("alert").getByText(/line 3/).first().waitFor();
      await assertAccessible(page);
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.equal(overflow, 0, "nothing is wider than the screen");
    }, { hash, context: { colorScheme, viewport }, allowed: software });
  }
}
