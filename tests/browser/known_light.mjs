// An environment whose mean under any lobe is known: a function of the direction, and its exact means.

import { writeFileSync } from 'node:fs';

const width = 512;
const height = 256;
const lamp = { towards: normalized([0.5, 0.6, -0.62]), cosine: Math.cos(0.25), radiance: [9, 6, 4] };

function normalized(v) {
  const length = Math.hypot(...v);
  return v.map((component) => component / length);
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/// Each of the three axes has a channel, in which light grows along it: no two directions have one colour, and a map
/// that is mirrored or turned has wrong colours everywhere. A lamp makes what is sharp.
export function knownLight(direction) {
  const d = normalized(direction);
  const isLamp = dot(d, lamp.towards) > lamp.cosine;
  return d.map((component, c) => 0.3 + 0.25 * component + (isLamp ? lamp.radiance[c] : 0));
}

/// The texels of a panorama in our arrangement (docs/conventions.md), from the highest row: directions, solid angles,
/// light.
///
/// lightOf   of a direction, and a texel's number
export function panoramaTexels(width, height, lightOf) {
  const texels = [];
  for (let y = 0; y < height; ++y) {
    const theta = (Math.PI * (y + 0.5)) / height;
    const solidAngle =
      (Math.cos((Math.PI * y) / height) - Math.cos((Math.PI * (y + 1)) / height)) * ((2 * Math.PI) / width);
    for (let x = 0; x < width; ++x) {
      const phi = (2 * Math.PI * (x + 0.5)) / width;
      const d = [Math.sin(theta) * Math.sin(phi), Math.cos(theta), -Math.sin(theta) * Math.cos(phi)];
      texels.push({ d, solidAngle, light: lightOf(d, texels.length) });
    }
  }
  return texels;
}

export const knownTexels = panoramaTexels(width, height, knownLight);

function writePfm(path, lightOf) {
  const samples = new Float32Array(width * height * 3);
  knownTexels.forEach((texel, i) => {
    const [x, y] = [i % width, Math.floor(i / width)];
    samples.set(lightOf(texel), 3 * ((height - 1 - y) * width + x));  // PFM has its rows from the bottom
  });
  writeFileSync(path, Buffer.concat([Buffer.from(`PF\n${width} ${height}\n-1.0\n`), Buffer.from(samples.buffer)]));
}

export const whiteRadiance = 0.5;

/// Writes the environment, and one of even light, with which an engine shows what its surfaces reflect at all.
export function writeMaps(path, whitePath) {
  writePfm(path, ({ light }) => light);
  writePfm(whitePath, () => [whiteRadiance, whiteRadiance, whiteRadiance]);
}

/// The mean of the light around a direction, each direction weighted with `lobe` of its cosine.
function meanAround(texels, direction, lobe) {
  const sum = [0, 0, 0];
  let weights = 0;
  for (const { d, solidAngle, light } of texels) {
    const cosine = dot(d, direction);
    if (cosine <= 0) continue;
    const weight = solidAngle * lobe(cosine);
    weights += weight;
    light.forEach((radiance, c) => { sum[c] += weight * radiance; });
  }
  return sum.map((radiance) => radiance / weights);
}

/// What a rough metal shows that is seen along its normal: GGX with n = v (docs/prefiltering.md). Roughness 1 is what a
/// matt white surface shows.
export function exactMean(texels, direction, roughness) {
  const alpha2 = roughness ** 4;
  const towards = normalized(direction);
  return meanAround(texels, towards, (cosine) => {
    const halfCosine2 = (1 + cosine) / 2;
    return cosine / (1 + (alpha2 - 1) * halfCosine2) ** 2;
  });
}
