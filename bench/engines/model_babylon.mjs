// In the browser: a model in Babylon.js.

import '@babylonjs/core/Engines/Extensions/engine.readTexture.js';
import '@babylonjs/core/Loading/loadingScreen.js';
import '@babylonjs/loaders/glTF/2.0/index.js';

import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { AppendSceneAsync } from '@babylonjs/core/Loading/sceneLoader.js';
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js';
import { Color4 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Scene } from '@babylonjs/core/scene.js';

const floats = 1;  // Constants.TEXTURETYPE_FLOAT

/// As its glTF loader has our axes.
const vector = ([x, y, z]) => new Vector3(-x, y, z);

/// loadEnvironment   (url, scene)
export async function showInBabylon(url, loadEnvironment, model) {
  const { width_px, height_px, eye, target, up, fieldOfView_deg, near, far } = model;
  const canvas = Object.assign(document.createElement('canvas'), { width: width_px, height: height_px });
  const scene = new Scene(new Engine(canvas));
  scene.imageProcessingConfiguration.applyByPostProcess = true;  // and so the picture is linear light
  scene.imageProcessingConfiguration.skipFinalColorClamp = true;
  await loadEnvironment(url, scene);
  await AppendSceneAsync(model.url, scene);
  const camera = new FreeCamera('camera', vector(eye), scene);
  camera.upVector = vector(up);
  camera.setTarget(vector(target));
  Object.assign(camera, { fov: (fieldOfView_deg * Math.PI) / 180, minZ: near, maxZ: far });
  const size = { width: width_px, height: height_px };
  const picture = new RenderTargetTexture('picture', size, scene, { type: floats, generateMipMaps: false });
  picture.renderList = scene.meshes;
  picture.activeCamera = camera;
  picture.clearColor = new Color4(0, 0, 0, 1);
  await scene.whenReadyAsync();
  while (!picture.isReadyForRendering()) await new Promise((resolve) => setTimeout(resolve, 5));
  picture.render();
  return picture.readPixels();
}
