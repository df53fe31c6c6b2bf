#pragma once

#include "fuzz.h"
#include "mirrorball/scene/animation/pose.h"
#include "mirrorball/scene/bodies/body_tree.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_writer.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/scene/tangents.h"

namespace mirrorball::fuzz {

/// What becomes of a model that loadModel takes: trees for rays, a file that is read again, and tangents. Larger ones
/// than these take too long.
inline void follow(Scene scene) {
  constexpr std::size_t kMostIndices = 30'000;
  std::size_t indices = 0;
  for (const Instance& instance : scene.instances) indices += scene.meshes[std::size_t(instance.mesh)]->indices.size();
  if (!checkExtent(scene) || indices > kMostIndices) return;
  for (const auto& tree : {bodyTree(scene), triangleTree(scene)})
    if (!tree) checkLine(tree.error().message);
  const auto written = encodeGlb(scene);
  if (written) {
    for (const std::string& line : written->left_out) checkLine(line);
    const auto again = decodeGltf(written->bytes, "again.glb");
    if (!again) {
      std::fprintf(stderr, "what was written is refused: %s\n", again.error().message.c_str());
      std::abort();
    }
  } else {
    checkLine(written.error().message);
  }
  for (Shared<Mesh>& mesh : scene.meshes) computeTangents(mesh.edit());
}

/// What every reader of models owes its caller: lines for what it refuses and for what it leaves out, and scenes that
/// all that follows can take.
inline void checkModel(const Result<Scene>& scene) {
  checkError(scene);
  if (!scene) return;
  for (const std::string& warning : scene->warnings) checkLine(warning);
  follow(*scene);
  // What its first animation shows in the middle.
  if (scene->rig.animations.empty()) return;
  const auto moment = posed(*scene, 0, double(scene->rig.animations[0].length_s) / 2.0);
  checkError(moment);
  if (moment) follow(*moment);
}

}  // namespace mirrorball::fuzz
