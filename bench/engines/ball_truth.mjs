// What balls look like in truth: by the path tracer, and by the sum over all texels of the environment.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { FloatType } from 'three';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';

import { distance, fieldOfView_deg, side_px } from './ball_view.mjs';
import { exactMean, panoramaTexels } from './known_light.mjs';

const samples = 256;
const panoramaHeight = 512;

/// An .exr, from the lowest row: its samples, and how many a pixel has.
export function readExr(path) {
  const file = readFileSync(path);
  const bytes = file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength);
  const { data, width, height } = new EXRLoader().setDataType(FloatType).parse(bytes);
  return { data, channels: data.length / (width * height), pixels: width * height };
}

/// Its red, green and blue.
export const colorsOf = ({ data, channels, pixels }) =>
  Array.from({ length: 3 * pixels }, (_, i) => data[channels * Math.floor(i / 3) + (i % 3)]);

/// The path tracer's picture of a ball, from the lowest row.
///
/// run      runs our program
export function tracedPicture(run, folder, environment, { metallic, albedo, roughness }) {
  const path = join(folder, 'truth.exr');
  run(['render', 'sphere', '-e', environment, '--reference', '--bounces', '1', '--unoccluded', '--camera',
    `0,0,${distance}`, '--target', '0,0,0', '--fov', `${fieldOfView_deg}`, '--size', `${side_px}x${side_px}`,
    '--samples', `${samples}`, '--set', `metallic=${metallic}`, '--set', `base_color=${albedo}`, '--set',
    `perceptual_roughness=${roughness}`, '--set', 'fresnel=schlick', '-o', path]);
  return colorsOf(readExr(path));
}

/// The exact colours of a ball that is seen along its normal, all in one list.
///
/// views    a direction each, and a roughness, which matt surfaces lack
export function exactColors(run, folder, environment, views) {
  const path = join(folder, 'panorama.exr');
  run(['convert', environment, '--to', 'equirect', '--size', `${panoramaHeight}`, '-o', path]);
  const colors = colorsOf(readExr(path));
  const width = 2 * panoramaHeight;
  const texels = panoramaTexels(width, panoramaHeight, (_, i) => {
    const at = 3 * ((panoramaHeight - 1 - Math.floor(i / width)) * width + (i % width));
    return colors.slice(at, at + 3);
  });
  return views.flatMap(({ direction, roughness }) => exactMean(texels, direction, roughness ?? 1));
}
