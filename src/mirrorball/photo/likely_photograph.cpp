#include "mirrorball/photo/likely_photograph.h"

#include <utility>

#include <glm/vec2.hpp>

#include "mirrorball/codec/exif.h"
#include "mirrorball/codec/header_size.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/row_reader.h"
#include "mirrorball/environment/file/photo_sphere.h"
#include "mirrorball/environment/file/recognize.h"

namespace mirrorball {
namespace {

/// Whether a picture of that size is no map by its shape, nor by what its file says.
bool hasNoMap(glm::ivec2 size, const Metadata& metadata) {
  for (const auto& [key, text] : metadata)
    if (key == "envmap" || key.starts_with("mirrorball:")) return false;
  return !recognize(size.x, size.y, {});
}

bool namesCamera(const Exif& exif) {
  return exif.exposure_time_s || exif.f_number || exif.iso || exif.focal_length_35mm;
}

}  // namespace

Result<bool> isLikelyPhotograph(const std::filesystem::path& path) {
  MIRRORBALL_TRY(rows, openRows(path));
  if (rows) return hasNoMap({rows->description().width, rows->description().height}, rows->description().metadata);
  MIRRORBALL_TRY(bytes, readImageFile(path));
  if (photoSphereIn(bytes)) return false;
  if (auto size = sizeInHeader(bytes)) {
    const Exif exif = readJpegExif(bytes);
    if (exif.orientation > 4) std::swap(size->x, size->y);  // rows are shown as columns
    const auto recognition = recognize(size->x, size->y, {});
    if (recognition && recognition->form.projection == Projection::equirect) return false;
    if (namesCamera(exif)) return true;
    if (recognition) return false;
  }
  MIRRORBALL_TRY(decoded, withName(path.string(), decodeImage(bytes)));
  return hasNoMap({decoded.image.width(), decoded.image.height()}, decoded.metadata);
}

}  // namespace mirrorball
