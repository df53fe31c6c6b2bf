// usage: node check_engines.mjs MIRRORBALL CHROMIUM FOLDER DOCUMENTATION
//
// Bakes an environment for each web engine, has the engine load it in Chromium by the lines of a page of the folder
// DOCUMENTATION and show a ball in it, and compares the ball's middle with the exact mean of the light there. Every
// direction has its own colour, so that a map that is turned or mirrored is found out too. Exit code 1, and one line a
// fault, where something differs or the console has a warning. FOLDER holds the pages and node_modules.

import { spawnSync } from 'node:child_process';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { openPage } from './browser_page.mjs';
import { linesUnder } from './documented_lines.mjs';
import { exactMean, knownLight, knownTexels, whiteRadiance, writeMaps } from './known_light.mjs';

const [mirrorball, browserPath, folder, documentation] = process.argv.slice(2);

// The six axes, and directions of no symmetry: towards the lamp, beside it, elsewhere.
const directions = [
  [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [0.5, 0.6, -0.62], [0.3, 0.8, -0.4],
  [-0.7, 0.2, 0.5], [0.6, -0.6, 0.3],
];

// The roughnesses are those of an engine's levels: between them it interpolates, and lobes are not linear. The largest
// difference that is allowed is a share of the exact colour's brightest channel. Right files differ by up to 5.0 %:
// around a lamp, where an engine interpolates between few texels, and by the few colours in a block of UASTC HDR. Three
// bands of harmonics are 6.1 % off behind the lamp.
const tolerance = 0.055;
const toleranceOfBands = 0.075;
const ofBabylon = [2, 3, 4, 5, 6].map((level) => Math.sqrt(2 ** (level / 0.8 - 8)));
const ofThree = [1, 2, 3, 4, 5].map((level) => 1 - Math.sqrt(1 - level / 5));
const ofFilament = { engine: 'Filament', file: 'room_ibl.ktx', page: 'engines/filament.md', heading: 'In a browser',
  roughnesses: [1, 2, 3, 4].map((level) => 1 - Math.sqrt(1 - level / 4)), showsBackground: true };
const engines = [
  { engine: 'three.js', bake: 'three', file: 'specular.ktx2', roughnesses: ofThree,
    wrong: ['--for opengl --format uastc_hdr', '--for three --mip-mapping linear --levels 6 --format uastc_hdr'] },
  { engine: 'three.js', bake: 'three --zstd 19', file: 'specular.ktx2', roughnesses: ofThree },
  { engine: 'three.js', bake: 'three --format half', file: 'specular.ktx2', roughnesses: ofThree,
    heading: 'Half floats in three.js' },
  { engine: 'three.js', bake: 'three --format bc6h', file: 'specular.ktx2', roughnesses: ofThree,
    heading: 'Half floats in three.js' },
  { engine: 'Babylon.js', bake: 'babylon', file: 'environment.env', roughnesses: ofBabylon },
  { engine: 'Babylon.js', bake: 'babylon', file: 'environment.dds', roughnesses: ofBabylon, isMattByBands: true },
  { engine: 'glTF', bake: 'gltf', file: 'environment.glb', isMattByBands: true,
    roughnesses: [1, 2, 3, 4, 5, 6].map((level) => Math.sqrt(256 ** (level / 6 - 1))) },
  { engine: 'PlayCanvas', bake: 'playcanvas', file: 'environment.png', roughnesses: [0.2, 0.4, 0.6, 0.8, 1] },
  { ...ofFilament, bake: 'filament', wrong: ['--for filament --mip-mapping linear'] },
];

function run(words) {
  const { status } = spawnSync(mirrorball, words, { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
  if (status === 0) return;
  console.error(`FAILED: mirrorball ${words.join(' ')}`);
  process.exit(1);
}

const linesOf = ({ engine, heading }) => `docs_${heading ?? engine}.mjs`;

/// Which colours an engine shows in a map that was baked with these options.
let maps = 0;
async function coloursIn(page, how, map, options, views) {
  const baked = `baked/${maps++}/room`;
  run(['bake', `${map}.pfm`, ...options.split(' '), '-o', `${baked}/`]);
  return page.evaluate((what) => window.coloursIn(...what),
    [how.engine, `/${baked}/${how.file}`, `/${linesOf(how)}`, views]);
}

/// The difference of a colour from the exact one.
function errorOf(seen, white, { direction, roughness, isBackground }) {
  const exact = isBackground ? knownLight(direction) : exactMean(knownTexels, direction, roughness ?? 1);
  const found = seen.map((light, c) => (light * whiteRadiance) / white[c]);
  return Math.max(...found.map((light, c) => Math.abs(light - exact[c]))) / Math.max(...exact);
}

const nameOf = ({ roughness, isBackground }) =>
  (isBackground ? 'background' : roughness === undefined ? 'matt' : `roughness ${roughness.toFixed(3)}`);

/// Returns the number of faults, after a line for each.
async function check(page, engine) {
  const rough = engine.roughnesses.map((roughness) => ({ roughness }));
  const views = [...rough, {}, ...(engine.showsBackground ? [{ isBackground: true }] : [])]
    .flatMap((surface) => directions.map((direction) => ({ direction, ...surface })));
  const white = await coloursIn(page, engine, 'white', `--for ${engine.bake}`, views);
  const errorsOf = async (options) => {
    const seen = await coloursIn(page, engine, 'light', options, views);
    return views.map((view, i) => errorOf(seen[i], white[i], view));
  };
  const name = `--for ${engine.bake}, ${engine.file}`;
  let faults = 0;
  const errors = await errorsOf(`--for ${engine.bake}`);
  const worst = new Map();
  views.forEach((view, i) => {
    worst.set(nameOf(view), Math.max(worst.get(nameOf(view)) ?? 0, errors[i]));
    const isByBands = engine.isMattByBands && nameOf(view) === 'matt';
    if (errors[i] < (isByBands ? toleranceOfBands : tolerance)) return;
    faults += 1;
    console.error(`FAILED: ${name}, ${nameOf(view)} towards ${view.direction}: ${(100 * errors[i]).toFixed(1)} %`);
  });
  console.log(`${name}: ${[...worst].map(([what, error]) => `${what} ${(100 * error).toFixed(2)} %`).join(', ')}`);
  for (const options of engine.wrong ?? []) {
    const most = Math.max(...await errorsOf(options));
    console.log(`${name} with ${options}: ${(100 * most).toFixed(1)} %`);
    if (most > 2 * tolerance) continue;
    faults += 1;
    console.error(`FAILED: ${name} with ${options} is not found out`);
  }
  return faults;
}

rmSync(join(folder, 'baked'), { recursive: true, force: true });
mkdirSync(join(folder, 'baked'));
writeMaps(join(folder, 'light.pfm'), join(folder, 'white.pfm'));
run(['export', 'sphere', '-o', 'ball.glb']);
let faults = 0;
for (const engine of engines) {
  const tell = (text) => {
    faults += 1;
    console.error(`FAILED: --for ${engine.bake}, console: ${text}`);
  };
  writeFileSync(join(folder, linesOf(engine)),
    linesUnder(join(documentation, engine.page ?? 'engines.md'), engine.heading ?? engine.engine));
  const page = await openPage(browserPath, folder, 'engines.html', tell, { warnings: true });
  await page.waitForFunction(() => window.coloursIn);
  faults += await check(page, engine);
  await page.context().browser().close();
}
console.log(`${engines.length} files, ${faults} faults`);
process.exit(faults > 0 ? 1 : 0);
