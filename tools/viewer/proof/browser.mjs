// Debian's Chromium, headless, drawing with its software renderer so that no graphics card is needed.
import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

const program = process.env.CHROMIUM ?? '/usr/bin/chromium';

/// Runs `use(browser)` and closes the browser whatever happens. `flags` are further ones of Chromium.
export async function withBrowser(use, flags = []) {
  if (!existsSync(program)) throw new Error(`no Chromium at ${program} (Debian package chromium, or $CHROMIUM)`);
  const browser = await chromium.launch({
    executablePath: program,
    args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox', '--disable-dev-shm-usage', ...flags],
  });
  try {
    return await use(browser);
  } finally {
    await browser.close();
  }
}
