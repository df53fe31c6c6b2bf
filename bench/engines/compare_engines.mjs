// usage: node compare_engines.mjs PROGRAM CHROMIUM FOLDER DOCUMENTATION [MODEL.glb…] PANORAMA.hdr…
//
// What engines.sh does once npm's packages are there. The lines of DOCUMENTATION's pages load what we baked.

import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';

import { displayed, pageOf } from './ball_page.mjs';
import { exactColors, tracedPicture } from './ball_truth.mjs';
import { isOnBall, side_px } from './ball_view.mjs';
import { openPage } from './browser_page.mjs';
import { linesUnder } from './documented_lines.mjs';
import { exportModel, tracedModel } from './model_truth.mjs';

const [program, browserPath, folder, documentation, ...named] = process.argv.slice(2);
const isModel = (path) => /\.gl(tf|b)$/.test(path);
const panoramas = named.filter((path) => !isModel(path)).map((path) => resolve(path));
const models = named.filter(isModel).map((path) => resolve(path));

const roughnesses = [0, 0.1, 0.25, 0.5, 0.75, 1];
const balls = [{ material: 'metal', metallic: 1, albedo: 1 }, { material: 'plastic', metallic: 0, albedo: 0.5 }]
  .flatMap((surface) => roughnesses.map((roughness) => ({ ...surface, roughness })));

/// Evenly spread (Fibonacci's lattice).
const directionCount = 48;
const directions = Array.from({ length: directionCount }, (_, i) => {
  const y = 1 - (2 * i + 1) / directionCount;
  const around = i * Math.PI * (3 - Math.sqrt(5));
  return [Math.sqrt(1 - y * y) * Math.sin(around), y, Math.sqrt(1 - y * y) * Math.cos(around)];
});
const surfaces = [...roughnesses.slice(1).map((roughness) => ({ roughness })), {}];
const views = surfaces.flatMap((surface) => directions.map((direction) => ({ direction, ...surface })));

const ofThree = { engine: 'three.js', file: 'specular.ktx2' };
const inOtherFormat = { ...ofThree, heading: 'Half floats in three.js', isBesideOnly: true };
const ways = [
  { name: 'three.js, own', engine: 'three.js', own: 'three' },
  { name: 'three.js, ours', ...ofThree, bake: 'three' },
  { name: 'ours, rows', ...ofThree, more: ['Rows of lobes in three.js'], isInPicturesOnly: true, bake: 'three' },
  { name: '512²', ...ofThree, isBesideOnly: true, bake: 'three --size 512' },
  { name: 'half', ...inOtherFormat, bake: 'three --format half' },
  { name: 'bc6h', ...inOtherFormat, bake: 'three --format bc6h' },
  { name: 'Babylon.js, own', engine: 'Babylon.js', own: 'babylon' },
  { name: 'ours, .env', engine: 'Babylon.js', bake: 'babylon', file: 'environment.env' },
  { name: 'ours, .dds', engine: 'Babylon.js', bake: 'babylon', file: 'environment.dds' },
  { name: 'PlayCanvas, own', engine: 'PlayCanvas', own: 'playcanvas' },
  { name: 'PlayCanvas, ours', engine: 'PlayCanvas', bake: 'playcanvas', file: 'environment.png' },
  { name: 'Filament, ours', engine: 'Filament', bake: 'filament', file: 'baked_ibl.ktx', page: 'engines/filament.md',
    heading: 'In a browser' },
];

function run(words) {
  const { status } = spawnSync(program, [...words, '--quiet'], { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
  if (status !== 0) process.exit(status ?? 1);
}

/// Makes what an engine loads.
///
/// returns  its address, and that of the lines that load it
function prepared({ engine, page, heading, more, own, bake, file }, environment) {
  if (own) {
    run(['convert', environment, '--to', 'equirect', '--for', own, '-o', 'own.hdr']);
    return ['/own.hdr', `/own_${own}.mjs`];
  }
  run(['bake', environment, '--for', ...bake.split(' '), '-o', 'baked/']);
  const headings = [heading ?? engine, ...more ?? []];
  const lines = `docs_${headings.join(', ')}.mjs`;
  const text = headings.map((one) => linesUnder(join(documentation, page ?? 'engines.md'), one)).join('');
  writeFileSync(join(folder, lines), text);
  return [`/baked/${file}`, `/${lines}`];
}

/// What a function of one of the pages returns for a way to filter an environment.
async function seenBy(way, environment, page, functionName, what) {
  const [url, lines] = prepared(way, environment);
  const opened = await openPage(browserPath, folder, page, (text) => console.error(`${way.name}: ${text}`));
  await opened.waitForFunction((name) => window[name], functionName);
  const seen = await opened.evaluate(([name, ...rest]) => window[name](...rest),
    [functionName, way.engine, url, lines, what]);
  await opened.context().browser().close();
  return seen;
}

const picturesBy = (way, environment) => seenBy(way, environment, 'balls.html', 'picturesIn', balls);
const colorsBy = async (way, environment) =>
  (await seenBy(way, environment, 'engines.html', 'coloursIn', views)).flat();

/// The errors of numbers of light, in percent of the truth's mean.
function errorsOf(found, truth) {
  const mean = (numbers) => numbers.reduce((sum, number) => sum + number, 0) / numbers.length;
  const differences = found.map((light, i) => light - truth[i]);
  const percent = 100 / mean(truth);
  return { rms: percent * Math.sqrt(mean(differences.map((one) => one ** 2))), mean: percent * mean(differences) };
}

/// Those of pictures, where they show the ball only.
function errorsOfPictures(pictures, truths) {
  const onBall = (picture) => picture.filter((_, i) => isOnBall(Math.floor(i / 3)));
  return pictures.map((picture, i) => errorsOf(onBall(picture), onBall(truths[i])));
}

/// Those of colours by the surface. What the engine's surface reflects of even light is divided out.
function errorsOfColors(colors, white, exact) {
  const found = colors.map((light, i) => light / white[i]);
  const length = 3 * directionCount;
  const part = (numbers, surface) => numbers.slice(surface * length, (surface + 1) * length);
  return surfaces.map((_, surface) => errorsOf(part(found, surface), part(exact, surface)));
}

function tableOf(names, rows) {
  const lines = [`| | ${rows.map(({ name }) => name).join(' | ')} |`, `| --- |${' --: |'.repeat(rows.length)}`];
  names.forEach((name, i) => {
    const cells = rows.map(({ errors }) => `${errors[i].rms.toFixed(1)} (${errors[i].mean.toFixed(1)})`);
    lines.push(`| ${name} | ${cells.join(' | ')} |`);
  });
  return `${lines.join('\n')}\n`;
}

/// returns  the rows of the table and of the page; the first row is the truth
async function comparePictures(panorama) {
  const truth = balls.map((ball) => tracedPicture(run, folder, panorama, ball));
  const rows = [{ name: 'path tracer', pictures: truth }];
  for (const way of ways.filter(({ isBesideOnly }) => !isBesideOnly)) {
    const pictures = await picturesBy(way, panorama);
    rows.push({ name: way.name, pictures, errors: errorsOfPictures(pictures, truth) });
  }
  return rows;
}

async function compareColors(panorama, whites) {
  const exact = exactColors(run, folder, panorama, views);
  const rows = [];
  for (const way of ways.filter(({ isInPicturesOnly }) => !isInPicturesOnly))
    rows.push({ name: way.name, errors: errorsOfColors(await colorsBy(way, panorama), whites.get(way.engine), exact) });
  return rows;
}

/// A model by the path tracer and by the engines: pictures, and how far they are from the first, as displayed, where it
/// shows the model only. Nine tenths of that are exposed to below 1.
async function compareModel(model, panorama) {
  const seen = exportModel(run, folder, model);
  const { colors, isModel: shows, width_px, height_px } = tracedModel(run, folder, panorama);
  const onModel = (picture) => picture.filter((_, i) => shows[Math.floor(i / 3)]);
  const sorted = onModel(colors).sort((a, b) => a - b);
  const exposure = 1 / sorted[Math.floor(0.9 * sorted.length)];
  const codesOf = (picture) => onModel(picture).map((light) => displayed(exposure * light));
  const truth = codesOf(colors);
  const rows = [{ name: 'path tracer', picture: colors }];
  for (const way of ways.filter(({ isBesideOnly }) => !isBesideOnly)) {
    const picture = await seenBy(way, panorama, 'models.html', 'modelIn', seen);
    const squares = codesOf(picture).map((code, i) => ((code - truth[i]) / 255) ** 2);
    const psnr_dB = -10 * Math.log10(squares.reduce((sum, square) => sum + square, 0) / squares.length);
    rows.push({ name: way.name, picture, psnr_dB });
  }
  return { name: `${basename(model)}, ${basename(panorama)}`, rows, width_px, height_px, exposure };
}

run(['export', 'sphere', '-o', 'ball.glb']);
const whites = new Map();
for (const way of ways.filter(({ bake }) => bake))
  if (!whites.has(way.engine)) whites.set(way.engine, await colorsBy(way, 'white'));
let text = '';
const sheets = [];
for (const panorama of panoramas) {
  const name = basename(panorama);
  const pictures = await comparePictures(panorama);
  text += `${name}, balls beside the path tracer:\n\n`;
  text += `${tableOf(balls.map(({ material, roughness }) => `${material} ${roughness}`), pictures.slice(1))}\n`;
  text += `${name}, seen along the normal, beside the sum over all texels:\n\n`;
  text += `${tableOf(surfaces.map(({ roughness }) => roughness ?? 'matt'), await compareColors(panorama, whites))}\n`;
  sheets.push({ name, balls, rows: pictures });
}
const shown = [];
for (const model of models)
  for (const panorama of panoramas) {
    shown.push(await compareModel(model, panorama));
    const { name, rows } = shown.at(-1);
    text += `${name}, PSNR in dB:\n\n`;
    text += `${rows.slice(1).map((row) => `| ${row.name} | ${row.psnr_dB.toFixed(1)} |`).join('\n')}\n\n`;
  }
writeFileSync(join(folder, 'engines.md'), text);
writeFileSync(join(folder, 'engines.html'), pageOf(sheets, side_px, shown));
console.log(text);
