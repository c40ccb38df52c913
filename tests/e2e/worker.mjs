// The worker may be blocked, terminated or missing: there is always a message and a way to continue, and the next edit
// is answered.

import assert from "node:assert/strict";
import { pageTest } from "./harness.mjs";

const software = /software WebGL|GPU stall due to ReadPixels|GL Driver Message/;
const freshness = (page) => page.locator(".freshness");
const fresh = (page) => freshness(page).filter({ hasText: /^up to date/ }).waitFor();
const diameter = (page) => page.locator("#in-design-diameter_m");
const startFrom = (page) => page.getByLabel("Start from");

/** Keeps every worker of the page in `window.workers`, in the order of their starts. */
const keepWorkers = () => {
  window.workers = [];
  window.Worker = class extends window.Worker {
    constructor(...given) {
      super(...given);
      window.workers.push(this);
    }
  };
};

const opened = (page) => page.locator("#skeleton").waitFor({ state: "detached" });

async function reload(page) {
  await page.reload();
  await opened(page);
}

// allowed values that need the largest amount of work of the core
const blocking =
  "#/design?p=run-page&design.max_iterations=10000&design.relaxation=1e-6&design.mass_criterion_kg=1e-15&solver.method=rk4&solver.step_s=0.001";

pageTest("a link whose run takes long does not hold up an edit", async (page) => {
  await freshness(page).filter({ hasText: /^(solving, \d+ s so far|up to date|not solved)/ }).waitFor({ timeout: 10_000 });
  const start = Date.now();
  await startFrom(page).selectOption("msr-eev-pica");
  await fresh(page);
  assert.ok(Date.now() - start < 10_000, `the edit was answered after ${Date.now() - start} ms`);
}, { hash: blocking, allowed: software });

const busy_ms = 7_000;

/** Keeps the thread of the solver busy for `busy_ms` before every run, independent of the speed of the machine. */
async function slowDown(page) {
  await page.route("**/worker-start.js", async (route) => {
    const response = await route.fetch();
    const body = `const post = self.postMessage.bind(self);
self.postMessage = (message, ...rest) => {
  post(message, ...rest);
  for (const end = Date.now() + (message === "begun" ? ${busy_ms} : 0); Date.now() < end; ) {}
};
${await response.text()}`;
    await route.fulfill({ response, body });
  });
  await reload(page);
}

const entryMass = (page) => page.locator("dd[data-output=total_entry_mass_kg] .value").innerText();
const solving = (page) => freshness(page).filter({ hasText: /^solving, \d+ s so far/ }).waitFor();

pageTest("Stop ends a run that is under way, and Try again solves it", async (page) => {
  await slowDown(page);
  await solving(page);
  assert.equal(page.workers().length, 1);
  const running = page.workers()[0];
  const ended = new Promise((resolve) => running.once("close", resolve));
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await ended;
  // longer than the run would have taken
  await page.waitForTimeout(busy_ms);
  assert.equal(await freshness(page).innerText(), "not solved: stopped.");
  assert.equal(page.workers().length, 0);
  assert.equal(await entryMass(page), "–");
  await page.getByRole("button", { name: "Try again" }).click();
  await solving(page);
  await fresh(page);
  assert.match(await entryMass(page), /^\d+(\.\d+)?$/);
}, { allowed: software });

pageTest("Stop while an edit waits stops that as well, and Try again solves the edit", async (page) => {
  await slowDown(page);
  await solving(page);
  // an edit ends the run after a second: press Stop before
  await page.evaluate(async () => {
    const field = document.querySelector("#in-design-diameter_m");
    field.value = "-1";
    field.dispatchEvent(new Event("input", { bubbles: true }));
    field.dispatchEvent(new Event("change", { bubbles: true }));
    const stop = () => [...document.querySelectorAll("button")].find((button) => button.textContent === "Stop");
    await new Promise((resolve) => setTimeout(resolve, 50));
    while (!stop()) {
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
    stop().click();
  });
  await freshness(page).filter({ hasText: "not solved" }).waitFor();
  for (let i = 0; i < 20; i += 1) {
    assert.equal(await freshness(page).innerText(), "not solved: stopped.");
    await page.waitForTimeout(100);
  }
  assert.equal(page.workers().length, 0);
  await page.getByRole("button", { name: "Try again" }).click();
  await freshness(page).filter({ hasText: /^input at fault/ }).waitFor();
}, { allowed: software });

pageTest("a worker that is ended from outside is replaced, idle or at work", async (page) => {
  await page.addInitScript(keepWorkers);
  await reload(page);
  await fresh(page);
  await page.evaluate(() => window.workers.at(-1).terminate());
  await diameter(page).fill("1.1");
  await page.keyboard.press("Enter");
  await freshness(page).filter({ hasText: /^up to date/ }).waitFor({ timeout: 15_000 });
  assert.equal(await page.evaluate(() => window.workers.length), 2);

  await page.evaluate((hash) => {
    location.hash = hash;
  }, blocking);
  await page.waitForTimeout(500);
  await page.evaluate(() => window.workers.at(-1).terminate());
  await startFrom(page).selectOption("galahad");
  await freshness(page).filter({ hasText: /^up to date/ }).waitFor({ timeout: 15_000 });
}, { allowed: software });

pageTest("a worker that cannot be loaded is tried again later each time, with a word and a button", async (page) => {
  let asked = 0;
  let refuse = true;
  await page.route("**/worker_bg.wasm", async (route) => {
    asked += 1;
    await (refuse ? route.abort() : route.continue());
  });
  await reload(page);
  await freshness(page).filter({ hasText: /^not solved: the solver cannot be loaded; it is started again in \d+ s/ }).waitFor();
  await page.waitForTimeout(5_000);
  assert.ok(asked >= 2 && asked <= 6, `${asked} requests in 5 s`);
  refuse = false;
  await page.getByRole("button", { name: "Try again" }).click();
  await fresh(page);
}, { allowed: /software WebGL|GPU stall|GL Driver|ERR_FAILED|Failed to fetch|uncaught|TypeError|worker/i });

pageTest("a toolbox that cannot be loaded is told by its name, is not asked for by itself, and comes when it can", async (page) => {
  let asked = 0;
  let refuse = true;
  await page.route("**/tools_bg.wasm", async (route) => {
    asked += 1;
    await (refuse ? route.abort() : route.continue());
  });
  const choose = () =>
    page.getByLabel("Import an outline (CSV or DXF)").setInputFiles({
      name: "cone.csv",
      mimeType: "text/csv",
      buffer: Buffer.from("x (m),r (m)\n0,0\n1,1\n1,0\n"),
    });
  await reload(page);
  await choose();
  await page.getByText("the toolbox cannot be loaded").first().waitFor();
  // the flight of the displayed outline, which follows the first design, has been requested by then
  await page.waitForTimeout(2_000);
  const before = asked;
  await page.waitForTimeout(5_000);
  assert.equal(asked, before, "nothing asks, and nothing is loaded");
  refuse = false;
  await choose();
  await page.getByRole("button", { name: "Remove cone" }).waitFor();
}, { hash: "#/library/vehicles", allowed: /software WebGL|GPU stall|GL Driver|ERR_FAILED|Failed to fetch|uncaught|TypeError|worker/i });

pageTest("the rows of a chart's table can be turned with buttons and keys", async (page) => {
  await fresh(page);
  await page.getByRole("button", { name: /^Table of Geodetic Altitude over time/ }).click();
  const pager = page.getByRole("group", { name: "Rows of the table" });
  const first = () => page.locator(".chart-table tbody tr").first().innerText();
  const shown = async (pattern) => {
    await pager.getByText(pattern).waitFor();
    return first();
  };
  const start = await shown(/^rows 1-25 of \d+$/);
  await pager.getByRole("button", { name: "Next rows" }).click();
  const second = await shown(/^rows 26-50 of \d+$/);
  assert.notEqual(second, start);
  await pager.getByRole("button", { name: "Last rows" }).click();
  const total = Number((await pager.innerText()).match(/of (\d+)/)[1]);
  await shown(new RegExp(`-${total} of ${total}$`));
  await page.keyboard.press("Home");
  assert.equal(await shown(/^rows 1-25 of/), start);
  await page.keyboard.press("PageDown");
  assert.equal(await shown(/^rows 26-50 of/), second);
  await page.keyboard.press("PageUp");
  await shown(/^rows 1-25 of/);
  await page.keyboard.press("End");
  await shown(new RegExp(`-${total} of ${total}$`));
  await pager.getByRole("button", { name: "First rows" }).click();
  await shown(/^rows 1-25 of/);
}, { allowed: software });
