#include "mirrorball/environment/load.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "mirrorball/codec/codec.h"
#include "mirrorball/environment/builtin.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

/// Counts texels that are NaN or infinite, and refuses them unless the options say what to do.
Result<NonFinite> checkNonFinite(const std::string& name, const Image& image, const EnvironmentLoadOptions& options) {
  const NonFinite bad = findNonFinite(image);
  if (bad.count == 0 || options.keep_bad || options.repair) return bad;
  return fail(ErrorCode::non_finite, name + ": " + std::to_string(bad.count) +
                                         " texels are NaN or infinite, the first at (" + std::to_string(bad.first.x) +
                                         ", " + std::to_string(bad.first.y) +
                                         "); --repair replaces them by their neighbours");
}

/// Mends the faces, so that nothing from beside a face in its picture gets in.
Result<void> repairFaces(const std::string& name, EnvironmentMap& map) {
  for (int face = 0; face < map.faces(); ++face)
    if (auto repaired = repairNonFinite(map.face(face)); !repaired)
      return fail(repaired.error().code, name + ": " + repaired.error().message);
  return {};
}

/// Whatever a picture has beside its disc, no light comes from there.
void clearBesideDisc(Projection projection, Image& image) {
  if (!hasDisc(projection)) return;
  const glm::vec2 extent(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (!covers(projection, (glm::vec2(x, y) + 0.5f) / extent))
        std::fill_n(image.texel(x, y), image.channels(), 0.0f);
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
  std::string color;
  NonFinite bad;
  for (int face = 0; face < 6; ++face) {
    const std::string path = paths[static_cast<std::size_t>(face)].string();
    MIRRORBALL_TRY(decoded, readImage(path));
    MIRRORBALL_TRY(bad_here, checkNonFinite(path, decoded.image, options));
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
    color = decoded.color;
  }
  const glm::ivec2 size(faces.at(0, 0).width());
  EnvironmentMap cube(projection, std::move(faces));
  if (options.repair) MIRRORBALL_TRY_VOID(repairFaces(name, cube));
  return LoadedEnvironment{Environment(std::move(cube)),
                           name,
                           std::move(format),
                           std::move(color),
                           Recognition{{projection, CubeLayout::faces}, std::move(told_by)},
                           size,
                           bad,
                           {paths.begin(), paths.end()}};
}

Result<LoadedEnvironment> loadPicture(const std::string& name, const EnvironmentLoadOptions& options) {
  MIRRORBALL_TRY(decoded, readImage(name));
  const glm::ivec2 size(decoded.image.width(), decoded.image.height());
  MIRRORBALL_TRY(recognition, recognize(name, size.x, size.y, decoded.metadata, options.from));
  if (faceCount(recognition.form.projection) == 1) clearBesideDisc(recognition.form.projection, decoded.image);
  MIRRORBALL_TRY(bad, checkNonFinite(name, decoded.image, options));
  auto map = mapOfPicture(std::move(decoded.image), recognition.form);
  if (!map) return fail(map.error().code, name + ": " + map.error().message);
  if (options.repair) MIRRORBALL_TRY_VOID(repairFaces(name, *map));
  return LoadedEnvironment{
      Environment(std::move(*map)), name, decoded.format, decoded.color, recognition, size, bad, {name}};
}

}  // namespace

Result<LoadedEnvironment> loadEnvironment(const std::string& name_or_path, const EnvironmentLoadOptions& options) {
  std::error_code status;
  const bool exists = fs::exists(name_or_path, status);
  // A folder that happens to be called "studio" is no map.
  if (isBuiltinEnvironment(name_or_path) && (!exists || fs::is_directory(name_or_path, status))) {
    MIRRORBALL_TRY(environment, builtinEnvironment(name_or_path));
    return LoadedEnvironment{std::move(environment), name_or_path, "built in", "linear, Rec.709", std::nullopt, {}, {}};
  }
  const auto paths = facePaths(name_or_path);
  const bool faces_named = options.from.layout == CubeLayout::faces;
  // A name that only happens to end like a face's stands for itself.
  const bool has_siblings =
      paths && std::ranges::count_if(*paths, [](const fs::path& path) { return fs::exists(path); }) > 1;
  const bool is_cube = !options.from.projection || faceCount(*options.from.projection) == 6;
  const bool may_be_faces = faces_named || (has_siblings && is_cube && !options.from.layout);
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
