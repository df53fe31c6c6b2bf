// In the browser: balls in three.js.

import * as THREE from 'three';

import { distance, drawnSide_px, fieldOfView_deg } from './ball_view.mjs';

/// loadEnvironment   (url, renderer)
/// useRows           (scene, url, renderer); none: reflections are three.js' own
export async function startThree(url, loadEnvironment, useRows) {
  const renderer = new THREE.WebGLRenderer();
  const scene = new THREE.Scene();
  scene.environment = await loadEnvironment(url, renderer);
  const material = new THREE.MeshStandardMaterial();
  scene.add(new THREE.Mesh(new THREE.SphereGeometry(1, 256, 128), material));
  await useRows?.(scene, url.replace('specular', 'lobe_rows'), renderer);
  const camera = new THREE.PerspectiveCamera(fieldOfView_deg, 1, 0.1, 10);
  camera.position.z = distance;
  const target = new THREE.WebGLRenderTarget(drawnSide_px, drawnSide_px, { type: THREE.FloatType });

  return async ({ metallic, roughness, albedo }) => {
    Object.assign(material, { metalness: metallic, roughness, color: new THREE.Color(albedo, albedo, albedo) });
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    const pixels = new Float32Array(4 * drawnSide_px ** 2);
    renderer.readRenderTargetPixels(target, 0, 0, drawnSide_px, drawnSide_px, pixels);
    return pixels;
  };
}
