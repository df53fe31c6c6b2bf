// In the browser: balls in PlayCanvas.

import * as pc from 'playcanvas';

import { distance, drawnSide_px, fieldOfView_deg } from './ball_view.mjs';

/// loadEnvironment   (url, app)
export async function startPlayCanvas(url, loadEnvironment) {
  const app = new pc.Application(document.createElement('canvas'));
  app.autoRender = false;
  app.start();
  await loadEnvironment(url, app);
  const mesh = pc.Mesh.fromGeometry(app.graphicsDevice,
    new pc.SphereGeometry({ radius: 1, latitudeBands: 128, longitudeBands: 256 }));
  const instance = new pc.MeshInstance(mesh, new pc.StandardMaterial());
  const entity = new pc.Entity();
  entity.addComponent('render', { meshInstances: [instance] });
  app.root.addChild(entity);
  const colorBuffer = new pc.Texture(app.graphicsDevice,
    { width: drawnSide_px, height: drawnSide_px, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false });
  const renderTarget = new pc.RenderTarget({ colorBuffer, depth: true });
  const camera = new pc.Entity();
  camera.addComponent('camera', { fov: fieldOfView_deg, nearClip: 0.1, farClip: 10, renderTarget,
    gammaCorrection: pc.GAMMA_NONE, toneMapping: pc.TONEMAP_NONE });
  camera.setPosition(0, 0, distance);
  app.root.addChild(camera);

  return async ({ metallic, roughness, albedo }) => {
    const material = new pc.StandardMaterial();
    // Its colours are sRGB.
    const srgb = albedo <= 0.0031308 ? 12.92 * albedo : 1.055 * albedo ** (1 / 2.4) - 0.055;
    Object.assign(material, { useMetalness: true, metalness: metallic, gloss: 1 - roughness,
      diffuse: new pc.Color(srgb, srgb, srgb) });
    material.update();
    instance.material = material;
    app.renderNextFrame = true;
    await new Promise((resolve) => app.once('postrender', resolve));
    return colorBuffer.read(0, 0, drawnSide_px, drawnSide_px, { renderTarget });
  };
}
