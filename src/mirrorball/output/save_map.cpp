#include "mirrorball/output/save_map.h"

#include <utility>

#include "mirrorball/codec/image_format.h"

namespace mirrorball {

Result<SavedMap> saveMap(const std::string& path, EnvironmentMap map, const MapFileOptions& options,
                         const Observer& observer) {
  SavedMap saved;
  limitLight(map, options.light);
  MIRRORBALL_TRY(file, MapFile::resolve(path, options, map.projection(), observer.keeping(saved.remarks)));
  file.tellIfNotImported();
  MIRRORBALL_TRY_VOID(file.write(std::move(map)));
  saved.paths = file.paths();
  return saved;
}

Result<SavedMap> saveMap(const std::string& path, ImageSet levels, const MapFileOptions& options,
                         const Observer& observer) {
  if (!isTexturePath(path))
    return fail(ErrorCode::usage,
                path + ": a chain of mip levels goes into " + writtenExtensions(Holds::texture, " or "));
  SavedMap saved;
  MIRRORBALL_TRY(file, MapFile::resolve(path, options, Projection::cube, observer.keeping(saved.remarks)));
  MIRRORBALL_TRY_VOID(file.writeLevels(std::move(levels)));
  file.remarkOnForm();
  saved.paths = file.paths();
  return saved;
}

}  // namespace mirrorball
