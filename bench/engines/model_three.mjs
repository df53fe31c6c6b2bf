// In the browser: a model in three.js.

import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/// loadEnvironment   (url, renderer)
/// useRows           (scene, url, renderer); none: reflections are three.js' own
export async function showInThree(url, loadEnvironment, model, useRows) {
  const { width_px, height_px, eye, target, up, fieldOfView_deg, near, far } = model;
  const renderer = new THREE.WebGLRenderer();
  const scene = new THREE.Scene();
  scene.environment = await loadEnvironment(url, renderer);
  scene.add((await new GLTFLoader().loadAsync(model.url)).scene);
  await useRows?.(scene, url.replace('specular', 'lobe_rows'), renderer);
  const camera = new THREE.PerspectiveCamera(fieldOfView_deg, width_px / height_px, near, far);
  camera.position.set(...eye);
  camera.up.set(...up);
  camera.lookAt(...target);
  const drawn = new THREE.WebGLRenderTarget(width_px, height_px, { type: THREE.FloatType });
  renderer.setRenderTarget(drawn);
  renderer.setClearColor(0x000000, 1);
  renderer.render(scene, camera);
  const pixels = new Float32Array(4 * width_px * height_px);
  renderer.readRenderTargetPixels(drawn, 0, 0, width_px, height_px, pixels);
  return pixels;
}
