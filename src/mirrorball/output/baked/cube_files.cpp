#include "mirrorball/output/baked/cube_files.h"

#include <utility>

#include "mirrorball/codec/texture/stored_format.h"

namespace mirrorball {
namespace {

/// One level as a cube of its own.
EnvironmentMap levelOf(ImageSet& levels, int level) {
  ImageSet images(1, 6);
  for (int face = 0; face < 6; ++face) images.at(0, face) = std::move(levels.at(level, face));
  return {Projection::cube, std::move(images)};
}

}  // namespace

Result<CubeFiles> CubeFiles::resolve(const MapFileOptions& options, const std::string& folder, const CubeNames& names,
                                     std::string_view extension, int levels, const Observer& observer) {
  const std::string ending = "." + std::string(extension);
  CubeFiles files;
  const auto add = [&](const std::string& name, std::optional<CubeLayout> layout) -> Result<void> {
    MapFileOptions one = options;
    one.layout = layout;
    MIRRORBALL_TRY(output, MapFile::resolve(folder + "/" + name + ending, one, Projection::cube, observer));
    files.outputs_.push_back(std::move(output));
    return {};
  };
  if (isTexturePath(names.texture + ending)) {
    MIRRORBALL_TRY_VOID(add(names.texture, std::nullopt));
    return files;
  }
  for (int level = 0; level < levels; ++level)
    MIRRORBALL_TRY_VOID(add(names.picture + (names.has_levels ? std::to_string(level) : ""), CubeLayout::faces));
  return files;
}

Result<CubeFiles> CubeFiles::resolve(const MapFileOptions& options, const std::string& path, const Observer& observer) {
  CubeFiles files;
  MIRRORBALL_TRY(output, MapFile::resolve(path, options, Projection::cube, observer));
  files.outputs_.push_back(std::move(output));
  return files;
}

std::vector<std::string> CubeFiles::paths() const {
  std::vector<std::string> all;
  for (const MapFile& output : outputs_)
    for (std::string& path : output.paths()) all.push_back(std::move(path));
  return all;
}

Result<std::string> CubeFiles::write(ImageSet levels, const Metadata& facts,
                                     const std::function<Result<void>()>& go_on) const {
  if (isTexture()) {
    MIRRORBALL_TRY(format, outputs_.front().writeLevels(std::move(levels), facts));
    return formatName(storedFormat(format));
  }
  for (int level = 0; level < levels.levels(); ++level) {
    if (level > 0) MIRRORBALL_TRY_VOID(go_on());
    MIRRORBALL_TRY_VOID(outputs_[static_cast<std::size_t>(level)].write(levelOf(levels, level)));
  }
  return outputs_.front().pictureFormat();
}

}  // namespace mirrorball
