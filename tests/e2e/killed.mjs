// The renderer is killed when the page says that it has saved: nothing reported as saved may be lost. KILLS is the
// number of trials (12), KILL_SEED the seed of their edits.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { chromium } from "playwright-core";

const address = process.env.MSAPE_URL ?? "http://127.0.0.1:8080/";
const trials = Number(process.env.KILLS ?? 12);
let seed = Number(process.env.KILL_SEED ?? 1);

/** Next pseudo-random number in [0, 1), the same in each run. Constants: Numerical Recipes, quick generator. */
function random() {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return seed / 2 ** 32;
}

const points = 6_000;
const outline = ["x (m),r (m)", "0,0"];
for (let i = 1; i < points - 1; i += 1) {
  outline.push(`${i / points},${Math.sqrt(i / points)}`);
}
outline.push("1,0");
const air = Array.from({ length: points }, (_, i) => `[${i * 20}, ${(1.2 * Math.exp((-i * 20) / 7200)).toExponential(6)}]`);
const large = `schema = "msape/1"\nname = "0"\n[atmosphere]\ntable = [${air}]\n[design]\ndiameter_m = 0.9\n`;

const opened = (page) => page.locator("#skeleton").waitFor({ state: "detached" });
const saved = (page) => page.locator(".saved", { hasText: /^saved in this browser$/ }).waitFor();

/** IDs of the renderer processes of this browser. */
async function renderers(context) {
  const session = await context.browser().newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  return processInfo.filter(({ type }) => type === "renderer").map(({ id }) => id);
}

/**
 * Types a burst of edits and kills the page when the label says "saved" for the `at`-th time.
 * @returns {Promise<number>} the edit that was reported as saved
 */
async function killAtSaved(context, page, first, count, at) {
  const processes = await renderers(context);
  const claimed = new Promise((resolve) => {
    page.exposeBinding("claim", (_, edit) => {
      for (const id of processes) {
        try {
          process.kill(id, "SIGKILL");
        } catch {
          // already gone
        }
      }
      resolve(edit);
    });
  });
  await page.waitForFunction(() => "claim" in window);
  // faster than the disk, or slow enough for the label to appear between edits
  const gaps = Array.from({ length: count }, () => random() * (random() < 0.5 ? 25 : 250));
  await page.evaluate(
    ([first, gaps, at]) => {
      const field = document.querySelector("#case-name");
      const label = document.querySelector(".saved");
      let seen = 0;
      let edit = 0;
      new MutationObserver(() => {
        if (label.textContent.startsWith("saved") && edit > 0) {
          seen += 1;
          if (seen === at || edit === gaps.length) {
            window.claim(Number(field.value));
          }
        }
      }).observe(label, { subtree: true, characterData: true, childList: true });
      const next = () => {
        field.value = String(first + edit);
        field.dispatchEvent(new Event("input", { bubbles: true }));
        edit += 1;
        if (edit < gaps.length) {
          setTimeout(next, gaps[edit]);
        }
      };
      setTimeout(next, 0);
    },
    [first, gaps, at],
  );
  return claimed;
}

async function kill(name, prepare) {
  const folder = await mkdtemp(join(tmpdir(), "msape-killed-"));
  const context = await chromium.launchPersistentContext(folder, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", "--disable-background-networking"],
  });
  try {
    context.setDefaultTimeout(30_000);
    let page = await context.newPage();
    await page.goto(address);
    await opened(page);
    await prepare(page);
    await saved(page);
    let edit = 1;
    const lost = [];
    let between = 0;
    for (let trial = 0; trial < trials; trial += 1) {
      const count = 1 + Math.floor(random() * 7);
      const claimed = await killAtSaved(context, page, edit, count, 1 + Math.floor(random() * count));
      between += claimed < edit + count - 1 ? 1 : 0;
      edit += count;
      // the browser may not report that a page with a killed process is closed
      await Promise.race([page.close().catch(() => {}), new Promise((resolve) => setTimeout(resolve, 5_000))]);
      page = await context.newPage();
      await page.goto(address);
      await opened(page);
      await saved(page);
      const kept = Number(await page.locator("#case-name").inputValue());
      const apart = await page.getByRole("region", { name: "Work kept apart" }).count();
      if (!(kept >= claimed) || apart > 0) {
        lost.push(`called saved: ${claimed}, found: ${kept}`);
      }
    }
    console.log(`${name}: ${trials} kills, ${lost.length} lost an edit that was called saved; ${between} fell between edits`);
    assert.deepEqual(lost, []);
  } finally {
    await context.close();
    await rm(folder, { recursive: true, force: true });
  }
}

const patience = { timeout: 60_000 + trials * 15_000 };

test("bursts of edits of a small case", patience, () =>
  kill("small case", async (page) => {
    await page.locator("#case-name").fill("0");
  }));

test("bursts of edits beside an outline of 6,000 points", patience, () =>
  kill("outline of 6,000 points", async (page) => {
    await page.goto(`${address}#/library/vehicles`);
    await page.getByLabel("Import an outline (CSV or DXF)").setInputFiles({
      name: "large.csv",
      mimeType: "text/csv",
      buffer: Buffer.from(outline.join("\n")),
    });
    await page.getByRole("button", { name: "Remove large" }).waitFor();
    await page.goto(`${address}#/design`);
    await page.locator("#case-name").fill("0");
  }));

test("bursts of edits of a case with a table of 6,000 rows", patience, () =>
  kill("case of 6,000 rows", async (page) => {
    await page.getByLabel("Or paste a case").fill(large);
    await page.getByRole("button", { name: "Open pasted case" }).click();
    await page.waitForFunction(() => document.querySelector("#case-name").value === "0");
  }));
