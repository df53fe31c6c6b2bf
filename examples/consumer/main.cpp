// Converts a panorama to a cube map, prefilters it for an engine, and renders a model in its light.
//
// usage: consumer PANORAMA MODEL FOLDER

#include <cstdio>
#include <string>

#include "mirrorball/mirrorball.h"

using namespace mirrorball;

namespace {

Result<void> run(const std::string& panorama, const std::string& model_name, const std::string& folder) {
  MIRRORBALL_TRY(room, loadEnvironment(panorama));
  MIRRORBALL_TRY(cube, convert(room, Projection::cube, 64));
  MIRRORBALL_TRY_VOID(saveMap(folder + "/room.ktx2", cube, {.mips = true}));
  MIRRORBALL_TRY(maps, bake(room, {.size = 64}));
  MIRRORBALL_TRY_VOID(saveMap(folder + "/specular.ktx2", maps.specular));
  MIRRORBALL_TRY(model, loadModel(model_name));  // a built-in's name too
  MIRRORBALL_TRY(renderer, Renderer::headless());
  MIRRORBALL_TRY_VOID(renderer.setScene(std::move(model)));
  MIRRORBALL_TRY_VOID(renderer.setEnvironment(std::move(room)));
  MIRRORBALL_TRY(frame, renderer.render({.size = {320, 180}}));
  return savePicture(folder + "/model.png", frame);
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fprintf(stderr, "usage: consumer PANORAMA MODEL FOLDER\n");
    return 2;
  }
  const Result<void> done = run(words[1], words[2], words[3]);
  if (!done) std::fprintf(stderr, "%s\n", done.error().message.c_str());
  return done ? 0 : 1;
}
