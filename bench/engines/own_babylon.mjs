// In the browser: a panorama that Babylon.js filters by itself.

import { HDRCubeTexture } from '@babylonjs/core/Materials/Textures/hdrCubeTexture.js';

const faceSide = 256;

/// `prefilterOnLoad` has HDRFiltering make the levels.
export function loadEnvironment(url, scene) {
  return new Promise((resolve, reject) => {
    scene.environmentTexture = new HDRCubeTexture(url, scene, faceSide, false, true, false, true, resolve, reject);
  });
}
