// The app opens and its worker answers, without any error.

import assert from "node:assert/strict";
import { assertAccessible, pageTest } from "./harness.mjs";

for (const colorScheme of ["light", "dark"]) {
  pageTest(
    `opens and is accessible in ${colorScheme}`,
    async (page) => {
      await page.getByRole("heading", { name: "M-SAPE", level: 1 }).waitFor();
      await assertAccessible(page);
    },
    { context: { colorScheme } },
  );
}

pageTest(
  "the page may ask no other origin",
  async (page) => {
    const refused = await page.evaluate(async () => {
      const violation = new Promise((resolve) => document.addEventListener("securitypolicyviolation", resolve));
      // the same server under another host name is another origin
      fetch(`http://localhost:${location.port}/`).catch(() => {});
      return (await violation).violatedDirective;
    });
    assert.equal(refused, "connect-src");
  },
  { allowed: /Content Security Policy|localhost/ },
);
