// Reflections that are right at every angle in three.js, version 187, with its WebGLRenderer. Copy this file.
//
// three.js looks a rough surface's reflection up once, in the middle of a lobe that it takes for round. With this file
// it looks up a row of narrower lobes. Which, says the table lobe_rows.ktx2 that `mirrorball bake room.hdr --for three
// -o room/` writes beside the environment. More: docs/engines.md and docs/lobe_rows.md of Mirrorball.
//
// MIT License, copyright (c) 2026 The Mirrorball authors.

import { LinearFilter, ShaderChunk } from 'three';
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';

// The formulas are those of docs/prefiltering.md, "Reflections right at every angle", with three.js' names and axes.
const functions = /* glsl */`
#ifdef ENVMAP_TYPE_PMREM

uniform sampler2D lobeRows;

// Of what facets reflect at this angle, the share that they do not reflect at normal incidence.
vec3 grazingShare(const in vec3 f0, const in float f90, const in vec2 dfg) {
  vec3 reflected = f0 * dfg.x + f90 * dfg.y;
  return clamp((f90 - f0) * dfg.y / max(reflected, vec3(1e-6)), 0.0, 1.0);
}

// The mean of the light under a surface's lobe, in place of getIBLRadiance().
vec3 lightOfRow(const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 grazing) {
  vec3 mirrored = envMapRotation * transformDirectionByInverseViewMatrix(reflect(-viewDir, normal), viewMatrix);
  vec3 towardsNormal = envMapRotation * transformNormalByInverseViewMatrix(normal, viewMatrix);
  float cosine = dot(mirrored, towardsNormal);
  towardsNormal -= cosine * mirrored;
  vec2 size = vec2(textureSize(lobeRows, 0));  // each lobe has a square as high as the table
  vec2 place = 0.5 + vec2(sqrt(clamp(cosine, 0.0, 1.0)), roughness) * (size.y - 1.0);
  vec3 light = vec3(0.0);
  vec3 weights = vec3(0.0);
  for (int i = 0; i < LOBES_OF_ROW; ++i) {
    vec4 lobe = textureLod(lobeRows, (place + vec2(float(i) * size.y, 0.0)) / size, 0.0);
    vec3 direction = mirrored + pow2(roughness) * lobe.x * towardsNormal;  // of a cube: any length will do
    vec3 weight = mix(vec3(lobe.z), vec3(lobe.w), grazing);
    light += weight * textureLod(envMap, direction, roughnessToMip(roughness * lobe.y)).rgb;
    weights += weight;
  }
  return envMapIntensity * light / weights;
}

#endif
`;

// f0 is what facets reflect at normal incidence, as computeMultiscattering() takes it.
const ofSurface = /* glsl */`
    vec3 f0 = material.specularColorBlended;
    #ifdef USE_IRIDESCENCE
      vec3 f0OfFilm = mix(material.iridescenceF0Dielectric, material.iridescenceF0Metallic, material.metalness);
      f0 = mix(f0, f0OfFilm, material.iridescence);
    #endif
    vec3 iblRadiance = lightOfRow(geometryViewDir, geometryNormal, material.roughness,
      grazingShare(f0, material.specularF90, material.dfg));`;

const ofCoat = /* glsl */`
    float dotNVcoat = saturate(dot(geometryClearcoatNormal, geometryViewDir));
    vec2 dfgOfCoat = texture2D(dfgLUT, vec2(material.clearcoatRoughness, dotNVcoat)).rg;
    clearcoatRadiance += lightOfRow(geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness,
      grazingShare(material.clearcoatF0, material.clearcoatF90, dfgOfCoat));`;

function replaced(text, old, by) {
  if (text.includes(old)) return text.replace(old, by);
  throw new Error(`lobe rows: the shader lacks "${old}"; they are for three.js 187 and shaders that have its parts`);
}

/// The part of three.js' shader that looks reflections up, with rows of lobes. Stretched (anisotropic) ones stay.
function lookUps() {
  const surface = 'vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );';
  const coat =
    'clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );';
  return replaced(replaced(ShaderChunk.lights_fragment_maps, surface, ofSurface), coat, ofCoat);
}

function withRows(fragmentShader, lobes) {
  const parts = '#include <lights_physical_pars_fragment>';
  const defined = `${parts}\n#define LOBES_OF_ROW ${lobes}\n${functions}`;
  return replaced(replaced(fragmentShader, parts, defined), '#include <lights_fragment_maps>', lookUps());
}

/// Loads a table of lobe rows.
///
/// url       of a lobe_rows.ktx2 of 2, 4 or 6 lobes
/// returns   the texture, for any number of materials
export async function loadLobeRows(url, renderer) {
  const loader = new KTX2Loader().detectSupport(renderer);
  const rows = await loader.loadAsync(url).finally(() => loader.dispose());
  rows.minFilter = LinearFilter;
  rows.magFilter = LinearFilter;
  return rows;
}

/// The uniform of each material that has rows.
const uniforms = new WeakMap();

function useInMaterial(material, rows) {
  material.needsUpdate = true;
  const known = uniforms.get(material);
  if (known) {
    known.value = rows;
    return;
  }
  const uniform = { value: rows };
  uniforms.set(material, uniform);
  const lobes = () => uniform.value.image.width / uniform.value.image.height;
  const { onBeforeCompile, customProgramCacheKey } = material;
  material.onBeforeCompile = (shader, renderer) => {
    onBeforeCompile.call(material, shader, renderer);
    shader.uniforms.lobeRows = uniform;
    shader.fragmentShader = withRows(shader.fragmentShader, lobes());
  };
  // three.js' own key is the text of onBeforeCompile, which is now the same for all.
  material.customProgramCacheKey = () =>
    `${customProgramCacheKey.call(material)} ${onBeforeCompile} with rows of ${lobes()} lobes`;
}

/// Makes surfaces look their reflections up by rows of lobes.
///
/// what   a MeshStandardMaterial or MeshPhysicalMaterial, or a mesh, model or scene, of whose materials those change
///        that are such. Materials that are added or cloned later need it, too.
/// rows   by loadLobeRows()
export function useLobeRows(what, rows) {
  const materials = new Set(what.isMaterial ? [what] : []);
  if (!what.isMaterial) what.traverse(({ material }) => [material].flat().forEach((one) => materials.add(one)));
  for (const material of materials) if (material?.isMeshStandardMaterial) useInMaterial(material, rows);
}
