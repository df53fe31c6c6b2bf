// A page in Chromium that reads the files of one folder and nothing else.

import { join } from 'node:path';

import { chromium } from 'playwright-core';

// A driver in software stalls when pixels are read. That is no fault of a page.
const isAboutDriver = (text) => text.includes('GPU stall due to ReadPixels');

/// Opens a page of the folder: there is no network behind it.
///
/// tell     called with each error or, if `warnings`, warning of its console
export async function openPage(browserPath, folder, name, tell, { warnings = false } = {}) {
  const browser = await chromium.launch({
    executablePath: browserPath,
    args: ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox'],
  });
  const page = await browser.newPage();
  const isTold = (message) => message.type() === 'error' || (warnings && message.type() === 'warning');
  page.on('console', (message) => isTold(message) && !isAboutDriver(message.text()) && tell(message.text()));
  page.on('pageerror', (error) => tell(error.message));
  await page.route('**', (route) => {
    const { pathname } = new URL(route.request().url());
    return route.fulfill({ path: join(folder, decodeURIComponent(pathname)) });
  });
  await page.goto(`http://mirrorball.test/${name}`);
  return page;
}
