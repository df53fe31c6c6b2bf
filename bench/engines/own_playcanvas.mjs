// In the browser: a panorama that PlayCanvas filters by itself.

import * as pc from 'playcanvas';

export function loadEnvironment(url, app) {
  const asset = new pc.Asset('panorama', 'texture', { url }, { mipmaps: false });
  return new Promise((resolve, reject) => {
    asset.ready(() => {
      const light = pc.EnvLighting.generateLightingSource(asset.resource);
      app.scene.envAtlas = pc.EnvLighting.generateAtlas(light);
      resolve();
    });
    asset.once('error', reject);
    app.assets.add(asset);
    app.assets.load(asset);
  });
}
