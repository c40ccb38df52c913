// Storage: unreadable records, a browser that refuses, links, two tabs. The name of each test states the expected
// behavior.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { assertAccessible, pageTest } from "./harness.mjs";

const software = /software WebGL|GPU stall due to ReadPixels|GL Driver Message/;
const name = (page) => page.getByLabel("Name of the case");
const saved = (page) => page.locator(".saved", { hasText: /^saved in this browser$/ }).waitFor();
const apart = (page) => page.locator(".saved", { hasText: /^saved in this browser, apart$/ }).waitFor();
const opened = (page) => page.locator("#skeleton").waitFor({ state: "detached" });
const region = (page, label) => page.getByRole("region", { name: label });

/** Another tab of the same browser. */
async function tab(page, hash = "") {
  const other = await page.context().newPage();
  await other.goto(page.url().split("#")[0] + hash);
  await opened(other);
  return other;
}

async function reload(page) {
  await page.reload();
  await opened(page);
}

/** Waits until the case has this name. */
const named = (page, text) =>
  page.waitForFunction((wanted) => document.querySelector("#case-name").value === wanted, text);

/** Reads, writes or removes a record of the browser's database. */
const record = (page, store, key, value) =>
  page.evaluate(
    ([store, key, value]) =>
      new Promise((resolve, reject) => {
        const request = indexedDB.open("msape");
        request.onerror = () => reject(request.error);
        request.onsuccess = () => {
          const database = request.result;
          const transaction = database.transaction([store], "readwrite");
          const found = transaction.objectStore(store).get(key);
          if (value !== null) {
            transaction.objectStore(store).put(value, key);
          }
          transaction.oncomplete = () => {
            database.close();
            resolve(found.result ?? null);
          };
          transaction.onabort = () => reject(transaction.error);
        };
      }),
    [store, key, value ?? null],
  );

const sheet = (toml, units = "Report") => JSON.stringify({ case: toml, units, unit_of: {} });

const bad = {
  "broken JSON": '{"case": "sche',
  "a number": 42,
  "an object": { case: "mine" },
  "a newer schema": sheet('schema = "msape/2"\nname = "mine"\n'),
  "an unknown unit system": sheet('schema = "msape/1"\n', "Furlongs"),
  "TOML that is none": sheet('schema = "msape/1"\n[design\n'),
};

for (const [what, value] of Object.entries(bad)) {
  pageTest(`stored work that is ${what} is kept aside, can be downloaded and discarded`, async (page) => {
    await saved(page);
    await record(page, "things", "current", value);
    await reload(page);
    const told = region(page, "Records that cannot be read");
    await told.waitFor();
    await saved(page);
    await name(page).fill("new work");
    await saved(page);
    const download = page.waitForEvent("download");
    await told.getByRole("button", { name: /^Download/ }).click();
    const text = await readFile(await (await download).path(), "utf8");
    assert.equal(text, typeof value === "string" ? value : JSON.stringify(value));
    await reload(page);
    await named(page, "new work");
    await told.waitFor();
    await assertAccessible(page);
    await told.getByRole("button", { name: /^Discard / }).click();
    await told.getByRole("button", { name: /^Discard for good/ }).click();
    await told.waitFor({ state: "detached" });
    await reload(page);
    await named(page, "new work");
    await saved(page);
    assert.equal(await told.count(), 0);
  }, { allowed: software });
}

pageTest("a run and an outline that cannot be read stay as they are and hide nothing", async (page) => {
  await page.getByLabel("Run Name", { exact: true }).fill("good");
  await page.getByRole("button", { name: "Save run" }).click();
  await page.getByRole("status").getByText("Run good is saved in this browser.").waitFor();
  const run = JSON.stringify({ name: "newer", saved_ms: 1, case: 'schema = "msape/2"', headline: [] });
  await record(page, "runs", "1-0", run);
  await record(page, "things", "outline cone", 7);
  await reload(page);
  const told = region(page, "Records that cannot be read");
  await told.getByText(/the saved run newer/).waitFor();
  await told.getByText(/the outline cone/).waitFor();
  await page.getByRole("button", { name: "Open good" }).waitFor();
  await name(page).fill("x");
  await saved(page);
  assert.equal(await record(page, "runs", "1-0"), run);
  assert.equal(await record(page, "things", "outline cone"), 7);
}, { allowed: software });

pageTest("work with keys that no version knows is there after a reload", async (page) => {
  for (const line of ['description = "my study"', '"my key" = 1', '"a.b c" = 1', '"" = 1']) {
    await page.getByLabel("Or paste a case").fill(`schema = "msape/1"\nname = "odd"\n${line}\n[design]\ndiameter_m = 1.234\n`);
    await page.getByRole("button", { name: "Open pasted case" }).click();
    await named(page, "odd");
    await saved(page);
    await reload(page);
    await named(page, "odd");
    assert.equal(await page.locator("#in-design-diameter_m").inputValue(), "1.234", line);
    await name(page).fill("between");
  }
}, { allowed: software });

/** Aborts transactions at their commit while `window.aborts` is above 0. */
const abortAtCommit = () => {
  window.aborts = 0;
  const commit = IDBTransaction.prototype.commit;
  IDBTransaction.prototype.commit = function () {
    if (this.mode === "readwrite" && window.aborts > 0) {
      window.aborts -= 1;
      return this.abort();
    }
    return commit.call(this);
  };
};

pageTest("a transaction that is given up at its commit is told, is not called saved, and is tried again", async (page) => {
  await page.addInitScript(abortAtCommit);
  await reload(page);
  await saved(page);
  await page.evaluate(() => {
    window.aborts = 2;
    window.labels = [];
    const label = document.querySelector(".saved");
    new MutationObserver(() => window.labels.push(label.textContent)).observe(label, { subtree: true, characterData: true, childList: true });
  });
  await name(page).fill("given up");
  await page.locator(".saved.bad", { hasText: "not saved" }).waitFor();
  await saved(page);
  const labels = await page.evaluate(() => [window.labels, window.aborts]);
  assert.equal(labels[1], 0);
  const refused = labels[0].findIndex((label) => label.startsWith("not saved"));
  assert.ok(labels[0].slice(0, refused).every((label) => label === "saving"), `${labels[0]}`);
  await reload(page);
  await named(page, "given up");
}, { allowed: software });

pageTest("while the browser gives everything up nothing is called saved, and leaving is asked about", async (page) => {
  await page.addInitScript(abortAtCommit);
  await reload(page);
  await saved(page);
  await page.evaluate(() => {
    window.aborts = 1e9;
  });
  await name(page).pressSequentially("abc");
  await page.locator(".saved.bad").waitFor();
  await page.waitForTimeout(3_000);
  assert.match(await page.locator(".saved").innerText(), /^not saved: /);
  const asked = page.waitForEvent("dialog");
  await page.close({ runBeforeUnload: true });
  const dialog = await asked;
  assert.equal(dialog.type(), "beforeunload");
  await dialog.accept();
}, { allowed: software });

pageTest("an edit is there after a reload that follows at once", async (page) => {
  await saved(page);
  for (let i = 0; i < 6; i += 1) {
    await page.evaluate((text) => {
      const field = document.querySelector("#case-name");
      field.value = text;
      field.dispatchEvent(new Event("input", { bubbles: true }));
      // after the edit has been accepted, and before any disk can have answered
      Promise.resolve().then(() => Promise.resolve().then(() => location.reload()));
    }, `edit ${i}`).catch(() => {});
    await page.waitForLoadState("load");
    await opened(page);
    await saved(page);
    await named(page, `edit ${i}`);
    assert.equal(await region(page, "Work kept apart").count(), 0);
  }
}, { allowed: software });

const link = "#/design?v=0.2&p=msr-eev-pica&n=From%20a%20link&entry.speed_m_s=12345";

/** Stores unsaved work as a closing page would hand it over to the next page. */
const handOver = (page, id, sheet) =>
  page.evaluate(([id, text]) => localStorage.setItem(`msape-last ${id}`, text), [id, JSON.stringify(sheet)]);

/** Number of items handed over by closed pages and not taken yet. */
const handedOver = (page) =>
  page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("msape-last ")).length);

/** Case and units with a name, as a closing page hands them over. */
const closedSheet = (name, continues) => ({
  case: `schema = "msape/1"\nname = "${name}"\n`,
  units: "Report",
  unit_of: {},
  why: "Closed",
  continues,
});

for (const what of ["beside stored work", "where nothing is stored"]) {
  pageTest(`what a closed page handed over ${what} outlives a link that is opened next`, async (page) => {
    await page.getByLabel("Name of the case").waitFor();
    await saved(page);
    const address = page.url().split("#")[0];
    // a page of the same origin without the app
    await page.route("**/empty", (route) => route.fulfill({ contentType: "text/html", body: "" }));
    let current = await record(page, "things", "current");
    await page.goto(`${address}empty`);
    if (what === "where nothing is stored") {
      await page.evaluate(() => new Promise((resolve) => {
        indexedDB.deleteDatabase("msape").onsuccess = resolve;
      }));
      current = "";
    }
    await handOver(page, "1-closed", closedSheet("handed over", current));
    await page.goto(address + link);
    await opened(page);
    await named(page, "From a link");
    await region(page, "Kept apart").getByText(/handed over, .*is kept/).waitFor();
    await name(page).fill("changed link");
    await apart(page);
    const next = await tab(page);
    await named(next, "handed over");
    await region(page, "Kept apart").getByRole("button", { name: "Return to it" }).click();
    await named(page, "handed over");
    await saved(page);
    await reload(page);
    await named(page, "handed over");
  }, { allowed: software });
}

pageTest("a disk that is full hides no stored work, and what was handed over stays", async (page) => {
  await name(page).fill("my work");
  await saved(page);
  await handOver(page, "2-closed", closedSheet("handed over", "another text"));
  await page.addInitScript(() => {
    const put = IDBObjectStore.prototype.put;
    IDBObjectStore.prototype.put = function (...given) {
      if (!sessionStorage.getItem("room")) {
        throw new DOMException("full", "QuotaExceededError");
      }
      return put.apply(this, given);
    };
  });
  await reload(page);
  await named(page, "my work");
  await region(page, "About the stored work").getByText(/closed is not stored yet: .*full/).waitFor();
  await region(page, "Work kept apart").getByText(/^handed over/).waitFor();
  assert.equal(await handedOver(page), 1);
  await page.evaluate(() => sessionStorage.setItem("room", "1"));
  await reload(page);
  await named(page, "my work");
  await region(page, "Work kept apart").getByText(/^handed over/).waitFor();
  assert.equal(await region(page, "About the stored work").count(), 0);
  assert.equal(await handedOver(page), 0);
}, { allowed: software });

pageTest("stored work that cannot be read and cannot be moved is told, and hides no run", async (page) => {
  await page.getByLabel("Run Name", { exact: true }).fill("good");
  await page.getByRole("button", { name: "Save run" }).click();
  await page.getByRole("status").getByText("Run good is saved in this browser.").waitFor();
  await record(page, "things", "current", 7);
  await page.addInitScript(() => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
  await reload(page);
  await page.getByRole("button", { name: "Open good" }).waitFor();
  await region(page, "About the stored work").getByText(/could not be moved: .*full/).waitFor();
  await region(page, "Records that cannot be read").waitFor();
}, { allowed: software });

pageTest("what waits to be saved of a link is saved although the stored work is shown before", async (page) => {
  await page.addInitScript(abortAtCommit);
  await page.reload();
  await opened(page);
  await name(page).fill("my work");
  await saved(page);
  await page.evaluate((hash) => {
    location.hash = hash;
  }, link);
  await named(page, "From a link");
  await page.evaluate(() => {
    window.aborts = 1e9;
  });
  await name(page).fill("changed link");
  await page.locator(".saved.bad").waitFor();
  await region(page, "Kept apart").getByRole("button", { name: "Return to it" }).click();
  await named(page, "my work");
  await page.evaluate(() => {
    window.aborts = 0;
  });
  await saved(page);
  const next = await tab(page);
  await named(next, "my work");
  await region(next, "Work kept apart").getByText(/^changed link/).waitFor();
}, { allowed: software });

pageTest("the database is opened once, however many ask for it", async (page) => {
  await page.addInitScript(() => {
    window.opens = 0;
    const open = IDBFactory.prototype.open;
    IDBFactory.prototype.open = function (...given) {
      window.opens += 1;
      return open.apply(this, given);
    };
  });
  await page.reload();
  await opened(page);
  await name(page).fill("my work");
  await saved(page);
  await page.evaluate((hash) => {
    location.hash = hash;
  }, link);
  await named(page, "From a link");
  await name(page).fill("changed link");
  await apart(page);
  assert.equal(await page.evaluate(() => window.opens), 1);
  // the app closes the database so that it can be deleted, and then needs it twice at the same time
  await page.evaluate(() => new Promise((resolve) => {
    indexedDB.deleteDatabase("msape").onsuccess = resolve;
  }));
  await page.evaluate(() => {
    const field = document.querySelector("#case-name");
    field.value = "twice";
    field.dispatchEvent(new Event("input", { bubbles: true }));
    [...document.querySelectorAll("button")].find((button) => button.textContent === "Keep this instead").click();
  });
  await saved(page);
  assert.equal(await page.evaluate(() => window.opens), 2);
  await reload(page);
  await named(page, "twice");
}, { allowed: software });

const refusals = {
  "throws at put": () => {
    const full = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
    IDBObjectStore.prototype.put = full;
    IDBObjectStore.prototype.add = full;
  },
  "has no database": () => Object.defineProperty(window, "indexedDB", { value: undefined }),
  "cannot open it": () => {
    IDBFactory.prototype.open = () => {
      throw new DOMException("no", "SecurityError");
    };
  },
};

for (const [what, script] of Object.entries(refusals)) {
  pageTest(`in a browser that ${what} a run is not said to be saved`, async (page) => {
    await page.addInitScript(script);
    await reload(page);
    await page.getByLabel("Run Name", { exact: true }).fill("r1");
    await page.getByRole("button", { name: "Save run" }).click();
    await page.getByRole("status").getByText(/^Run r1 is not saved yet: /).waitFor();
    await page.locator(".saved.bad", { hasText: /^not saved: / }).waitFor();
    assert.equal(await page.getByText("Run r1 is saved").count(), 0);
  }, { allowed: software });
}

pageTest("a link never replaces stored work: opened and closed, the work is there", async (page) => {
  await name(page).fill("my work");
  await saved(page);
  await page.close();
  const linked = await page.context().newPage();
  await linked.goto(page.url().split("#")[0] + link);
  await named(linked, "From a link");
  await region(linked, "Kept apart").getByText(/my work, .* is kept/).waitFor();
  await assertAccessible(linked);
  await reload(linked);
  await named(linked, "From a link");
  await linked.close();
  const next = await page.context().newPage();
  await next.goto(page.url().split("#")[0]);
  await named(next, "my work");
  assert.equal(await region(next, "Work kept apart").count(), 0, "a link that was only looked at leaves nothing");
}, { allowed: software });

pageTest("what is changed in a link is kept beside the work, through undo, reload, return and opening again", async (page) => {
  await name(page).fill("my work");
  await saved(page);
  await page.evaluate((hash) => {
    location.hash = hash;
  }, link);
  await named(page, "From a link");
  await page.getByRole("button", { name: "Undo: Open link" }).click();
  await named(page, "my work");
  assert.equal(await region(page, "Kept apart").count(), 0);
  await page.getByRole("button", { name: "Redo: Open link" }).click();
  await named(page, "From a link");
  await name(page).fill("changed link");
  await apart(page);
  await reload(page);
  await named(page, "changed link");
  await region(page, "Kept apart").getByRole("button", { name: "Return to it" }).click();
  await named(page, "my work");
  await saved(page);
  await reload(page);
  await named(page, "my work");
  await region(page, "Work kept apart").getByRole("button", { name: "Open changed link, kept apart" }).click();
  await named(page, "changed link");
  await region(page, "Kept apart").getByRole("button", { name: "Keep this instead" }).click();
  await saved(page);
  await page.getByRole("button", { name: "Open my work" }).waitFor();
  await reload(page);
  await named(page, "changed link");
  assert.equal(await region(page, "Work kept apart").count(), 0);
  await page.getByRole("button", { name: "Open my work" }).click();
  await named(page, "my work");
}, { allowed: software });

pageTest("a link that was cut or starts from nothing known says so", async (page) => {
  await page.evaluate(() => {
    location.hash = "#/design?k=0000beef&v=0.2&p=run-page&entry.speed_m_s=1300";
  });
  await region(page, "About the link").getByText(/was cut or changed/).waitFor();
  await page.evaluate(() => {
    location.hash = "#/design?v=0.2&p=no-such-case";
  });
  await region(page, "About the link").getByText(/no-such-case.*Nothing was opened/).waitFor();
  await page.getByRole("button", { name: "Dismiss" }).first().click();
  assert.equal(await region(page, "About the link").count(), 0);
  await page.evaluate(() => {
    location.hash = "#/design?k";
  });
  await region(page, "About the link").getByText(/was cut or changed/).waitFor();
}, { allowed: software });

pageTest("two tabs do not write over each other's work; both are there and can be chosen", async (page) => {
  await name(page).fill("first");
  await saved(page);
  const other = await tab(page);
  await named(other, "first");
  await name(page).fill("of tab A");
  await saved(page);
  await name(other).fill("of tab B");
  await apart(other);
  await region(other, "Kept apart").getByText(/Another tab has changed the stored work.*of tab A/).waitFor();
  await assertAccessible(other);
  await name(page).fill("of tab A, later");
  await saved(page);
  await reload(other);
  await named(other, "of tab B");
  await region(other, "Kept apart").getByRole("button", { name: "Take the other tab's" }).click();
  await named(other, "of tab A, later");
  await saved(other);
  // the work of B is one undo away, and in the list of a new tab
  const third = await tab(page);
  await region(third, "Work kept apart").getByText(/^of tab B, /).waitFor();
  await other.getByRole("button", { name: /^Undo: Return to/ }).click();
  await named(other, "of tab B");
  await region(other, "Kept apart").getByRole("button", { name: "Keep this instead" }).click();
  await saved(other);
  await name(page).fill("of tab A, too late");
  await apart(page);
  await reload(third);
  await named(third, "of tab B");
  await third.getByRole("button", { name: "Open of tab A, later" }).waitFor();
}, { allowed: software });

const outline = (radius) => `x (m),r (m)\n0,0\n1,${radius}\n1,0\n`;
const table = (force) => `mach,alpha_deg,ca,cn\n5,0,${force},0\n5,20,${force - 0.1},0.2\n`;

for (const { what, hash, label, text } of [
  { what: "outlines", hash: "#/library/vehicles", label: "Import an outline (CSV or DXF)", text: outline },
  { what: "tables", hash: "#/library/aerodynamics", label: /^Import a table/, text: table },
]) {
  pageTest(`imported ${what} of two tabs are all kept`, async (page) => {
    const choose = (page, file, text) =>
      page.getByLabel(label).setInputFiles({ name: file, mimeType: "text/csv", buffer: Buffer.from(text) });
    await saved(page);
    const other = await tab(page, hash);
    await choose(page, "alpha.csv", text(1));
    await page.getByRole("button", { name: "Remove alpha" }).waitFor();
    await choose(page, "same.csv", text(1.25));
    await page.getByRole("button", { name: "Remove same", exact: true }).waitFor();
    await saved(page);
    await choose(other, "beta.csv", text(2));
    await other.getByRole("button", { name: "Remove beta" }).waitFor();
    await choose(other, "same.csv", text(2.25));
    await other.getByRole("button", { name: "Remove same (2)" }).waitFor();
    await saved(other);
    for (const each of [page, other]) {
      await reload(each);
      for (const kept of ["alpha", "beta", "same", "same (2)"]) {
        await each.getByRole("button", { name: `Remove ${kept}`, exact: true }).waitFor();
      }
    }
  }, { hash, allowed: software });
}
