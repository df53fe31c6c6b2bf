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

/// What facets reflect that a rough surface shows at some angle: GGX with Smith's masking and shadowing, correlated by
/// height.
///
/// normal, toEye   unit
/// returns         the shares of light from all around, `white`, and the `light` of the texels: of facets that reflect
///                 all, and of those that reflect by Schlick's term alone
export function exactLobe(texels, normal, toEye, roughness) {
  const alpha2 = roughness ** 4;
  const nv = dot(normal, toEye);
  const ofEye = Math.sqrt(alpha2 + (1 - alpha2) * nv * nv);
  const all = { white: 0, light: [0, 0, 0] };
  const rising = { white: 0, light: [0, 0, 0] };
  for (const { d, solidAngle, light } of texels) {
    const nl = dot(normal, d);
    if (nl <= 0) continue;
    const vh = Math.sqrt((1 + dot(d, toEye)) / 2);
    const nh = (nl + nv) / (2 * vh);
    const facets = alpha2 / (Math.PI * (nh * nh * (alpha2 - 1) + 1) ** 2);
    const ofLight = Math.sqrt(alpha2 + (1 - alpha2) * nl * nl);
    const share = (solidAngle * facets * 0.5 * nl) / (nl * ofEye + nv * ofLight);
    const risen = share * (1 - vh) ** 5;
    all.white += share;
    rising.white += risen;
    light.forEach((radiance, c) => {
      all.light[c] += share * radiance;
      rising.light[c] += risen * radiance;
    });
  }
  return { all, rising };
}

/// What a surface shows, as a share of what it shows of even light. Light that facets reflect several times is diffuse,
/// as three.js has it (Fdez-Agüera 2019).
///
/// lobe         by exactLobe
/// irradiance   over π
/// f0           reflectance at normal incidence
/// isCoat       nothing is reflected several times
export function exactReflection({ all, rising }, irradiance, { f0, isCoat }) {
  const single = (everywhere, atAngles) => f0 * everywhere + (1 - f0) * atAngles;
  const ofWhite = single(all.white, rising.white);
  const mean = f0 + (1 - f0) / 21;
  const missing = 1 - all.white;
  const several = isCoat ? 0 : (missing * ofWhite * mean) / (1 - missing * mean);
  return irradiance.map((around, c) =>
    (single(all.light[c], rising.light[c]) + several * around) / (ofWhite + several));
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
