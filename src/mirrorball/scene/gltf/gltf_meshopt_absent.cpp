// A build without meshoptimizer.
#include "mirrorball/base/left_out.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/gltf/gltf_meshopt.h"

namespace mirrorball::gltf {

Result<void> decodeMeshopt(File& file) {
  for (std::size_t i = 0; i < file.document.buffer_views.size(); ++i)
    if (BufferView& view = file.document.buffer_views[i]; view.compression)
      loseView(file, view,
               withName(quoted("bufferViews", i),
                        leftOut("reads no meshes compressed by meshoptimizer", "MIRRORBALL_MESHOPTIMIZER").value()));
  return {};
}

}  // namespace mirrorball::gltf
