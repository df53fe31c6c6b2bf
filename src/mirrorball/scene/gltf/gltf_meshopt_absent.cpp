// A build without meshoptimizer.
#include "mirrorball/base/left_out.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/gltf/gltf_meshopt.h"

namespace mirrorball::gltf {

Result<void> decodeMeshopt(File& file) {
  const std::vector<BufferView>& views = file.document.buffer_views;
  const auto compressed =
      std::find_if(views.begin(), views.end(), [](const BufferView& view) { return view.compression.has_value(); });
  if (compressed == views.end()) return {};
  return withName(quoted("bufferViews", std::size_t(compressed - views.begin())),
                  Result<void>(leftOut("reads no meshes compressed by meshoptimizer", "MIRRORBALL_MESHOPTIMIZER")));
}

}  // namespace mirrorball::gltf
