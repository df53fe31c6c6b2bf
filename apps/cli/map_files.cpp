#include "cli/map_files.h"

#include "cli/files.h"
#include "cli/terminal.h"
#include "mirrorball/codec/codec.h"
#include "mirrorball/environment/face_files.h"
#include "mirrorball/environment/picture.h"
#include "mirrorball/environment/recognize.h"

namespace mirrorball::cli {

std::vector<std::string> mapPaths(const std::string& output, Projection projection, CubeLayout layout) {
  if (faceCount(projection) != 6 || layout != CubeLayout::faces) return {output};
  std::vector<std::string> paths;
  for (const std::string_view ending : endingsOf(FaceNaming::px))
    paths.push_back(suffixed(output, "_" + std::string(ending)));
  return paths;
}

Result<void> writeMap(const EnvironmentMap& map, CubeLayout layout, bool half, const std::string& output) {
  const MapForm form{map.projection(), layout};
  const ImageWriteOptions how{.half = half, .metadata = metadataOf(form)};
  const std::vector<std::string> paths = mapPaths(output, map.projection(), layout);
  for (std::size_t face = 0; face < paths.size(); ++face) {
    // Only several faces in one picture have to be laid out first.
    const bool is_whole = paths.size() > 1 || map.faces() == 1;
    MIRRORBALL_TRY_VOID(is_whole ? writeImage(paths[face], map.face(static_cast<int>(face)), how)
                                 : writeImage(paths[face], pictureOf(map, form), how));
    announce(paths[face]);
  }
  return {};
}

}  // namespace mirrorball::cli
