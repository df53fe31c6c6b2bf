// In the browser: a ball in Babylon.js, in an environment that the lines in docs/engines.md have loaded.

import '@babylonjs/core/Engines/Extensions/engine.readTexture.js';

import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { PBRBRDFConfiguration } from '@babylonjs/core/Materials/PBR/pbrBRDFConfiguration.js';
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js';
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js';
import { Color3 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { CreateSphere } from '@babylonjs/core/Meshes/Builders/sphereBuilder.js';
import { Scene } from '@babylonjs/core/scene.js';

const side_px = 8;
const floats = 1;  // Constants.TEXTURETYPE_FLOAT
const metal = 0.04;  // dark: light that is reflected many times, which an engine adds, plays no part

// Reflections alone: else rough metals show irradiance too.
PBRBRDFConfiguration.DEFAULT_MIX_IBL_RADIANCE_WITH_IRRADIANCE = false;

/// A ball in an environment.
///
/// loadEnvironment   (url, scene), of the documentation
export async function startBabylon(url, loadEnvironment) {
  const engine = new Engine(document.createElement('canvas'));
  const scene = new Scene(engine);
  scene.imageProcessingConfiguration.applyByPostProcess = true;  // and so the ball is linear light
  await loadEnvironment(url, scene);
  const ball = CreateSphere('ball', { diameter: 2, segments: 64 }, scene);
  const camera = new FreeCamera('camera', new Vector3(0, 0, 3), scene);
  camera.mode = FreeCamera.ORTHOGRAPHIC_CAMERA;
  Object.assign(camera, { orthoLeft: -0.02, orthoRight: 0.02, orthoTop: 0.02, orthoBottom: -0.02, minZ: 0.1 });
  const target = new RenderTargetTexture('target', side_px, scene, { type: floats, generateMipMaps: false });
  target.renderList = [ball];
  target.activeCamera = camera;

  /// The linear light that leaves the ball's middle; without a roughness, of a matt white one.
  const colourOf = async ({ direction: [x, y, z], roughness }) => {
    const material = new PBRMaterial('metal', scene);
    material.metallic = roughness === undefined ? 0 : 1;
    material.roughness = roughness ?? 1;
    material.albedoColor = roughness === undefined ? Color3.White() : new Color3(metal, metal, metal);
    ball.material = material;
    camera.position = new Vector3(-x, y, z).normalize().scale(3);  // as its glTF loader has our axes
    camera.upVector = Math.abs(y) > 0.9 ? new Vector3(0, 0, 1) : new Vector3(0, 1, 0);
    camera.setTarget(Vector3.Zero());
    await scene.whenReadyAsync();
    while (!target.isReadyForRendering()) await new Promise((resolve) => setTimeout(resolve, 5));
    target.render();
    const pixels = await target.readPixels();
    const middle = 4 * ((side_px / 2) * side_px + side_px / 2);
    return [...pixels.slice(middle, middle + 3)];
  };
  return { colourOf };
}
