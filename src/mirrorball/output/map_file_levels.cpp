// The mip levels of a map that is written: which there are, and how pictures show them.

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/bake/prefilter/mip_chain.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/file/recognize.h"
#include "mirrorball/image/level_sheet.h"
#include "mirrorball/output/map_file.h"

namespace mirrorball {
namespace {

/// One level of a set that is not needed any more.
ImageSet takeLevel(ImageSet& levels, int level) {
  ImageSet one(1, levels.faces());
  for (int face = 0; face < one.faces(); ++face) one.at(0, face) = std::move(levels.at(level, face));
  return one;
}

}  // namespace

Result<void> MapFile::setLevels(const MapFileOptions& options) {
  all_levels_ = options.mips;
  level_ = options.level;
  mip_source_ = options.mip_source;
  if (!hasLevels()) return {};
  if (hasDisc(form_.projection))
    return fail(ErrorCode::usage, "mip levels of " + std::string(nameOf(form_.projection)) +
                                      " would mix in what lies beside the disc; a cube or a panorama has none such");
  if (form_.has_texels_on_edges)
    return fail(ErrorCode::usage, "OpenEXR's texels on the edges are of a whole map; mip levels are not for openexr");
  return {};
}

Result<void> MapFile::checkLevel(int levels) const {
  if (!level_ || *level_ < levels) return {};
  return fail(ErrorCode::usage,
              path_ + ": there is no level " + std::to_string(*level_) + "; the last is " + std::to_string(levels - 1));
}

Result<void> MapFile::checkLevelOfSize(int size) const {
  const glm::ivec2 extent = imageSize(form_.projection, size);
  return checkLevel(levelCount(std::max(extent.x, extent.y)));
}

Result<ImageSet> MapFile::wantedOf(ImageSet levels) const {
  if (!level_) return levels;
  MIRRORBALL_TRY_VOID(checkLevel(levels.levels()));
  return takeLevel(levels, *level_);
}

Result<ImageSet> MapFile::levelsOf(EnvironmentMap map) const {
  const glm::ivec2 extent = map.extent();
  MIRRORBALL_TRY_VOID(withName(path_, checkMemory(std::uint64_t(extent.x) * std::uint64_t(extent.y) *
                                                  std::uint64_t(map.faces()) * 3 * sizeof(float) * 7 / 3)));
  const MipWeights weights = mip_source_ == MipSource::box ? MipWeights::box : MipWeights::solid_angle;
  const bool is_cube = map.faces() == 6;
  ImageSet levels = is_cube ? mipChain(std::move(map), weights)
                            : mipChain(EnvironmentMap(form_.projection, imagesOf(std::move(map), form_)), weights);
  limitLevels(levels);  // the mean of the greatest values may be a rounding error above them
  return wantedOf(is_cube ? arranged(std::move(levels), form_.arrangement) : std::move(levels));
}

Image MapFile::pictureFor(ImageSet& images, std::size_t file) const {
  std::vector<Image> levels;
  for (int level = 0; level < images.levels(); ++level)
    levels.push_back(paths().size() > 1 ? std::move(images.at(level, static_cast<int>(file)))
                                        : pictureOfImages(takeLevel(images, level), form_));
  return levels.size() > 1 ? levelSheet(levels) : std::move(levels.front());
}

Result<void> MapFile::writePictures(ImageSet images) const {
  ImageSet light = gain_map_ ? images : ImageSet(Image());
  if (display_ != Display{}) forEachImage(images, [&](Image& image) { showOn(display_, image); });
  if (!storesLinearLight(path_)) forEachImage(images, [&](Image& image) { convertFromRec709(image, primaries_); });
  const bool is_sheet = all_levels_ && images.levels() > 1;
  const ImageWriteOptions how{
      .half = half_, .metadata = is_sheet ? metadataOfLevelSheet() : metadataOf(form_), .primaries = primaries_};
  const std::vector<std::string> files = paths();
  for (std::size_t file = 0; file < files.size(); ++file) {
    const Image picture = pictureFor(images, file);
    MIRRORBALL_TRY_VOID(gain_map_
                            ? savePictureWithGainMap(files[file], pictureFromLinear(picture, 3),
                                                     lightOnDisplay(display_, pictureFor(light, file)), how.metadata)
                            : writeImage(files[file], picture, how));
    observer_.tellWritten(files[file]);
  }
  return {};
}

}  // namespace mirrorball
