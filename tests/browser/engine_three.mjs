// In the browser: a ball in three.js, in an environment that the lines in docs/engines.md have loaded.

import * as THREE from 'three';

const side_px = 8;
// Half of the width that is seen: so little that three.js does not make the ball rougher for its curvature.
const reach = 5e-4;

const black = new THREE.Color(0, 0, 0);
const dark = new THREE.Color(0.04, 0.04, 0.04);  // so that what is reflected several times plays no part
const materials = {
  matt: new THREE.MeshLambertMaterial(),
  darkMetal: new THREE.MeshStandardMaterial({ metalness: 1, color: dark }),
  whiteMetal: new THREE.MeshStandardMaterial({ metalness: 1 }),
  blackPlastic: new THREE.MeshStandardMaterial({ color: black }),
  coat: new THREE.MeshPhysicalMaterial({ color: black, specularIntensity: 0, clearcoat: 1 }),
};

/// loadEnvironment   (url, renderer), of the documentation
/// useRows           (scene, url, renderer), likewise; none: reflections are three.js' own
export async function startThree(url, loadEnvironment, useRows) {
  const renderer = new THREE.WebGLRenderer();
  const scene = new THREE.Scene();
  scene.environment = await loadEnvironment(url, renderer);
  const shape = new THREE.SphereGeometry(1, 128, 64);
  const balls = Object.entries(materials).map(([name, material]) => {
    const ball = new THREE.Mesh(shape, material);
    ball.name = name;
    return ball;
  });
  scene.add(...balls);
  await useRows?.(scene, url.replace('specular', 'lobe_rows'), renderer);
  const camera = new THREE.OrthographicCamera(-reach, reach, reach, -reach, 0.1, 10);
  const target = new THREE.WebGLRenderTarget(side_px, side_px, { type: THREE.FloatType });

  /// The linear light that leaves the ball where it has a normal, towards a direction; without a normal, along it.
  const colourOf = async ({ direction, normal, roughness, surface }) => {
    const shown = surface ?? (roughness === undefined ? 'matt' : 'darkMetal');
    for (const ball of balls) ball.visible = ball.name === shown;
    Object.assign(materials[shown], shown === 'coat' ? { clearcoatRoughness: roughness } : { roughness });
    const toEye = new THREE.Vector3(...direction).normalize();
    const place = normal ? new THREE.Vector3(...normal) : toEye;
    camera.position.copy(place).addScaledVector(toEye, 2);
    camera.up.set(...(Math.abs(toEye.y) > 0.9 ? [0, 0, 1] : [0, 1, 0]));
    camera.lookAt(place);
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    const pixel = new Float32Array(4);
    renderer.readRenderTargetPixels(target, side_px / 2, side_px / 2, 1, 1, pixel);
    return [...pixel.slice(0, 3)];
  };
  return { colourOf };
}
