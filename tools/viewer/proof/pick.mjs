// node proof/pick.mjs PAGE.html [FOLDER]
// Opens a page of `flexkey pick` from its file, picks on it with every tool and writes what it offers to standard
// output, as JSON: [{tool, yaml, list, count}]; pictures go to the folder. Exits 1 with what is wrong.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { withBrowser } from './browser.mjs';

const [file, folder] = process.argv.slice(2);

async function offer(page, tool) {
  if (folder) await page.screenshot({ path: join(folder, `${tool}.png`) });
  const text = (id) => page.textContent(`#${id}`);
  return { tool, yaml: await text('yaml'), list: await text('list'), count: parseInt(await text('count'), 10) };
}

async function pickAll(page) {
  const box = await page.locator('#canvas').boundingBox();
  const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
  const offers = [];
  for (const [tool, radius] of [['point', 10], ['sphere', 20], ['geodesic', 14]]) {
    await page.click(`#${tool}`);
    await page.fill('#radius', String(radius));
    await page.mouse.click(...at(0.5, 0.5));
    offers.push(await offer(page, tool));
  }
  await page.click('#clear');
  assert.equal(await page.textContent('#yaml'), '');
  assert.equal(await page.isDisabled('#copy'), true);
  await page.click('#vertices');
  await page.mouse.move(...at(0.46, 0.5));
  await page.mouse.down();
  await page.mouse.move(...at(0.54, 0.54), { steps: 6 });
  await page.mouse.up();
  offers.push(await offer(page, 'vertices'));
  await page.keyboard.down('Shift');
  await page.mouse.click(...at(0.46, 0.5));
  await page.keyboard.up('Shift');
  offers.push(await offer(page, 'vertices'));
  assert.ok(offers.at(-1).count < offers.at(-2).count, 'Shift takes nothing off');
  await page.click('#copy');
  await page.waitForFunction(() => document.getElementById('copy').textContent === 'Copied');
  return offers;
}

/// A drag beside the mesh turns it: the same click then meets another place.
async function turns(page, before) {
  const box = await page.locator('#canvas').boundingBox();
  await page.click('#point');
  await page.mouse.move(box.x + 8, box.y + box.height - 8);
  await page.mouse.down();
  await page.mouse.move(box.x + 308, box.y + box.height - 8, { steps: 5 });
  await page.mouse.up();
  await page.waitForTimeout(500);
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  assert.notEqual(await page.textContent('#yaml'), before);
}

await withBrowser(async (browser) => {
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  const address = pathToFileURL(file).href, wrong = [];
  page.on('console', (message) => wrong.push(`${message.type()} on the console: ${message.text()}`));
  page.on('pageerror', (error) => wrong.push(`an exception: ${error.message}`));
  page.on('request', (request) => request.url() !== address && wrong.push(`a request: ${request.url()}`));
  await page.goto(address);
  await page.waitForSelector('#message', { state: 'hidden' });
  const offers = await pickAll(page);
  await turns(page, offers[0].yaml);
  assert.deepEqual(wrong.filter((message) => !/GPU stall due to ReadPixels/.test(message)), []);
  console.log(JSON.stringify(offers));
});
