// What an occlusion cache's file holds, whose seal is right: damage is found by that, but not what another program
// writes under the same name.

#include "folder.h"
#include "fuzz.h"
#include "made_input.h"
#include "mirrorball/rays/occlusion_cache.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

MIRRORBALL_HARNESS(cache) {
  using namespace mirrorball;
  static const fuzz::Folder folder("mirrorball_cache");
  const CacheFolder files(folder.path());
  const std::string key(32, 'a');
  Scene scene = meshScene(cubeMesh());
  files.keep(key, CachedKind::occlusion, [&](const FileWriter& file) { return file.writeAt(0, {data, size}); });
  if (!OcclusionCache(files).find(key, size % 2 == 1, scene)) return 0;
  const Mesh& mesh = scene.meshes[0];
  const std::size_t known = scene.instances[0].occlusion.size();
  fuzz::check(known == 0 || known == mesh.vertices.size() || known == 2 * mesh.vertices.size(), "as many as vertices");
  for (const std::uint32_t index : mesh.indices) fuzz::check(index < mesh.vertices.size(), "indices are in range");
  return 0;
}
