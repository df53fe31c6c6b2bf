// In the browser: what Filament needs to show a glTF model, and to show it in linear light.

/// npm's package is no module, but a script that makes one thing of this name.
const filament = new Promise((resolve, reject) => {
  const script = document.createElement('script');
  script.src = '/node_modules/filament/filament.js';
  script.onload = () => globalThis.Filament.init([], () => resolve(globalThis.Filament));
  script.onerror = reject;
  document.head.append(script);
});

const bytesOf = async (url) => new Uint8Array(await (await fetch(url)).arrayBuffer());

/// An engine whose picture is floats: Filament reads no pixels, so WebGL reads those of its canvas.
///
/// model   the address of a glTF model
export async function filamentStage(model, width_px, height_px) {
  const Filament = await filament;
  const canvas = Object.assign(document.createElement('canvas'), { width: width_px, height: height_px });
  const engine = Filament.Engine.create(canvas, { alpha: true });  // without, a canvas has no floats
  const gl = canvas.getContext('webgl2');
  gl.getExtension('EXT_color_buffer_float');
  gl.drawingBufferStorage(gl.RGBA16F, width_px, height_px);
  const swapChain = engine.createSwapChain();
  const renderer = engine.createRenderer();
  renderer.setClearOptions({ clearColor: [0, 0, 0, 1], clear: true });
  const scene = engine.createScene();
  const camera = engine.createCamera(Filament.EntityManager.get().create());
  camera.setExposureDirect(1);
  const view = engine.createView();
  view.setCamera(camera);
  view.setScene(scene);
  view.setViewport([0, 0, width_px, height_px]);
  view.setPostProcessingEnabled(false);  // and so the picture is linear light

  const asset = engine.createAssetLoader().createAsset(await bytesOf(model));
  await new Promise((resolve) => asset.loadResources(resolve, null, new URL(model, document.location).href));
  scene.addEntities(asset.getEntities());
  const renderables = engine.getRenderableManager();
  const material = renderables.getMaterialInstanceAt(renderables.getInstance(asset.getRenderableEntities()[0]), 0);

  /// The picture, RGBA from the lowest row.
  const drawn = async () => {
    // It leaves frames out while others are under way.
    while (!renderer.beginFrame(swapChain)) {
      engine.execute();
      await new Promise((resolve) => setTimeout(resolve, 1));
    }
    renderer.renderView(view);
    renderer.endFrame();
    engine.execute();
    const pixels = new Float32Array(4 * width_px * height_px);
    gl.readPixels(0, 0, width_px, height_px, gl.RGBA, gl.FLOAT, pixels);
    return pixels;
  };
  /// What a ball of our program's is made of.
  const setMaterial = ({ metallic, roughness, albedo }) => {
    material.setFloatParameter('metallicFactor', metallic);
    material.setFloatParameter('roughnessFactor', roughness);
    material.setFloat4Parameter('baseColorFactor', [albedo, albedo, albedo, 1]);
  };
  return { Filament, engine, scene, camera, drawn, setMaterial };
}
