// node proof/page.mjs CASE PAGE.html [FOLDER]
// Opens a page from its file and checks one thing of it; pictures go to the folder. Exits 1 with what is wrong.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { withBrowser } from './browser.mjs';

const shown = '#timeline[aria-valuetext]';
const frameOf = (page) => page.getAttribute('#timeline', 'aria-valuenow').then(Number);

async function press(page, key, times = 1) {
  for (let i = 0; i < times; ++i) await page.keyboard.press(key);
}

/// Two pictures of the page's last state have been drawn, so that a screenshot shows it.
const settle = (page) => page.evaluate(() => new Promise((done) => {
  let left = 3;
  const wait = () => (--left > 0 ? requestAnimationFrame(wait) : done());
  requestAnimationFrame(wait);
}));

/// The share of pixels that differ clearly between two PNGs, counted by the browser.
async function difference(page, one, other) {
  return page.evaluate(async (pictures) => {
    const [a, b] = await Promise.all(pictures.map(async (base64) => {
      const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))]));
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
    }));
    let different = 0;
    for (let i = 0; i < a.length; i += 4) {
      different += [0, 1, 2].some((channel) => Math.abs(a[i + channel] - b[i + channel]) > 12);
    }
    return different / (a.length / 4);
  }, [one, other].map((png) => png.toString('base64')));
}

async function picture(page, name) {
  await settle(page);
  return page.locator('#stage').screenshot(folder ? { path: join(folder, `${name}.png`) } : {});
}

const cases = {
  /// Plays by itself, again from the start after the end, and stops for a space.
  async plays(page) {
    await page.waitForFunction(() => Number(document.getElementById('timeline').ariaValueNow) >= 3);
    const last = Number(await page.getAttribute('#timeline', 'aria-valuemax'));
    await page.waitForFunction((end) => {
      const now = Number(document.getElementById('timeline').ariaValueNow);
      window.wasLate ||= now > end / 2;
      return window.wasLate && now < end / 2;
    }, last);
    await press(page, ' ');
    const paused = await frameOf(page);
    await settle(page);
    assert.equal(await frameOf(page), paused);
    assert.equal(await page.getAttribute('#play', 'aria-label'), 'Play');
  },

  /// Keys step by a frame, and a press on the time line goes where it is.
  async scrubs(page) {
    const last = Number(await page.getAttribute('#timeline', 'aria-valuemax'));
    await press(page, ' ');
    await press(page, 'Home');
    await press(page, 'ArrowRight', 3);
    await press(page, 'ArrowLeft');
    await settle(page);
    assert.equal(await frameOf(page), 2);
    await press(page, 'End');
    await press(page, 'ArrowRight');
    await settle(page);
    assert.equal(await frameOf(page), last);
    const box = await page.locator('#ruler').boundingBox();
    await page.mouse.click(box.x + box.width / 4, box.y + 4);
    await settle(page);
    assert.equal(await frameOf(page), Math.round(last / 4));
    assert.match(await page.textContent('#readout'), new RegExp(`frame ${Math.round(last / 4)} / ${last}`));
  },

  /// Shows a mesh that changes from one of four frames to the next, its lines and its handles.
  async draws(page) {
    const last = Number(await page.getAttribute('#timeline', 'aria-valuemax'));
    await press(page, ' ');
    await press(page, 'h');
    const pictures = [];
    for (const third of [0, 1, 2, 3]) {
      await press(page, 'Home');
      await press(page, 'ArrowRight', Math.round((third * last) / 3));
      pictures.push(await picture(page, `frame_${Math.round((third * last) / 3)}`));
    }
    await press(page, 'w');
    const wires = await picture(page, 'wireframe');
    await press(page, 'w');
    await press(page, 'h');
    const handles = await picture(page, 'handles');
    await press(page, 'h');
    await page.addStyleTag({ content: '#canvas { visibility: hidden }' });
    const empty = await picture(page, 'empty');
    for (const [i, one] of pictures.entries()) {
      assert.ok((await difference(page, one, empty)) > 0.05, `picture ${i} shows no mesh`);
      for (const [j, other] of pictures.slice(0, i).entries()) {
        assert.ok((await difference(page, one, other)) > 0.001, `pictures ${j} and ${i} show the same`);
      }
    }
    assert.ok((await difference(page, wires, pictures[3])) > 0.02, 'no wireframe');
    assert.ok((await difference(page, handles, pictures[3])) > 0.0005, 'no handles');
  },

  /// Says what is missing, and nothing else.
  async lacksWebGL(page) {
    await page.waitForSelector('#message:visible');
    assert.match(await page.textContent('#message'), /draws with WebGL 2, which this browser does not have/);
    assert.equal(await page.isVisible('#dock'), false);
  },

  /// Names with markup in them are text, in the title as well as on the stage.
  async isHarmless(page) {
    const name = '</script><script>alert(1)</script><!--';
    assert.equal(await page.title(), name);
    assert.equal(await page.textContent('#name'), name);
    assert.equal(await page.textContent('#labels'), '<img src=x onerror=alert(2)>]]>');
    assert.equal(await page.locator('script').count(), 3);
    assert.equal(await page.locator('img').count(), 0);
  },

  /// Each clip has its own frames.
  async choosesClips(page) {
    const ends = [];
    for (const [value] of (await page.locator('#clips option').all()).entries()) {
      await page.selectOption('#clips', String(value));
      await press(page, 'End');
      await settle(page);
      ends.push(await page.textContent('#readout'));
    }
    assert.deepEqual(await page.locator('#clips option').allTextContents(), ['first', 'second']);
    assert.match(ends[0], /frame 12 \/ 12\s+0\.50 s\s+λ 0\.62/);
    assert.match(ends[1], /frame 24 \/ 24\s+0\.60 s\s+λ 0\.74/);
  },

  /// Everything that one may press lies in the picture, on a desktop, a small laptop and a phone.
  async fits(page) {
    await press(page, ' ');
    for (const [width, height] of [[1920, 1080], [1280, 720], [390, 844], [844, 390], [320, 568]]) {
      await page.setViewportSize({ width, height });
      await settle(page);
      await page.screenshot(folder ? { path: join(folder, `${width}x${height}.png`) } : {});
      for (const one of await page.locator('button, select, #timeline, #name, #readout').all()) {
        if (!(await one.isVisible())) continue;
        const box = await one.boundingBox();
        const isInside = box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height;
        assert.ok(isInside, `${await one.evaluate((element) => element.id)} at ${width} x ${height}`);
      }
      assert.ok((await page.locator('#canvas').boundingBox()).height > height / 3, `stage at ${width} x ${height}`);
    }
  },
};

async function check(browser) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  const address = pathToFileURL(file).href;
  const wrong = [];
  page.on('console', (message) => wrong.push(`${message.type()} on the console: ${message.text()}`));
  page.on('pageerror', (error) => wrong.push(`an exception: ${error.message}`));
  page.on('dialog', (dialog) => wrong.push(`a dialog: ${dialog.message()}`) && dialog.dismiss());
  page.on('request', (request) => {
    if (request.url() !== address && !/^(blob|data):/.test(request.url())) wrong.push(`a request: ${request.url()}`);
  });
  await page.goto(address);
  if (name !== 'lacksWebGL') await page.waitForSelector(shown, { timeout: 120_000 });
  await cases[name](page);
  // Chromium's software renderer remarks on being read back by a screenshot.
  assert.deepEqual(wrong.filter((message) => !/GPU stall due to ReadPixels/.test(message)), []);
}

const [name, file, folder] = process.argv.slice(2);
if (!(name in cases) || !file) {
  console.error(`usage: node page.mjs ${Object.keys(cases).join('|')} PAGE.html [FOLDER]`);
  process.exit(2);
}
await withBrowser(check, name === 'lacksWebGL' ? ['--disable-3d-apis'] : []);
