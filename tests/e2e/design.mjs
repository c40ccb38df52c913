// Main workflow on the Design page, by keyboard, compared with the files of the command line.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { assertAccessible, pageTest } from "./harness.mjs";

const fresh = async (page) => {
  await page.locator(".headline .freshness", { hasText: "up to date" }).waitFor();
  await page.locator('[data-output="total_entry_mass_kg"] .value', { hasText: /\d/ }).waitFor();
};
const value = async (page, key) => Number((await page.locator(`[data-output="${key}"] .value`).innerText()).replace("\u2212", "-"));
const mass = (page) => value(page, "total_entry_mass_kg");
const drawing = (page) => page.getByRole("img", { name: /^Section of the vehicle/ });
const diameter = (page) => page.getByLabel("Input Vehicle Diameter (m)", { exact: true });

/** Waits until a headline number differs from `before`. */
async function changed(page, key, before) {
  await page.waitForFunction(
    ([key, before]) => document.querySelector(`[data-output="${key}"] .value`)?.textContent !== before,
    [key, before],
  );
  await fresh(page);
}

async function downloaded(page, name) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name, exact: true }).click()]);
  return { name: download.suggestedFilename(), text: await readFile(await download.path(), "utf8") };
}

// built before the first test, because a test is limited to two minutes
const cargo = (words, options) => execFileSync("cargo", words, { stdio: ["pipe", "pipe", "inherit"], ...options });
cargo(["build", "--quiet", "--package", "msape-cli"], { timeout: 1_200_000 });

/** Output of the command line for a case given as text. */
function command(words, input) {
  const run = ["run", "--quiet", "--package", "msape-cli", "--", ...words];
  return cargo(run, { input, encoding: "utf8", maxBuffer: 1e8, timeout: 60_000 });
}

pageTest("mass and drawing follow the diameter, typed and stepped by keyboard", async (page) => {
  await fresh(page);
  const [mass_before, drawing_before] = [await mass(page), await drawing(page).getAttribute("aria-label")];
  const text_before = await page.locator('[data-output="total_entry_mass_kg"] .value').innerText();
  await diameter(page).focus();
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.type("1.3 m");
  await page.keyboard.press("Enter");
  await page.locator('[aria-label*="diameter 1.30 m"]').waitFor();
  await changed(page, "total_entry_mass_kg", text_before);
  const mass_after = await mass(page);
  assert.ok(mass_after > mass_before, `a larger vehicle is heavier: ${mass_before} kg, then ${mass_after} kg`);
  assert.notEqual(await drawing(page).getAttribute("aria-label"), drawing_before);
  assert.match(await drawing(page).getAttribute("aria-label"), /diameter 1\.30? m/);

  const text_stepped = await page.locator('[data-output="total_entry_mass_kg"] .value').innerText();
  await page.keyboard.press("Shift+ArrowUp");
  await changed(page, "total_entry_mass_kg", text_stepped);
  assert.equal(await diameter(page).inputValue(), "1.4");

  const is = (text) => page.waitForFunction((text) => document.querySelector("#in-design-diameter_m").value === text, text);
  await page.keyboard.press("ControlOrMeta+z");
  await is("1.3");
  await page.keyboard.press("ControlOrMeta+z");
  await is("0.9");
  await page.keyboard.press("ControlOrMeta+Shift+z");
  await page.keyboard.press("ControlOrMeta+y");
  await is("1.4");
});

pageTest("a heat shield beyond its limit is a note that leads to its field; undo takes it back", async (page) => {
  await fresh(page);
  await page.getByLabel("Entry Velocity (m/s)", { exact: true }).fill("13 km/s");
  await page.keyboard.press("Enter");
  const shield = page.getByLabel("Forebody TPS Concept", { exact: true });
  await shield.selectOption("cp-acc6");
  await fresh(page);
  await shield.selectOption("pica-al-5056");
  await fresh(page);
  const notes = page.getByRole("region", { name: "Notes" });
  await notes.getByRole("heading", { name: /Limits exceeded/ }).waitFor();
  await notes.getByText(/PICA/i).first().waitFor();
  await notes.getByRole("button", { name: "Go to Forebody TPS Concept" }).first().click();
  await page.waitForFunction(() => document.activeElement?.id === "in-design-forebody_tps");
  await page.getByRole("button", { name: "Undo: Forebody TPS Concept" }).click();
  assert.equal(await shield.inputValue(), "cp-acc6");
});

pageTest("a faulty input keeps its text, says what is allowed and loses no result", async (page) => {
  await fresh(page);
  const mass_before = await mass(page);
  await diameter(page).fill("-1");
  await page.locator(".headline .freshness", { hasText: "input at fault" }).waitFor();
  await page.locator("#in-design-diameter_m-fault", { hasText: "must be above 0 m and at most 20 m" }).waitFor();
  assert.equal(await diameter(page).getAttribute("aria-invalid"), "true");
  assert.equal(await mass(page), mass_before);
  await diameter(page).fill("two");
  await page.keyboard.press("Tab");
  assert.equal(await diameter(page).inputValue(), "two");
  await diameter(page).fill("0,95");
  await fresh(page);
});

pageTest("a named run is found after a reload, and its files are those of the command line", async (page) => {
  await fresh(page);
  await diameter(page).fill("1.1");
  await page.keyboard.press("Enter");
  await page.getByLabel("Run Name", { exact: true }).fill("Wider");
  await page.getByRole("button", { name: "Save run" }).click();
  await page.getByRole("button", { name: "Open Wider" }).waitFor();
  await diameter(page).fill("0.95");
  await page.keyboard.press("Enter");
  await page.locator(".saved", { hasText: "saved in this browser" }).waitFor();

  await page.reload();
  await page.locator("#skeleton").waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Open Wider" }).waitFor();
  assert.equal(await diameter(page).inputValue(), "0.95", "the last edit is kept as well");
  await page.getByRole("button", { name: "Open Wider" }).click();
  await page.waitForFunction(() => document.querySelector("#in-design-diameter_m").value === "1.1");
  await fresh(page);

  const inputs = await downloaded(page, "Inputs (TOML)");
  assert.equal(inputs.name, "wider.toml");
  const results = await downloaded(page, "Export Results to CSV");
  assert.equal(results.text, command(["design", "-", "--csv"], inputs.text));
  const trajectory = await downloaded(page, "Trajectory (CSV)");
  assert.equal(trajectory.text, command(["design", "-", "--csv-si", "--trajectory"], inputs.text));

  await page.getByRole("button", { name: "Delete Wider" }).click();
  await page.getByText("No run is saved yet").waitFor();
  await page.keyboard.press("ControlOrMeta+z");
  await page.getByRole("button", { name: "Open Wider" }).waitFor();
});

pageTest("a case that is pasted is opened, and a broken one changes nothing", async (page) => {
  await fresh(page);
  await page.getByLabel("Or paste a case").fill('schema = "msape/1"\nname = ');
  await page.getByRole("button", { name: "Open pasted case" }).click();
  await page.getByRole("alert").getByText(/line 2/).waitFor();
  assert.equal(await diameter(page).inputValue(), "0.9");
  const { text } = await downloaded(page, "Inputs (JSON)");
  await page.getByLabel("Or paste a case").fill(text.replace('"diameter_m": 0.9', '"diameter_m": 1.05'));
  await page.getByRole("button", { name: "Open pasted case" }).click();
  await page.waitForFunction(() => document.querySelector("#in-design-diameter_m").value === "1.05");
  await fresh(page);
});

pageTest(
  "a link restores its case, and what is malformed in it is left out",
  async (page) => {
    assert.equal(await diameter(page).inputValue(), "1.2");
    assert.equal(await page.getByLabel("Name of the case").inputValue(), "From a link");
    await fresh(page);
  },
  { hash: "#/design?p=run-page&n=From%20a%20link&design.diameter_m=1.2&nonsense=1&%zz" },
);

pageTest("the charts share a cursor that keys move and that is read out", async (page) => {
  await fresh(page);
  const chart = page.getByRole("application", { name: /^Geodetic Altitude over time/ });
  await chart.focus();
  await page.keyboard.press("Home");
  for (let i = 0; i < 5; i += 1) {
    await page.keyboard.press("ArrowRight");
  }
  await page.locator(".reading[aria-live=polite]", { hasText: /Time .* Geodetic Altitude .*km/ }).waitFor();
  assert.ok((await page.locator(".chart-cursor circle").count()) >= 4, "every chart shows the cursor");
  await page.getByRole("button", { name: /^Table of Geodetic Altitude over time/ }).click();
  assert.equal(await page.locator(".chart-table tbody tr").count(), 25);
});

for (const colorScheme of ["light", "dark"]) {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 360, height: 740 }]) {
    pageTest(
      `everything open is accessible in ${colorScheme} at ${viewport.width} px`,
      async (page) => {
        await fresh(page);
        await page.locator("label", { hasText: /^Expert$/ }).click();
        await page.getByRole("button", { name: "Help: Entry Velocity" }).click();
        await diameter(page).fill("-1");
        await page.getByRole("button", { name: /to .*values?$/ }).first().click();
        await page.getByRole("button", { name: /^Table of Geodetic Altitude over time/ }).click();
        await page.locator(".headline .freshness", { hasText: "input at fault" }).waitFor();
        await diameter(page).fill("0.9");
        await fresh(page);
        await assertAccessible(page);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.equal(overflow, 0, "nothing is wider than the screen");
      },
      { context: { colorScheme, viewport } },
    );
  }
}
