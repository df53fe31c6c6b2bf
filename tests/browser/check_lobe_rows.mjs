// usage: node check_lobe_rows.mjs MIRRORBALL CHROMIUM FOLDER PAGE MODULE
//
// Has three.js show balls by rows of lobes (MODULE, examples/three/lobe_rows.mjs), by the lines of the documentation
// (PAGE), and by its own single look-up of the same map. Compares both with the sum over all texels of the environment
// under the exact lobe, for n·v from 0.15 to 1. Exit code 1, and one line a fault, where the rows are not so near as
// they should be, or the console has a warning.

import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import { openPage } from './browser_page.mjs';
import { linesUnder } from './documented_lines.mjs';
import { exactLobe, exactMean, exactReflection, knownTexels, whiteRadiance, writeMaps } from './known_light.mjs';

const [mirrorball, browserPath, folder, documentation, module] = process.argv.slice(2);

const surfaces = [
  { surface: 'whiteMetal', f0: 1, roughnesses: [0.3, 0.6, 0.9] },
  { surface: 'blackPlastic', f0: 0.04, roughnesses: [0.3, 0.6, 0.9] },
  { surface: 'coat', f0: 0.04, isCoat: true, roughnesses: [0.6] },
];
// What is allowed of the RMS error that three.js' own look-up has, and of the light itself.
const mostOfOwn = 0.5;
const mostError = 0.05;
const cosines = [0.15, 0.25, 0.4, 0.55, 0.7, 0.85, 1];

// Places of the ball around two directions to the eye: to one side of the lamp, and away from it. About each cosine
// they are evenly spread.
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const normalized = (v) => v.map((one) => one / Math.hypot(...v));
const perCosine = 6;
const places = [[0.9, 0.1, -0.3], [-0.4, 0.5, 0.7]].map(normalized).flatMap((direction) => {
  const across = normalized(cross(direction, [0, 1, 0]));
  const upwards = cross(across, direction);
  return cosines.flatMap((cosine) => Array.from({ length: perCosine }, (_, i) => {
    const angle = (2 * Math.PI * (i + 0.5)) / perCosine;
    const sine = Math.sqrt(1 - cosine * cosine);
    const normal = direction.map((one, c) =>
      cosine * one + sine * (Math.cos(angle) * across[c] + Math.sin(angle) * upwards[c]));
    return { direction, normal };
  }));
});
const views = surfaces.flatMap(({ surface, roughnesses }) =>
  roughnesses.flatMap((roughness) => places.map((place) => ({ ...place, surface, roughness }))));
const irradiances = places.map(({ normal }) => exactMean(knownTexels, normal, 1));
const lobes = new Map(surfaces[0].roughnesses.map((roughness) =>
  [roughness, places.map(({ normal, direction }) => exactLobe(knownTexels, normal, direction, roughness))]));

/// The light of all places of a ball in a list.
const truthOf = (surface, roughness) =>
  places.flatMap((_, i) => exactReflection(lobes.get(roughness)[i], irradiances[i], surface));

let faults = 0;
function fail(text) {
  faults += 1;
  console.error(`FAILED: ${text}`);
}

function bake(map) {
  const words = ['bake', `${map}.pfm`, '--for', 'three', '-o', `rows/${map}/`];
  const { status } = spawnSync(mirrorball, words, { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
  if (status !== 0) process.exit(1);
}

/// What the balls show of a map, by a module of lines from the documentation.
async function seenIn(map, lines) {
  const tell = (text) => fail(`console: ${text}`);
  const page = await openPage(browserPath, folder, 'engines.html', tell, { warnings: true });
  await page.waitForFunction(() => window.coloursIn);
  const seen = await page.evaluate((what) => window.coloursIn(...what),
    ['three.js', `/rows/${map}/specular.ktx2`, `/${lines}`, views]);
  await page.context().browser().close();
  return seen;
}

/// The light that is seen, as a share of what the surface shows of even light.
async function reflectionsBy(lines) {
  const white = await seenIn('white', lines);
  const seen = await seenIn('light', lines);
  return seen.map((colour, i) => colour.map((light, c) => (light * whiteRadiance) / white[i][c]));
}

/// The RMS of the differences over that of the truth.
function errorOf(seen, truth) {
  const rms = (numbers) => Math.sqrt(numbers.reduce((sum, number) => sum + number ** 2, 0) / numbers.length);
  return rms(seen.map((light, i) => light - truth[i])) / rms(truth);
}

/// Whether rows of lobes are as near as they should be.
function compare({ surface, ...what }, roughness, own, rows) {
  const isOfBall = (_, i) => views[i].surface === surface && views[i].roughness === roughness;
  const truth = truthOf(what, roughness);
  const [before, after] = [own, rows].map((seen) => errorOf(seen.filter(isOfBall).flat(), truth));
  const percent = (error) => `${(100 * error).toFixed(1)} %`;
  const text = `${surface} of roughness ${roughness}: ${percent(after)}, by a single look-up ${percent(before)}`;
  console.log(text);
  if (after > mostOfOwn * before || after > mostError) fail(text);
}

/// What a material does to its shader stays, and materials that do different things have different programs.
async function checkOwnChanges() {
  const { MeshStandardMaterial, ShaderLib } = await import('three');
  const { useLobeRows } = await import(join(folder, basename(module)));
  const rows = { image: { width: 96, height: 24 } };
  const material = new MeshStandardMaterial();
  const other = new MeshStandardMaterial();
  material.onBeforeCompile = (shader) => { shader.fragmentShader += '// ours'; };
  other.onBeforeCompile = (shader) => { shader.fragmentShader = ''; };
  for (const one of [material, material, other]) useLobeRows(one, rows);
  if (material.customProgramCacheKey() === other.customProgramCacheKey()) fail('different shaders have one key');
  const shader = { uniforms: {}, fragmentShader: ShaderLib.standard.fragmentShader };
  material.onBeforeCompile(shader);
  if (shader.fragmentShader.split('uniform sampler2D lobeRows;').length !== 2) fail('no rows, or two of them');
  if (!shader.fragmentShader.endsWith('// ours')) fail('what a material does itself is lost');
  try {
    other.onBeforeCompile(shader);
    fail('a shader without the part that rows replace is not told of');
  } catch (error) {
    if (!error.message.includes('the shader lacks "#include')) fail(`of a missing part: ${error.message}`);
  }
}

mkdirSync(join(folder, 'rows'), { recursive: true });
writeMaps(join(folder, 'light.pfm'), join(folder, 'white.pfm'));
['light', 'white'].forEach(bake);
copyFileSync(module, join(folder, basename(module)));
await checkOwnChanges();
const ownLines = linesUnder(documentation, 'three.js');
writeFileSync(join(folder, 'docs_own.mjs'), ownLines);
writeFileSync(join(folder, 'docs_rows.mjs'), ownLines + linesUnder(documentation, 'Rows of lobes in three.js'));
const own = await reflectionsBy('docs_own.mjs');
const rows = await reflectionsBy('docs_rows.mjs');
for (const what of surfaces) for (const roughness of what.roughnesses) compare(what, roughness, own, rows);
rmSync(join(folder, 'rows'), { recursive: true });
process.exit(faults > 0 ? 1 : 0);
