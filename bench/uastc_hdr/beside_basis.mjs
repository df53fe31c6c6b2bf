// usage: node beside_basis.mjs PROGRAM FOLDER SIDE PANORAMA…
//
// What uastc_hdr.sh does once npm's packages are there.

import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { basename, extname, join } from 'node:path';

import * as ktx from 'ktx-parse';
import { encodeToKTX2 } from 'ktx2-encoder';
import { DataUtils } from 'three';

import { loadTranscoder, transcoded } from './transcoder.mjs';

const [program, folder, side, ...panoramas] = process.argv.slice(2);
const most = 1.3;
const faces = ['px', 'nx', 'py', 'ny', 'pz', 'nz'];
const transcoder = await loadTranscoder();

function convert(words) {
  const { status } = spawnSync(program, ['convert', ...words], { stdio: ['ignore', 'ignore', 'inherit'] });
  if (status !== 0) process.exit(status ?? 1);
}

/// The red, green and blue of a cube's six faces in 32-bit floats, as our program reads it.
function colorsOf(path) {
  const floats = join(folder, 'floats.ktx2');
  convert([path, '--to', 'cube', '--size', side, '--format', 'float32', '-o', floats]);
  const { levelData } = ktx.read(new Uint8Array(readFileSync(floats))).levels[0];
  return new Float32Array(levelData.slice().buffer).filter((_, i) => i % 4 < 3);
}

/// A cube of BC6H from its six faces' blocks.
function colorsOfBc6h(blocks) {
  const cube = ktx.createDefaultContainer();
  cube.vkFormat = ktx.VK_FORMAT_BC6H_UFLOAT_BLOCK;
  cube.pixelWidth = cube.pixelHeight = Number(side);
  cube.faceCount = 6;
  const levelData = new Uint8Array(blocks.flatMap((face) => [...face]));
  cube.levels = [{ levelData, uncompressedByteLength: levelData.length }];
  const [descriptor] = cube.dataFormatDescriptor;
  Object.assign(descriptor, { colorModel: 133, transferFunction: ktx.KHR_DF_TRANSFER_LINEAR,
    texelBlockDimension: [3, 3, 0, 0], bytesPlane: [16, 0, 0, 0, 0, 0, 0, 0],
    samples: [{ bitOffset: 0, bitLength: 127, channelType: 0x80, samplePosition: [0, 0, 0, 0], sampleLower: 0,
      sampleUpper: 0x3f800000 }] });
  const path = join(folder, 'bc6h.ktx2');
  writeFileSync(path, ktx.write(cube));
  return colorsOf(path);
}

/// The errors of colours against the exact ones, in percent.
function errorsOf(found, exact) {
  const mean = exact.reduce((sum, light) => sum + Math.max(light, 0), 0) / exact.length;
  let [relative, absolute, light] = [0, 0, 0];
  exact.forEach((signed, i) => {
    const expected = Math.max(signed, 0);
    relative += ((found[i] - expected) / (expected + mean)) ** 2;
    absolute += (found[i] - expected) ** 2;
    light += expected ** 2;
  });
  return { relative: 100 * Math.sqrt(relative / exact.length), ofRms: 100 * Math.sqrt(absolute / light) };
}

/// What the transcoder makes of the image of each face: [file, face in it].
function errorsOfFiles(images, exact) {
  const decoded = images.map(([bytes, face]) => transcoded(transcoder, bytes, 0, 0, face));
  const halves = decoded.flatMap(({ halves }) => [...halves]).filter((_, i) => i % 4 < 3);
  return { halves: errorsOf(halves.map(DataUtils.fromHalfFloat), exact),
    bc6h: errorsOf(colorsOfBc6h(decoded.map(({ bc6h }) => bc6h)), exact) };
}

/// Basis Universal tells what it does; only what follows counts here.
async function silently(work) {
  const { log } = console;
  console.log = () => {};
  try {
    return await work();
  } finally {
    console.log = log;
  }
}

let faults = 0;
console.log('                        relative RMSE [%]         error of the RMS [%]');
console.log('panorama                ours   Basis U.  ratio    ours   Basis U.');
for (const panorama of panoramas) {
  const name = basename(panorama, extname(panorama));
  const stem = join(folder, name);
  const toCube = [panorama, '--to', 'cube', '--size', side];
  convert([...toCube, '--format', 'uastc_hdr', '-o', `${stem}.ktx2`]);
  convert([...toCube, '--format', 'half', '-o', `${stem}_exact.ktx2`]);
  convert([...toCube, '--format', 'half', '--layout', 'faces', '-o', `${stem}.exr`]);
  const exact = colorsOf(`${stem}_exact.ktx2`);

  const ours = readFileSync(`${stem}.ktx2`);
  const theirs = [];
  const begin = performance.now();
  await silently(async () => {
    for (const face of faces)
      theirs.push(await encodeToKTX2(new Uint8Array(readFileSync(`${stem}_${face}.exr`)),
        { isHDR: true, imageType: 'exr', generateMipmap: false }));
  });
  const seconds = (performance.now() - begin) / 1000;
  const a = errorsOfFiles(faces.map((_, face) => [ours, face]), exact);
  const b = errorsOfFiles(theirs.map((file) => [file, 0]), exact);
  for (const way of ['halves', 'bc6h']) {
    const ratio = a[way].relative / b[way].relative;
    faults += ratio > most;
    const columns = [a[way].relative.toFixed(3), b[way].relative.toFixed(3), ratio.toFixed(2), a[way].ofRms.toFixed(2),
      b[way].ofRms.toFixed(2)];
    console.log(`${name}, ${way}`.padEnd(26) + columns.map((column) => column.padEnd(8)).join(''));
  }
  console.log(`  Basis Universal took ${seconds.toFixed(1)} s`);
}
process.exit(faults > 0 ? 1 : 0);
