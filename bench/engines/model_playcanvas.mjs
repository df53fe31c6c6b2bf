// In the browser: a model in PlayCanvas.

import * as pc from 'playcanvas';

/// loadEnvironment   (url, app)
export async function showInPlayCanvas(url, loadEnvironment, model) {
  const { width_px, height_px, eye, target, up, fieldOfView_deg, near, far } = model;
  const app = new pc.Application(document.createElement('canvas'));
  app.autoRender = false;
  app.start();
  await loadEnvironment(url, app);
  const asset = new pc.Asset('model', 'container', { url: model.url });
  await new Promise((resolve, reject) => {
    asset.ready(resolve);
    asset.once('error', reject);
    app.assets.add(asset);
    app.assets.load(asset);
  });
  app.root.addChild(asset.resource.instantiateRenderEntity());
  const colorBuffer = new pc.Texture(app.graphicsDevice,
    { width: width_px, height: height_px, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false });
  const renderTarget = new pc.RenderTarget({ colorBuffer, depth: true });
  const camera = new pc.Entity();
  camera.addComponent('camera', { fov: fieldOfView_deg, nearClip: near, farClip: far, renderTarget,
    clearColor: new pc.Color(0, 0, 0, 1), gammaCorrection: pc.GAMMA_NONE, toneMapping: pc.TONEMAP_NONE,
    layers: [pc.LAYERID_WORLD] });  // without the sky
  camera.setPosition(...eye);
  camera.lookAt(new pc.Vec3(target), new pc.Vec3(up));
  app.root.addChild(camera);
  app.renderNextFrame = true;
  await new Promise((resolve) => app.once('postrender', resolve));
  return colorBuffer.read(0, 0, width_px, height_px, { renderTarget });
}
