// node proof/play.mjs FILE.glb ANIMATION TIMES.json OUT.f32
// Plays an animation of a GLB with three.js's own loader and mixer in a browser, and writes where every vertex
// is at each time of the list (seconds): #times x #vertices x 3 little-endian floats, the vertices of the
// primitives one after another. Prints the animation's length.
import { open, readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { withBrowser } from './browser.mjs';

const here = dirname(fileURLToPath(import.meta.url));

async function bundledPlayer() {
  const result = await build({
    entryPoints: [join(here, 'player.js')],
    bundle: true,
    format: 'iife',
    globalName: 'player',
    write: false,
    logLevel: 'error',
  });
  return result.outputFiles[0].text;
}

async function play(page, [glb, animation, times, out]) {
  await page.addScriptTag({ content: await bundledPlayer() });
  const length = await page.evaluate(
    ([bytes, name]) => player.load(bytes, name), [(await readFile(glb)).toString('base64'), animation]);
  const file = await open(out, 'w');
  for (const time of JSON.parse(await readFile(times, 'utf8'))) {
    const positions = await page.evaluate((at) => player.positionsAt(at), time);
    await file.write(Buffer.from(positions, 'base64'));
  }
  await file.close();
  console.log(length);
}

const paths = process.argv.slice(2);
if (paths.length !== 4) {
  console.error('usage: node play.mjs FILE.glb ANIMATION TIMES.json OUT.f32');
  process.exit(2);
}
await withBrowser(async (browser) => play(await browser.newPage(), paths));
