#include "mirrorball/environment/load.h"

#include <array>
#include <filesystem>

#include "mirrorball/codec/codec.h"
#include "mirrorball/environment/builtin.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

/// Refuses, counts or mends texels that are NaN or infinite, as the options say.
Result<NonFinite> treatNonFinite(const std::string& name, Image& image, const EnvironmentLoadOptions& options) {
  const NonFinite bad = findNonFinite(image);
  if (bad.count == 0 || options.keep_bad) return bad;
  if (!options.repair)
    return fail(ErrorCode::non_finite, name + ": " + std::to_string(bad.count) +
                                           " texels are NaN or infinite, the first at (" + std::to_string(bad.first.x) +
                                           ", " + std::to_string(bad.first.y) +
                                           "); --repair replaces them by their neighbours");
  if (auto repaired = repairNonFinite(image); !repaired)
    return fail(repaired.error().code, name + ": " + repaired.error().message);
  return bad;
}

/// The six paths that a path to one face stands for; nothing when its name does not end in a face's suffix.
std::optional<std::array<fs::path, 6>> facePaths(const fs::path& path) {
  const std::string stem = path.stem().string();
  for (const std::string_view suffix : kFaceSuffixes) {
    if (!stem.ends_with("_" + std::string(suffix))) continue;
    const std::string base = stem.substr(0, stem.size() - suffix.size());
    std::array<fs::path, 6> paths;
    for (std::size_t face = 0; face < 6; ++face)
      paths[face] = path.parent_path() / (base + std::string(kFaceSuffixes[face]) + path.extension().string());
    return paths;
  }
  return std::nullopt;
}

Result<LoadedEnvironment> loadFaces(const std::string& name, const std::array<fs::path, 6>& paths,
                                    const EnvironmentLoadOptions& options, std::string told_by) {
  ImageSet faces(1, 6);
  Projection projection = Projection::cube;
  std::string format;
  NonFinite bad;
  for (int face = 0; face < 6; ++face) {
    const std::string path = paths[static_cast<std::size_t>(face)].string();
    MIRRORBALL_TRY(decoded, readImage(path));
    MIRRORBALL_TRY(bad_here, treatNonFinite(path, decoded.image, options));
    if (face == 0) projection = projectionOfFaces(decoded.metadata, options.from);
    if (bad.count == 0) bad.first = bad_here.first;
    bad.count += bad_here.count;
    const int side = face == 0 ? decoded.image.height() : faces.at(0, 0).height();
    if (decoded.image.width() != side || decoded.image.height() != side)
      return fail(ErrorCode::bad_shape, path + ": is " + std::to_string(decoded.image.width()) + "x" +
                                            std::to_string(decoded.image.height()) +
                                            ", and the six faces of a cube are squares of one size");
    if (face > 0 && decoded.image.channels() != faces.at(0, 0).channels())
      return fail(ErrorCode::bad_shape, path + ": has other colour channels than the cube's first face");
    faces.at(0, face) = std::move(decoded.image);
    format = decoded.format;
  }
  const glm::ivec2 size(faces.at(0, 0).width());
  return LoadedEnvironment{Environment(EnvironmentMap(projection, std::move(faces))),        name, std::move(format),
                           Recognition{{projection, CubeLayout::faces}, std::move(told_by)}, size, bad};
}

Result<LoadedEnvironment> loadPicture(const std::string& name, const EnvironmentLoadOptions& options) {
  MIRRORBALL_TRY(decoded, readImage(name));
  const glm::ivec2 size(decoded.image.width(), decoded.image.height());
  MIRRORBALL_TRY(recognition, recognize(name, size.x, size.y, decoded.metadata, options.from));
  MIRRORBALL_TRY(bad, treatNonFinite(name, decoded.image, options));
  auto map = mapOfPicture(std::move(decoded.image), recognition.form);
  if (!map) return fail(map.error().code, name + ": " + map.error().message);
  return LoadedEnvironment{Environment(std::move(*map)), name, decoded.format, recognition, size, bad};
}

}  // namespace

Result<LoadedEnvironment> loadEnvironment(const std::string& name_or_path, const EnvironmentLoadOptions& options) {
  std::error_code status;
  const bool exists = fs::exists(name_or_path, status);
  if (!exists && isBuiltinEnvironment(name_or_path)) {
    MIRRORBALL_TRY(environment, builtinEnvironment(name_or_path));
    return LoadedEnvironment{std::move(environment), name_or_path, "built in", std::nullopt, {}, {}};
  }
  const auto paths = facePaths(name_or_path);
  const bool faces_named = options.from.layout == CubeLayout::faces;
  const bool is_cube = !options.from.projection || faceCount(*options.from.projection) == 6;
  const bool may_be_faces = faces_named || (is_cube && !options.from.layout);
  if (paths && may_be_faces)
    return loadFaces(name_or_path, *paths, options,
                     faces_named || options.from.projection ? "--from" : "its name, one of six faces");
  if (faces_named)
    return fail(ErrorCode::usage,
                name_or_path + ": name one of the six faces, whose names end in _px _nx _py _ny _pz _nz");
  if (!exists) return tl::unexpected<Error>(noSuchEnvironment(name_or_path));
  return loadPicture(name_or_path, options);
}

}  // namespace mirrorball
