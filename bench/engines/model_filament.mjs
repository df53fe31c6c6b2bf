// In the browser: a model in Filament.

import { filamentStage } from './filament_stage.mjs';

/// loadEnvironment   (url, engine, scene)
export async function showInFilament(url, loadEnvironment, model) {
  const { width_px, height_px, eye, target, up, fieldOfView_deg, near, far } = model;
  const { Filament, engine, scene, camera, drawn } = await filamentStage(model.url, width_px, height_px);
  const light = await loadEnvironment(url, engine, scene);
  light.setIntensity(1);
  scene.setSkybox(null);  // black
  camera.setProjectionFov(fieldOfView_deg, width_px / height_px, near, far, Filament.Camera$Fov.VERTICAL);
  camera.lookAt(eye, target, up);
  return drawn();
}
