// Card of the vehicle: tabs, section, three dimensions, mass tree, files.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { assertAccessible, pageTest } from "./harness.mjs";

/** Messages of a browser without a graphics processor about software rendering and reading of pixels. */
const software = /software WebGL|GPU stall due to ReadPixels|GL Driver Message/;

const fresh = async (page) => {
  await page.locator(".headline .freshness", { hasText: "up to date" }).waitFor();
  await page.locator(".legend tfoot td").last().waitFor();
};
const tab = (page, name) => page.getByRole("tab", { name, exact: true });
const stage = (page) => page.getByRole("application", { name: /^Vehicle in three dimensions/ });
const cut = (page) => page.getByRole("slider", { name: "Cut open" });

async function open3d(page) {
  await fresh(page);
  await tab(page, "3-D").click();
  await loaded(page, 0);
}

/** Waits until more than `count` vehicles have been uploaded for drawing and the newest is displayed. */
async function loaded(page, count) {
  await page.waitForFunction((count) => Number(document.querySelector(".frame-3d canvas")?.dataset.loads) > count, count);
  await settled(page);
}
const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const loads = (page) => page.locator(".frame-3d canvas").evaluate((canvas) => Number(canvas.dataset.loads));

/** Content of the canvas: fraction that is not background, number of colors, and a hash of the picture. */
async function picture(page) {
  await settled(page);
  return pixels(page, (await page.locator(".frame-3d").screenshot()).toString("base64"));
}

/** Decodes a PNG in the page through an image element, which the content security policy allows. */
function pixels(page, png) {
  return page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    const ground = data.slice(4 * (10 * canvas.width + 10), 4 * (10 * canvas.width + 10) + 3);
    const colors = new Set();
    let [drawn, sum] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      const far = [0, 1, 2].some((k) => Math.abs(data[i + k] - ground[k]) > 12);
      drawn += far;
      sum = (sum * 31 + data[i] + 3 * data[i + 1] + 7 * data[i + 2]) % 1_000_003;
      colors.add(`${data[i] >> 4} ${data[i + 1] >> 4} ${data[i + 2] >> 4}`);
    }
    return { drawn: drawn / (canvas.width * canvas.height), colors: colors.size, sum };
  }, png);
}

pageTest("the tabs are moved along by arrow keys", async (page) => {
  await fresh(page);
  await tab(page, "Section").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await tab(page, "3-D").getAttribute("aria-selected"), "true");
  await page.waitForFunction(() => document.activeElement?.id === "tab-view-3d");
  await page.keyboard.press("End");
  await page.getByRole("tabpanel", { name: await page.evaluate(() => document.activeElement.textContent) }).waitFor();
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => document.activeElement?.id === "tab-section");
  await page.getByRole("img", { name: /^Section of the vehicle/ }).waitFor();
  assert.equal(await page.locator('[role="tab"][tabindex="0"]').count(), 1, "one tab stop");
}, { allowed: software });

pageTest("the view in three dimensions follows the inputs, turns, and is cut open", async (page) => {
  await open3d(page);
  const first = await picture(page);
  assert.ok(first.drawn > 0.1 && first.colors > 12, `a vehicle is seen: ${JSON.stringify(first)}`);

  const before = await loads(page);
  await page.getByLabel("Nose Radius / Vehicle Radius", { exact: true }).fill("0.6");
  await page.keyboard.press("Tab");
  await loaded(page, before);
  await fresh(page);
  const blunter = await picture(page);
  assert.notEqual(blunter.sum, first.sum, "another nose, another picture");

  await stage(page).focus();
  await page.keyboard.press("Home");
  const fitted = await picture(page);
  await page.keyboard.press("ArrowLeft");
  const turned = await picture(page);
  assert.notEqual(turned.sum, fitted.sum, "an arrow key turns");
  await page.keyboard.press("Home");
  assert.equal((await picture(page)).sum, fitted.sum, "Home brings the same view back");

  await cut(page).fill("0");
  const whole = await picture(page);
  await cut(page).fill("180");
  const half = await picture(page);
  assert.ok(half.colors > whole.colors, `inside there are more colors: ${whole.colors}, then ${half.colors}`);
  await page.getByRole("textbox", { name: "Cut open, degrees" }).fill("400");
  await page.keyboard.press("Tab");
  assert.equal(await cut(page).inputValue(), "270", "no further than it goes");
}, { allowed: software });

pageTest("a component is hidden, and one is named by a click on it", async (page) => {
  await open3d(page);
  await page.getByRole("button", { name: "Side", exact: true }).click();
  await cut(page).fill("180");
  const all = await picture(page);
  await page.getByRole("checkbox", { name: "Show Body foam" }).uncheck();
  assert.notEqual((await picture(page)).sum, all.sum);
  await page.getByRole("checkbox", { name: "Show Body foam" }).check();
  // the payload is in the middle of the half-section
  const box = await stage(page).boundingBox();
  await page.mouse.click(box.x + 0.5 * box.width + 8, box.y + 0.5 * box.height);
  await page.locator(".part-detail h3").waitFor();
  const name = await page.locator(".part-detail h3").innerText();
  assert.ok(["Payload", "Impact foam"].includes(name), name);
  await page.locator(".part-detail", { hasText: "Material" }).waitFor();
}, { allowed: software });

pageTest("heat flux has a scale with its unit, materials have their names", async (page) => {
  await open3d(page);
  const panel = page.getByRole("tabpanel", { name: "3-D" });
  const by_component = await picture(page);
  await panel.getByRole("radio", { name: "Heat flux" }).check();
  await panel.getByRole("img", { name: /^Scale of colors from 0 to [\d.]+ W\/cm²/ }).waitFor();
  const by_flux = await picture(page);
  assert.notEqual(by_flux.sum, by_component.sum);
  await panel.getByRole("radio", { name: "Material" }).check();
  assert.ok((await panel.getByRole("list", { name: "Colors of materials" }).getByRole("listitem").count()) >= 4);
}, { allowed: software });

pageTest("the view is saved as an image", async (page) => {
  await open3d(page);
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "PNG", exact: true }).click()]);
  assert.match(download.suggestedFilename(), /-3d\.png$/);
  const bytes = await readFile(await download.path());
  assert.equal(bytes.subarray(1, 4).toString("latin1"), "PNG");
  assert.ok((await pixels(page, bytes.toString("base64"))).drawn > 0.1, "the vehicle is in it");
}, { allowed: software });

pageTest("the wheel scrolls the page until the view has the focus", async (page) => {
  await open3d(page);
  const box = await stage(page).boundingBox();
  await page.mouse.move(box.x + 50, box.y + 50);
  const before = await picture(page);
  await page.mouse.wheel(0, -100);
  assert.equal((await picture(page)).sum, before.sum);
  await stage(page).focus();
  await page.mouse.wheel(0, -100);
  await page.locator(".stage .reading", { hasText: "magnified 1.2 times" }).waitFor();
}, { allowed: software });

pageTest("a context that is lost and restored shows the vehicle again", async (page) => {
  await open3d(page);
  const before = await picture(page);
  const count = await loads(page);
  await page.locator(".frame-3d canvas").evaluate(async (canvas) => {
    const extension = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    const lost = new Promise((done) => canvas.addEventListener("webglcontextlost", done));
    extension.loseContext();
    await lost;
    // restored only after the event has been handled
    setTimeout(() => extension.restoreContext(), 50);
  });
  await loaded(page, count);
  assert.equal((await picture(page)).sum, before.sum);
}, { allowed: /software WebGL|GPU stall|GL Driver Message|CONTEXT_LOST/ });

pageTest("without WebGL the view says so, and the section stays", async (page) => {
  await page.addInitScript(() => {
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind === "webgl2" ? null : original.call(this, kind, ...rest);
    };
  });
  await page.reload();
  await page.locator("#skeleton").waitFor({ state: "detached" });
  await fresh(page);
  await tab(page, "3-D").click();
  await page.getByText(/Nothing can be shown in three dimensions/).waitFor();
  await tab(page, "Section").click();
  await page.getByRole("img", { name: /^Section of the vehicle/ }).waitFor();
});

pageTest("the mass tree adds up, with the margin once", async (page) => {
  await fresh(page);
  await tab(page, "Mass tree").click();
  const table = page.getByRole("region", { name: "Mass tree" });
  const masses = (part) => table.locator(`${part} tr`).evaluateAll((rows) =>
    rows.map((row) => [row.cells[0].textContent.trim(), Number(row.querySelector("td.value").textContent)]));
  const sum = (rows) => rows.reduce((total, [, mass]) => total + mass, 0);
  const [components, foot] = [await masses("tbody"), Object.fromEntries(await masses("tfoot"))];
  assert.ok(components.length >= 9, `${components.length} components`);
  // each of the numbers is rounded to five digits
  const near = (got, want) => assert.ok(Math.abs(got / want - 1) < 2e-4, `${got} against ${want}`);
  near(sum(components), foot["Sum without margin"]);
  near(foot["Sum without margin"] + foot.Margin, foot["Total at entry"]);
  assert.ok(foot.Margin > 0);
});

pageTest("a vehicle that does not close leaves the last one in view and says what does not fit", async (page) => {
  await open3d(page);
  const before = await picture(page);
  const ratio = page.getByRole("textbox", { name: "Payload Diameter / Vehicle Diameter" });
  await ratio.fill("0.95");
  await page.keyboard.press("Tab");
  await page.locator(".panel-vehicle .reason", { hasText: "This is the last vehicle that closed" }).waitFor();
  assert.ok((await picture(page)).drawn > 0.5 * before.drawn, "it is still there");
  await page.locator("#in-design-payload_diameter_ratio-fault", { hasText: /At 1\.000 m .*crosses/ }).waitFor();
  await page.locator("#in-design-diameter_m-fault", { hasText: /At 1\.000 m/ }).waitFor();
}, { allowed: software, hash: "#/design?p=run-page" });

for (const colorScheme of ["light", "dark"]) {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 360, height: 740 }]) {
    pageTest(`every tab is accessible in ${colorScheme} at ${viewport.width} px`, async (page) => {
      await open3d(page);
      for (const name of ["3-D", "Mass tree", "Section"]) {
        await tab(page, name).click();
        if (name === "3-D") {
          await page.getByRole("tabpanel", { name: "3-D" }).getByRole("radio", { name: "Heat flux" }).check();
        }
        await assertAccessible(page);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.equal(overflow, 0, `${name}: nothing is wider than the screen`);
      }
    }, { context: { colorScheme, viewport }, allowed: software });
  }
}
