// A page of the app in Chromium, for a test. By its end the page must have logged no error and requested no other
// origin. `cargo xtask test e2e` builds and serves the app and sets MSAPE_URL and CHROMIUM.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import AxeBuilder from "@axe-core/playwright";
import { chromium } from "playwright-core";

const address = process.env.MSAPE_URL ?? "http://127.0.0.1:8080/";
const patience_ms = 20_000;

let browser;

before(async () => {
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    timeout: 60_000,
    args: [
      "--no-sandbox",
      "--disable-gpu",
      "--disable-dev-shm-usage",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
    ],
  });
});

after(async () => {
  await browser?.close();
});

/**
 * Declares a test. `steps` gets a page on which the app is open.
 * @param {string} name
 * @param {(page: import("playwright-core").Page) => Promise<void>} steps
 * @param {{ hash?: string, allowed?: RegExp, context?: import("playwright-core").BrowserContextOptions }} options
 * `hash`: place in the app, "#/..."; `allowed`: errors that the test provokes; `context`: size, color scheme ...
 */
export function pageTest(name, steps, { hash = "", allowed = /^$/, context: contextOptions = {} } = {}) {
  test(name, { timeout: 120_000 }, async () => {
    const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...contextOptions });
    try {
      context.setDefaultTimeout(patience_ms);
      const faults = watch(context);
      const page = await context.newPage();
      await page.goto(address + hash);
      await page.locator("#skeleton").waitFor({ state: "detached" });
      await steps(page);
      const unexpected = faults.filter((fault) => !allowed.test(fault));
      assert.deepEqual(unexpected, [], "console errors, failed requests or requests to another origin");
    } finally {
      await context.close();
    }
  });
}

/** Fails if axe finds a violation in the current state of the page. */
export async function assertAccessible(page) {
  const { violations } = await new AxeBuilder({ page }).analyze();
  const found = violations.map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.map((node) => node.html).join(" ")}`);
  assert.deepEqual(found, [], "axe violations");
}

/** Collects errors and other forbidden events on the pages of a context. */
function watch(context) {
  const faults = [];
  const origin = new URL(address).origin;
  context.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) {
      faults.push(`console ${message.type()}: ${message.text()}`);
    }
  });
  context.on("weberror", (error) => faults.push(`uncaught: ${error.error()}`));
  context.on("request", (request) => {
    const url = new URL(request.url());
    if (["http:", "https:", "ws:", "wss:"].includes(url.protocol) && url.origin !== origin) {
      faults.push(`request to another origin: ${url}`);
    }
  });
  context.on("response", (response) => {
    if (response.status() >= 400) {
      faults.push(`answer ${response.status()}: ${response.url()}`);
    }
  });
  return faults;
}
