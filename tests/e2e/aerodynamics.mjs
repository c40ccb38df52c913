// The Aerodynamics page of the Library: curves, their sources, trim, user tables, use in a design and in a flight.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { assertAccessible, pageTest } from "./harness.mjs";

const software = /software WebGL|GPU stall due to ReadPixels|GL Driver Message/;
const hash = "#/library/aerodynamics";
const ready = (page) => page.locator(".origins li").first().waitFor();
const field = (page, name) => page.getByRole("textbox", { name });
const figure = (page, title) => page.locator("figure", { has: page.getByRole("heading", { name: title, exact: true }) });

async function downloaded(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return { name: download.suggestedFilename(), text: await readFile(await download.path(), "utf8") };
}

const choose = (page, name, text) =>
  page.getByLabel("Import a table (CSV)").setInputFiles({ name, mimeType: "text/csv", buffer: Buffer.from(text) });

const table = ["mach, alpha_deg, ca, cn, cm", ...[0.5, 5, 30].flatMap((mach) => [0, 30, 90].map((alpha) =>
  `${mach}, ${alpha}, ${1.5 - alpha / 100}, ${alpha / 200}, ${-alpha / 300}`))].join("\n");

// built before the first test, because a test is limited to two minutes
const cargo = (words, options) => execFileSync("cargo", words, { stdio: ["pipe", "pipe", "inherit"], ...options });
cargo(["build", "--quiet", "--package", "msape-cli"], { timeout: 1_200_000 });

pageTest("curves are the command line's numbers", async (page) => {
  await page.getByRole("navigation", { name: "Pages" }).getByRole("link", { name: "Library" }).click();
  await page.getByRole("navigation", { name: "Library" }).getByRole("link", { name: "Aerodynamics" }).click();
  await page.getByRole("heading", { name: "Aerodynamics", level: 2 }).waitFor();
  await page.getByRole("button", { name: /Stardust/ }).click();
  await page.getByRole("heading", { name: /Stardust/, level: 2 }).waitFor();
  await field(page, "Mach numbers").fill("20, 0.3");
  await ready(page);
  const normal = figure(page, "Normal Force Coefficient CN over angle of attack");
  await normal.getByText("Mach 0.3", { exact: false }).first().waitFor();
  const { text } = await downloaded(page, normal.getByRole("button", { name: /^CSV of/ }));
  const [header, ...rows] = text.trim().split("\n").map((line) => line.split(","));
  assert.deepEqual(header, ["Angle of Attack (deg)", "Mach 20", "Mach 0.3"]);
  assert.equal(rows.length, 181);
  const file = await downloaded(page, page.getByRole("button", { name: "Case file (TOML)" }));
  for (const [column, mach] of [[1, "20"], [2, "0.3"]]) {
    const words = ["run", "--quiet", "--package", "msape-cli", "--", "aero", "-", "--regime", "blended", "--mach", mach, "--knudsen", "0", "--alpha", "0,20,135", "--json"];
    const told = JSON.parse(cargo(words, { input: file.text, encoding: "utf8", timeout: 60_000 }));
    for (const [place, alpha] of [0, 20, 135].entries()) {
      assert.equal(Number(rows[alpha][column]), told.results.cn[place], `Mach ${mach}, ${alpha} deg`);
    }
  }
}, { allowed: software });

pageTest("trim is found about a center of gravity, and is stable or not", async (page) => {
  await page.getByRole("button", { name: "60 deg sphere-cone", exact: true }).click();
  await ready(page);
  await page.getByText("The center of gravity of this outline is not known").first().waitFor();
  await field(page, /^CG/).fill("0.2");
  const trim = page.getByRole("region", { name: "Trim and stability" });
  const first = trim.getByRole("row", { name: /Mach 20/ });
  await first.getByText("0 deg").first().waitFor();
  assert.match(await first.innerText(), /\b0 deg\s*stable/);
  assert.match(await first.innerText(), /unstable/);
  const moment = figure(page, "Pitching Moment about the CG Cm over angle of attack");
  await moment.getByRole("button", { name: /^Table of/ }).click();
  const numbers = moment.getByRole("region", { name: /^Numbers of/ });
  await numbers.getByText("stable trim").first().waitFor();
  await field(page, "Mach numbers").fill("20, x");
  await page.locator(".field-error", { hasText: "got x, must be numbers from 0 to 100" }).waitFor();
  assert.equal(await field(page, "Mach numbers").getAttribute("aria-invalid"), "true");
}, { hash });

pageTest("every curve says where it comes from, the placeholder that it is assumed", async (page) => {
  await ready(page);
  const figures = page.locator("figure.chart-panel");
  const count = await figures.count();
  assert.ok(count >= 18, `${count} figures`);
  for (let i = 0; i < count; i += 1) {
    assert.ok((await figures.nth(i).locator(".origins .mark").count()) >= 1, `figure ${i} has a source`);
  }
  const damping = figure(page, "Pitch Damping Cmq over Mach number");
  assert.equal(await damping.getByText("placeholder for Viking, assumed").count(), 3);
  await page.getByText("The Viking data of the report's Figure 30 are not public").waitFor();
  await page.getByText("Choices of the database").click();
  await page.getByLabel("Pitch Damping", { exact: true }).selectOption("none");
  await damping.getByText("none, taken as zero").first().waitFor();
}, { hash });

pageTest("a chart is read by keyboard", async (page) => {
  await ready(page);
  const chart = page.getByRole("application", { name: /^Axial Force Coefficient CA over angle of attack/ });
  await chart.focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowRight");
  await page.locator(".reading[aria-live=polite]", { hasText: /Angle of Attack 1 deg: Mach 20 1\.4/ }).waitFor();
}, { hash });

pageTest("a table of one's own is used, kept and taken out; faults are told at their lines", async (page) => {
  await ready(page);
  await choose(page, "hole.csv", table.replace("\n5, 30, 1.2,", "\n5, 30, ,"));
  const alert = page.getByRole("alert");
  await alert.getByRole("heading", { name: "hole.csv has 1 fault" }).waitFor();
  await alert.getByText(/^line 6: .*hole/).waitFor();
  assert.match(await alert.locator(".fault-lines").innerText(), /6\s+5, 30, /);
  await choose(page, "words.csv", "mach, alpha_deg, ca, cn\n5, 0, 1.5, 0\n5, ten, 1.4, 0.1\n");
  await alert.getByText(/^line 3: column 2: got "ten", must be a number/).waitFor();
  await choose(page, "one-sided.csv", "mach, alpha_deg, ca, cn\n5, -10, 1.5, -0.1\n5, 0, 1.5, 0\n5, 20, 1.4, 0.2\n");
  await alert.getByText(/one-sided/).first().waitFor();

  await choose(page, "tunnel.csv", table);
  await page.getByRole("heading", { name: /table tunnel$/, level: 2 }).waitFor();
  await page.locator(".origins .mark", { hasText: "own table" }).first().waitFor();
  const mach = field(page, "Mach numbers");
  await mach.fill("0.1");
  const force = figure(page, "Axial Force Coefficient CA over angle of attack");
  const held = (await downloaded(page, force.getByRole("button", { name: /^CSV of/ }))).text.split("\n")[1];
  assert.equal(held, "0,1.5");
  await page.locator(".saved", { hasText: "saved in this browser" }).waitFor();
  await page.reload();
  await page.getByRole("button", { name: "tunnel (9 rows)" }).waitFor();
  await page.getByRole("button", { name: "Remove tunnel" }).click();
  await page.getByRole("button", { name: "tunnel (9 rows)" }).waitFor({ state: "detached" });
  await page.keyboard.press("ControlOrMeta+z");
  await page.getByRole("button", { name: "tunnel (9 rows)" }).waitFor();
}, { hash });

pageTest("a database is used in a flight and in the design", async (page) => {
  await ready(page);
  await page.getByRole("button", { name: "Use in the design" }).click();
  await page.getByRole("button", { name: "Undo: Aerodynamics of the design" }).waitFor();
  await page.getByRole("button", { name: "Use in a flight" }).click();
  await page.getByRole("heading", { name: "Vehicles", level: 2 }).waitFor();
  await page.getByRole("heading", { name: /60 deg/, level: 2 }).waitFor();
  await page.waitForFunction(() => [...document.querySelectorAll(".flight-form select")].some((list) => list.value === "mmeev-60"));
  await page.locator("[data-flown=peak_deceleration_earth_g] .value").waitFor();
}, { hash, allowed: software });

pageTest("the design is shown with its own center of gravity", async (page) => {
  const trim = page.getByRole("region", { name: "Trim and stability" });
  await trim.getByText("stable", { exact: true }).first().waitFor();
  assert.match(await field(page, /^CG/).getAttribute("placeholder"), /^0\.\d+$/);
}, { hash: `${hash}?o=design` });

for (const colorScheme of ["light", "dark"]) {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 360, height: 740 }]) {
    pageTest(`the page of aerodynamics is accessible in ${colorScheme} at ${viewport.width} px`, async (page) => {
      await ready(page);
      await field(page, /^CG/).fill("0.2");
      await page.locator(".trim-point").first().waitFor();
      await page.getByText("Choices of the database").click();
      await figure(page, "Drag Coefficient CD over Mach number").getByRole("button", { name: /^Table of/ }).click();
      await choose(page, "bad.csv", "mach, alpha_deg, ca, cn\n1, 0, x, 0\n");
      await page.getByRole("alert").getByText(/line 2/).first().waitFor();
      await assertAccessible(page);
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.equal(overflow, 0, "nothing is wider than the screen");
    }, { hash, context: { colorScheme, viewport } });
  }
}
