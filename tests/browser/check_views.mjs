// usage: node check_views.mjs MIRRORBALL CHROMIUM FOLDER
//
// Has the program write maps of the built-in environment `uv` for three.js, has three.js show them in Chromium, and
// compares what is seen with the program's own pictures. Maps that are wrong on purpose must be found out, in the
// views that they spoil and in no other. Exit code 1, and one line a fault, where that is not so. FOLDER holds the page
// and node_modules; maps, pictures and contact sheets are left there.

import { spawnSync } from 'node:child_process';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { openPage } from './browser_page.mjs';

const [mirrorball, browserPath, folder] = process.argv.slice(2);
const side_px = 256;

// Each view must reach a peak signal-to-noise ratio [dB]. Measured with three.js 0.187 and 0.180 in SwiftShader:
//                    right maps     mirrored, turned, exchanged   half a texel aside
//   a face           34.5 or more   18.2 or less                  31.0 or less
//   mirror ball      33.9           20.1
//   prefiltered      29.6           20.1
// What right maps lose goes to filtering: letters and lines are averaged over the map's texels and interpolated between
// them, where our pictures have them sharp. The prefiltering blurs them once more.
const faceFloor_db = 33;
const ballFloor_db = 31;
const prefilteredFloor_db = 26;

// Where our camera stands, and where three.js' looks; docs/conventions.md says what is up in our picture.
const faceViews = [
  { name: '+X', camera: '270,0', direction: [1, 0, 0], up: [0, 1, 0] },
  { name: '-X', camera: '90,0', direction: [-1, 0, 0], up: [0, 1, 0] },
  { name: '+Y', camera: '180,-90', direction: [0, 1, 0], up: [0, 0, -1] },
  { name: '-Y', camera: '180,90', direction: [0, -1, 0], up: [0, 0, 1] },
  { name: '+Z', camera: '180,0', direction: [0, 0, 1], up: [0, 1, 0] },
  { name: '-Z', camera: '0,0', direction: [0, 0, -1], up: [0, 1, 0] },
].map((view) => ({ ...view, picture: `pictures/${view.name}.png`, floor_db: faceFloor_db }));
const ballPicture = 'pictures/ball.png';
const ballView =
  { name: 'mirror ball', material: 'MeshBasicMaterial', picture: ballPicture, floor_db: ballFloor_db };
// Looks the map up in levels that three.js has filtered, on a way of its own. That takes seconds a map.
const prefilteredView =
  { name: 'prefiltered ball', material: 'MeshStandardMaterial', picture: ballPicture, floor_db: prefilteredFloor_db };
const views = [...faceViews, ballView];
const allViews = [...views, prefilteredView];
const namesOf = (list) => list.map((view) => view.name);

function run(words) {
  const { status } = spawnSync(mirrorball, words.split(' '), { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
  if (status === 0) return;
  console.error(`FAILED: mirrorball ${words}`);
  process.exit(1);
}

function makePictures() {
  for (const { camera, picture } of faceViews)
    run(`render none -e uv --camera ${camera} --fov 90 --size ${side_px}x${side_px} --samples 64 ` +
      `--tone-map linear -o ${picture}`);
  run(`convert uv --to sphere --size ${side_px} -o ${ballPicture}`);
}

/// Six files, in the order in which three.js takes them.
function writeCube(name, extension, options = ' --for three') {
  run(`convert uv --to cube --layout faces --size ${side_px}${options} -o maps/${name}.${extension}`);
  return ['px', 'nx', 'py', 'ny', 'pz', 'nz'].map((face) => `maps/${name}_${face}.${extension}`);
}

function writePanorama(name, extension, options = ' --for three') {
  run(`convert uv --to equirect --size ${2 * side_px}${options} -o maps/${name}.${extension}`);
  return [`maps/${name}.${extension}`];
}

function exchanged(files, a, b) {
  const list = [...files];
  [list[a], list[b]] = [files[b], files[a]];
  return list;
}

/// A cube in one file, of blocks that three.js has made into what the browser's GPU takes.
function writeBlocks(name, options) {
  run(`convert uv --to cube --size ${side_px}${options} --format uastc_hdr -o maps/${name}.ktx2`);
  return [`maps/${name}.ktx2`];
}

/// What is to be shown, and in which views it must differ from our pictures. Of .ktx2 and .dds three.js 0.187 makes
/// cubes only where texels are compressed in blocks or have 8-bit channels.
function makeMaps() {
  const cube = writeCube('three', 'png');
  const panorama = writePanorama('three', 'png');
  const right = [
    { name: 'six png', files: cube, views: allViews },
    { name: 'six hdr', files: writeCube('three', 'hdr') },
    { name: 'ktx2', files: writeBlocks('three', ' --for three') },
    { name: 'ktx2 with levels', files: writeBlocks('three_levels', ' --for three --mips --zstd 3'), views: allViews },
    { name: 'panorama png', files: panorama },
    { name: 'panorama hdr', files: writePanorama('three', 'hdr') },
    { name: 'panorama exr', files: writePanorama('three', 'exr'), views: allViews },
  ];
  const all = namesOf(views);
  const sides = faceViews.filter(({ name }) => !name.endsWith('Y'));
  const ball = ballView.name;
  const wrong = [
    { name: 'six as OpenGL has them', files: writeCube('opengl', 'png', ''), views: allViews,
      differ: namesOf(allViews) },
    { name: 'ktx2 as OpenGL has it', files: writeBlocks('opengl', ''), differ: namesOf(views) },
    { name: 'px and nx exchanged', files: exchanged(cube, 0, 1), differ: ['+X', '-X', ball] },
    { name: 'py and ny exchanged', files: exchanged(cube, 2, 3), differ: ['+Y', '-Y', ball] },
    { name: 'pz mirrored', files: cube, damage: { image: 4, matrix: [-1, 0, 0, 1, 0, 0] }, differ: ['+Z', ball] },
    { name: 'py turned', files: cube, damage: { image: 2, matrix: [0, 1, -1, 0, 0, 0] }, differ: ['+Y', ball] },
    { name: 'nz half a texel aside', files: cube, damage: { image: 5, matrix: [1, 0, 0, 1, 0.5, 0] }, differ: ['-Z'] },
    { name: 'panorama around +Z', files: writePanorama('opengl', 'png', ''), differ: all },
    { name: 'panorama mirrored', files: panorama, damage: { matrix: [-1, 0, 0, 1, 0, 0] }, differ: all },
    { name: 'panorama half a texel aside', files: panorama, damage: { matrix: [1, 0, 0, 1, 0.5, 0] }, views: sides,
      differ: namesOf(sides) },
  ];
  return [...right, ...wrong].map((map) => ({ views, differ: [], ...map }));
}

/// Returns the number of faults, after a line for each.
async function check(page, map) {
  const { psnrs_db, sheet } = await page.evaluate((what) => window.compareViews(what), map);
  const path = join(folder, 'sheets', `${map.name.replaceAll(' ', '_')}.png`);
  writeFileSync(path, Buffer.from(sheet.split(',')[1], 'base64'));
  console.log(`${map.name}: ${psnrs_db.map((psnr, i) => `${map.views[i].name} ${psnr.toFixed(1)}`).join(', ')} dB`);
  let faults = 0;
  map.views.forEach(({ name, floor_db }, i) => {
    const mustDiffer = map.differ.includes(name);
    if (psnrs_db[i] >= floor_db === !mustDiffer) return;
    faults += 1;
    const expected = mustDiffer ? `less than ${floor_db} of a map that is wrong there` : `at least ${floor_db}`;
    console.error(`FAILED: ${map.name}, ${name}: ${psnrs_db[i].toFixed(1)} dB, expected ${expected}`);
  });
  if (faults > 0) console.error(`  ours | three.js' | difference x 8: ${path}`);
  return faults;
}

for (const name of ['maps', 'pictures', 'sheets']) {
  rmSync(join(folder, name), { recursive: true, force: true });
  mkdirSync(join(folder, name));
}
makePictures();
const maps = makeMaps();
const page = await openPage(browserPath, folder, 'views.html', (text) => console.error(text));
await page.waitForFunction(() => window.compareViews);
let faults = 0;
for (const map of maps) faults += await check(page, map);
await page.context().browser().close();
console.log(`${maps.length} maps, ${faults} faults`);
process.exit(faults > 0 ? 1 : 0);
