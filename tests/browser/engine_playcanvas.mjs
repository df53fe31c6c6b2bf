// In the browser: a ball in PlayCanvas, in an environment that the lines in docs/engines.md have loaded.

import * as pc from 'playcanvas';

const side_px = 8;
const metal = 0.04;

/// loadEnvironment   (url, app), of the documentation
export async function startPlayCanvas(url, loadEnvironment) {
  const app = new pc.Application(document.createElement('canvas'));
  app.autoRender = false;
  app.start();
  await loadEnvironment(url, app);
  const ball = new pc.Entity();
  const mesh = pc.Mesh.fromGeometry(app.graphicsDevice,
    new pc.SphereGeometry({ radius: 1, latitudeBands: 128, longitudeBands: 128 }));
  const instance = new pc.MeshInstance(mesh, new pc.StandardMaterial());
  ball.addComponent('render', { meshInstances: [instance] });
  app.root.addChild(ball);
  const colorBuffer = new pc.Texture(app.graphicsDevice,
    { width: side_px, height: side_px, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false });
  const renderTarget = new pc.RenderTarget({ colorBuffer, depth: true });
  const camera = new pc.Entity();
  camera.addComponent('camera', { projection: pc.PROJECTION_ORTHOGRAPHIC, orthoHeight: 0.02, nearClip: 0.1, farClip: 10,
    renderTarget, gammaCorrection: pc.GAMMA_NONE, toneMapping: pc.TONEMAP_NONE });
  app.root.addChild(camera);

  /// The linear light that leaves the ball's middle; without a roughness, of a matt white one.
  const colourOf = async ({ direction, roughness }) => {
    const material = new pc.StandardMaterial();
    material.useMetalness = true;
    material.metalness = roughness === undefined ? 0 : 1;
    material.gloss = 1 - (roughness ?? 1);
    material.diffuse = roughness === undefined ? new pc.Color(1, 1, 1) : new pc.Color(metal, metal, metal);
    material.update();
    instance.material = material;
    camera.setPosition(new pc.Vec3(direction).normalize().mulScalar(3));
    camera.lookAt(pc.Vec3.ZERO, Math.abs(direction[1]) > 0.9 ? pc.Vec3.BACK : pc.Vec3.UP);
    app.renderNextFrame = true;
    await new Promise((resolve) => app.once('postrender', resolve));
    const pixels = await colorBuffer.read(side_px / 2, side_px / 2, 1, 1, { renderTarget });
    return [...pixels.slice(0, 3)];
  };
  return { colourOf };
}
