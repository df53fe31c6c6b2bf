// In the browser: a panorama that three.js filters by itself.

import { EquirectangularReflectionMapping } from 'three';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';

/// The renderer has PMREMGenerator make the levels.
export async function loadEnvironment(url) {
  const texture = await new HDRLoader().loadAsync(url);
  texture.mapping = EquirectangularReflectionMapping;
  return texture;
}
