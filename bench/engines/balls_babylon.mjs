// In the browser: balls in Babylon.js.

import '@babylonjs/core/Engines/Extensions/engine.readTexture.js';

import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js';
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js';
import { Color3 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { CreateSphere } from '@babylonjs/core/Meshes/Builders/sphereBuilder.js';
import { Scene } from '@babylonjs/core/scene.js';

import { distance, drawnSide_px, fieldOfView_deg } from './ball_view.mjs';

const floats = 1;  // Constants.TEXTURETYPE_FLOAT
/// loadEnvironment   (url, scene)
export async function startBabylon(url, loadEnvironment) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = drawnSide_px;  // its shape is the camera's
  const engine = new Engine(canvas);
  const scene = new Scene(engine);
  scene.imageProcessingConfiguration.applyByPostProcess = true;  // and so the ball is linear light
  scene.imageProcessingConfiguration.skipFinalColorClamp = true;
  await loadEnvironment(url, scene);
  const mesh = CreateSphere('ball', { diameter: 2, segments: 64 }, scene);
  const camera = new FreeCamera('camera', new Vector3(0, 0, distance), scene);
  camera.setTarget(Vector3.Zero());
  camera.fov = (fieldOfView_deg * Math.PI) / 180;
  camera.minZ = 0.1;
  const target = new RenderTargetTexture('target', drawnSide_px, scene, { type: floats, generateMipMaps: false });
  target.renderList = [mesh];
  target.activeCamera = camera;

  return async ({ metallic, roughness, albedo }) => {
    mesh.material = new PBRMaterial('ball', scene);
    Object.assign(mesh.material, { metallic, roughness, albedoColor: new Color3(albedo, albedo, albedo) });
    await scene.whenReadyAsync();
    while (!target.isReadyForRendering()) await new Promise((resolve) => setTimeout(resolve, 5));
    target.render();
    return target.readPixels();
  };
}
