// usage: node check_gain_maps.mjs MIRRORBALL CHROMIUM FOLDER
//
// Has readers that others have written read, in Chromium, an Ultra HDR panorama of ours, and compares each texel's
// light with what it was made of. Then gainmap-js writes one, and we read it. Exit code 1, and one line a fault, where
// light differs. FOLDER holds the page and node_modules.

import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { openPage } from './browser_page.mjs';
import { writeMaps } from './known_light.mjs';

const [mirrorball, browserPath, folder] = process.argv.slice(2);

// The largest mean error of a texel's light that is allowed, as a share of it. Right files are off by 0.4 % in
// gainmap-js. three.js' loader multiplies codes of sRGB where the formula has light: it is off by 1 % where the picture
// is the light up to white, and by 8 % under ACES.
const readers = [
  { reader: 'gainmap-js', tolerance: 0.01 },
  { reader: 'three.js', tolerance: 0.1 },
];

function run(...words) {
  return execFileSync(mirrorball, words, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });
}

/// A PFM's texels, row after row from the top, with alpha.
function readPfm(path) {
  const bytes = readFileSync(path);
  const header = bytes.toString('latin1', 0, 64).match(/^PF\n(\d+) (\d+)\n-1.0\n/);
  const [width, height, begin] = [Number(header[1]), Number(header[2]), header[0].length];
  const texels = [];
  for (let y = height - 1; y >= 0; --y)
    for (let x = 0; x < width; ++x) {
      for (let c = 0; c < 3; ++c) texels.push(bytes.readFloatLE(begin + 4 * (3 * (y * width + x) + c)));
      texels.push(1);
    }
  return { width, height, texels };
}

/// The mean of the errors of texels' green light, each as a share of that light.
function meanError(found, { width, height, texels }) {
  let sum = 0;
  for (let i = 1; i < texels.length; i += 4) sum += Math.abs(found[i] / texels[i] - 1);
  return sum / (width * height);
}

let faults = 0;
function expectBelow(error, tolerance, what) {
  console.log(`${what}: mean error ${(100 * error).toFixed(2)} %`);
  if (error < tolerance) return;
  faults += 1;
  console.error(`FAILED: ${what}: ${(100 * error).toFixed(2)} %, ${(100 * tolerance).toFixed(0)} % allowed`);
}

const tell = (text) => {
  faults += 1;
  console.error(`FAILED: console: ${text}`);
};
writeMaps(join(folder, 'light.pfm'), join(folder, 'white.pfm'));
const light = readPfm(join(folder, 'light.pfm'));
// Every tone map is undone by its gain map.
for (const toneMap of ['linear', 'aces'])
  run('convert', 'light.pfm', '--gain-map', '--tone-map', toneMap, '-o', `${toneMap}.jpg`);
run('convert', 'light.pfm', '--gain-map', '--rotate', '90', '-o', 'turned.jpg');

const page = await openPage(browserPath, folder, 'gain_maps.html', tell);
await page.waitForFunction(() => window.writeByGainMapJs);
const errorOf = async (reader, file) =>
  meanError(await page.evaluate(([name, url]) => window.readers[name](url), [reader, `/${file}`]), light);
for (const { reader, tolerance } of readers) {
  for (const toneMap of ['linear', 'aces'])
    expectBelow(await errorOf(reader, `${toneMap}.jpg`), tolerance, `${reader} reads ${toneMap}.jpg`);
  // A check that cannot fail would be none.
  const turned = await errorOf(reader, 'turned.jpg');
  console.log(`${reader} reads a turned map: ${(100 * turned).toFixed(1)} %`);
  if (turned > 1.5 * tolerance) continue;
  faults += 1;
  console.error(`FAILED: ${reader}: a turned map is not found out`);
}

const { width, height, texels } = light;
const written = await page.evaluate((what) => window.writeByGainMapJs(...what), [width, height, texels]);
await page.context().browser().close();
writeFileSync(join(folder, 'theirs.jpg'), Buffer.from(written));
const directions = [[1, 0.2, 0.1], [-1, 0.3, 0.2], [0.1, 1, 0.2], [0.2, 0.1, 1], [-0.3, 0.2, -1], [-0.5, -0.6, 0.4]];
const greenOf = (map, direction) =>
  Number(run('info', map, '--direction', direction.join()).match(/^\s*radiance\s+\S+\s+(\S+)/m)[1]);
for (const direction of directions) {
  const [right, found] = [greenOf('light.pfm', direction), greenOf('theirs.jpg', direction)];
  expectBelow(Math.abs(found / right - 1), 0.06, `we read gainmap-js' file towards ${direction}`);
}
process.exit(faults > 0 ? 1 : 0);
