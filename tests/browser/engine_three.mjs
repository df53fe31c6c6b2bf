// In the browser: a ball in three.js, in an environment that the lines in docs/engines.md have loaded.

import * as THREE from 'three';

const side_px = 8;
const metal = [0.04, 0.04, 0.04];  // dark: light that is reflected many times, which an engine adds, plays no part

/// loadEnvironment   (url, renderer), of the documentation
export async function startThree(url, loadEnvironment) {
  const renderer = new THREE.WebGLRenderer();
  const scene = new THREE.Scene();
  scene.environment = await loadEnvironment(url, renderer);
  const ball = new THREE.Mesh(new THREE.SphereGeometry(1, 128, 64));
  scene.add(ball);
  const camera = new THREE.OrthographicCamera(-0.02, 0.02, 0.02, -0.02, 0.1, 10);
  const target = new THREE.WebGLRenderTarget(side_px, side_px, { type: THREE.FloatType });

  /// The linear light that leaves the ball's middle; without a roughness, of a matt white one.
  const colourOf = async ({ direction, roughness }) => {
    ball.material = roughness === undefined ? new THREE.MeshLambertMaterial()
      : new THREE.MeshStandardMaterial({ metalness: 1, roughness, color: new THREE.Color(...metal) });
    camera.position.set(...direction).setLength(3);
    camera.up.set(...(Math.abs(direction[1]) > 0.9 ? [0, 0, 1] : [0, 1, 0]));
    camera.lookAt(0, 0, 0);
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    const pixel = new Float32Array(4);
    renderer.readRenderTargetPixels(target, side_px / 2, side_px / 2, 1, 1, pixel);
    return [...pixel.slice(0, 3)];
  };
  return { colourOf };
}
