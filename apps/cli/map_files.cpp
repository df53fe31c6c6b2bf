#include "cli/map_files.h"

#include "cli/files.h"
#include "mirrorball/codec/codec.h"

namespace mirrorball::cli {

Result<void> writeMap(const EnvironmentMap& map, CubeLayout layout, bool half, const std::string& output) {
  ImageWriteOptions how{.half = half, .metadata = {}};
  how.metadata["mirrorball:projection"] = nameOf(map.projection());
  if (map.projection() != Projection::cube) return writeImage(output, map.face(0), how);
  how.metadata["mirrorball:layout"] = nameOf(layout);
  if (layout != CubeLayout::faces) return writeImage(output, composeLayout(map, layout), how);
  for (int face = 0; face < 6; ++face) {
    const std::string suffix = "_" + std::string(kFaceSuffixes[static_cast<std::size_t>(face)]);
    MIRRORBALL_TRY_VOID(writeImage(suffixed(output, suffix), map.face(face), how));
  }
  return {};
}

}  // namespace mirrorball::cli
