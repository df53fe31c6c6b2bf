// In the browser: a ball in Filament, in an environment that the lines in docs/engines/filament.md have loaded.

import { filamentStage } from './filament_stage.mjs';

const side_px = 8;
const metal = 0.04;  // dark: light that is reflected many times, which an engine adds, plays no part

/// loadEnvironment   (url, engine, scene), of the documentation
export async function startFilament(url, loadEnvironment) {
  const { Filament, engine, scene, camera, drawn, setMaterial } = await filamentStage('/ball.glb', side_px, side_px);
  const light = await loadEnvironment(url, engine, scene);
  light.setIntensity(1);

  /// The linear light that leaves the ball's middle; without a roughness, of a matt white one. Or what lies in that
  /// direction behind everything.
  const colourOf = async ({ direction, roughness, isBackground }) => {
    const length = Math.hypot(...direction);
    const eye = direction.map((component) => (3 * component) / length);
    const up = Math.abs(direction[1]) > 0.9 ? [0, 0, 1] : [0, 1, 0];
    if (isBackground) {
      camera.setProjectionFov(1, 1, 0.1, 10, Filament.Camera$Fov.VERTICAL);
      camera.lookAt(eye, eye.map((component) => 2 * component), up);
    } else {
      const isMatt = roughness === undefined;
      setMaterial({ metallic: isMatt ? 0 : 1, roughness: roughness ?? 1, albedo: isMatt ? 1 : metal });
      camera.setProjection(Filament.Camera$Projection.ORTHO, -0.02, 0.02, -0.02, 0.02, 0.1, 10);
      camera.lookAt(eye, [0, 0, 0], up);
    }
    const middle = 4 * ((side_px / 2) * side_px + side_px / 2);
    return [...(await drawn()).slice(middle, middle + 3)];
  };
  return { colourOf };
}
