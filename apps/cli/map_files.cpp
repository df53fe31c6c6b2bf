#include "cli/map_files.h"

#include "cli/files.h"
#include "mirrorball/codec/codec.h"
#include "mirrorball/environment/picture.h"
#include "mirrorball/environment/recognize.h"

namespace mirrorball::cli {

Result<void> writeMap(const EnvironmentMap& map, CubeLayout layout, bool half, const std::string& output) {
  const MapForm form{map.projection(), layout};
  const ImageWriteOptions how{.half = half, .metadata = metadataOf(form)};
  if (map.faces() != 6 || layout != CubeLayout::faces) return writeImage(output, pictureOf(map, form), how);
  for (int face = 0; face < 6; ++face) {
    const std::string suffix = "_" + std::string(kFaceSuffixes[static_cast<std::size_t>(face)]);
    MIRRORBALL_TRY_VOID(writeImage(suffixed(output, suffix), map.face(face), how));
  }
  return {};
}

}  // namespace mirrorball::cli
