// In the browser: balls in Filament.

import { distance, drawnSide_px, fieldOfView_deg } from './ball_view.mjs';
import { filamentStage } from './filament_stage.mjs';

/// loadEnvironment   (url, engine, scene)
export async function startFilament(url, loadEnvironment) {
  const { Filament, engine, scene, camera, drawn, setMaterial } =
    await filamentStage('/ball.glb', drawnSide_px, drawnSide_px);
  const light = await loadEnvironment(url, engine, scene);
  light.setIntensity(1);
  camera.setProjectionFov(fieldOfView_deg, 1, 0.1, 10, Filament.Camera$Fov.VERTICAL);
  camera.lookAt([0, 0, distance], [0, 0, 0], [0, 1, 0]);

  return async (ball) => {
    setMaterial(ball);
    return drawn();
  };
}
