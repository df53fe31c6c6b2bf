// A model as engines load it, and as the path tracer shows it.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { colorsOf, readExr } from './ball_truth.mjs';

const width_px = 240;
const height_px = 180;
const samples = 256;
const exported = 'model.glb';

/// Rewrites the JSON of a .glb.
function changeGltf(path, change) {
  const file = readFileSync(path);
  const end = 20 + file.readUInt32LE(12);
  const gltf = JSON.parse(file.toString('utf8', 20, end));
  change(gltf);
  const text = JSON.stringify(gltf);
  const json = Buffer.from(text.padEnd(text.length + ((4 - (Buffer.byteLength(text) % 4)) % 4)));
  const changed = Buffer.concat([file.subarray(0, 20), json, file.subarray(end)]);
  changed.writeUInt32LE(changed.length, 8);
  changed.writeUInt32LE(json.length, 12);
  writeFileSync(path, changed);
  return gltf;
}

/// Writes a model into FOLDER/model.glb, with a camera, and without its maps of occlusion: the path tracer's pictures
/// have none either.
///
/// run       runs our program
/// returns   what an engine needs to know: how the model is seen
export function exportModel(run, folder, model) {
  run(['export', model, '--camera', '30,10', '--size', `${width_px}x${height_px}`, '-o', exported]);
  const gltf = changeGltf(join(folder, exported), ({ materials = [] }) => {
    for (const material of materials) delete material.occlusionTexture;
  });
  const { matrix, camera } = gltf.nodes.find((node) => node.camera !== undefined);
  const { yfov, znear, zfar } = gltf.cameras[camera].perspective;
  const eye = matrix.slice(12, 15);
  const target = eye.map((component, i) => component - matrix[8 + i]);  // a camera looks along its -Z
  return { url: `/${exported}`, width_px, height_px, eye, target, up: matrix.slice(4, 7),
    fieldOfView_deg: (yfov * 180) / Math.PI, near: znear / 2, far: 2 * zfar };
}

/// The path tracer's picture of it, over black, from the lowest row, and which pixels show the model only.
export function tracedModel(run, folder, environment) {
  const path = join(folder, 'truth.exr');
  run(['render', exported, '-e', environment, '--reference', '--bounces', '1', '--unoccluded', '--camera', 'Camera',
    '--size', `${width_px}x${height_px}`, '--background', 'transparent', '--samples', `${samples}`, '-o', path]);
  const exr = readExr(path);
  const isModel = Array.from({ length: exr.pixels }, (_, i) => exr.data[exr.channels * i + 3] > 0.999);
  return { colors: colorsOf(exr), isModel, width_px, height_px };
}
