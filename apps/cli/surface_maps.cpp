#include "cli/surface_maps.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "cli/picture_remarks.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/height_field/heights_from_normals.h"
#include "mirrorball/height_field/maximum_pyramid.h"
#include "mirrorball/height_field/occlusion.h"
#include "mirrorball/height_field/slopes.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/relief/height_texture.h"
#include "mirrorball/transfer/normal_space.h"

namespace mirrorball::cli {
namespace {

/// The heights of a picture; says where its channels differ.
Image heightsOf(Image numbers, const std::string& input) {
  PictureHeights of_picture = heightsOfPicture(std::move(numbers));
  if (!of_picture.is_grey) remark(input + ": is in colour; its red channel is taken for the heights");
  return std::move(of_picture.heights);
}

/// Heights from 0 on; without a scale that was asked for up to 1, and the scale that belongs to them.
Result<MadeMap> heightsOfNormals(Image normals, const SurfaceOptions& options) {
  if (options.directx) flipGreen(normals);
  HeightFieldSettings settings = options.field;
  if (!options.has_scale) settings.scale = 1.0f;
  MIRRORBALL_TRY(heights, heightsFromNormals(normals, settings, progressBar("heights")));
  const auto [low, high] = std::ranges::minmax(heights.samples());
  const float range = high - low;
  const float unit = options.has_scale || range == 0.0f ? 1.0f : range;
  for (float& height : heights.samples()) height = (height - low) / unit;
  MadeMap map{ImageSet(std::move(heights)), false};
  if (!options.has_scale) map.scale = range;
  return map;
}

Result<MadeMap> mapOfHeights(const Image& heights, const SurfaceOptions& options) {
  const MapEdges edges = options.field.edges;
  const auto single = [](Image image, bool is_signed) { return MadeMap{ImageSet(std::move(image)), is_signed}; };
  switch (options.to) {
    case SurfaceMap::derivative: {
      MIRRORBALL_TRY(slopes, derivativesFromHeights(heights, options.field, progressBar("slopes")));
      return single(std::move(slopes), true);
    }
    case SurfaceMap::cone: {
      MIRRORBALL_TRY(cones, coneMap(heights, options.cones, edges, progressBar("cones")));
      return single(std::move(cones), false);
    }
    case SurfaceMap::pyramid: {
      MIRRORBALL_TRY(pyramid, maximumPyramid(heights, edges, progressBar("pyramid")));
      return MadeMap{std::move(pyramid)};
    }
    case SurfaceMap::occlusion:
    case SurfaceMap::bent_normal: {
      MIRRORBALL_TRY(seen, occlusionOf(heights, options.field, 8 << options.azimuths, progressBar("occlusion")));
      if (options.to == SurfaceMap::occlusion) return single(std::move(seen.visible), false);
      if (options.directx) flipGreen(seen.bent_normals);
      return single(std::move(seen.bent_normals), true);
    }
    case SurfaceMap::normal:
    case SurfaceMap::height:
    case SurfaceMap::object_normal:
    case SurfaceMap::tangent_normal:
      break;
  }
  MIRRORBALL_TRY(normals, normalsFromHeights(heights, options.field, progressBar("normals")));
  if (options.directx) flipGreen(normals);
  return single(std::move(normals), true);
}

/// A normal map of a model in the other space; one of tangents has green up or down.
///
/// input    its name
/// errors   as loadModel's and normalsInSpace's
Result<MadeMap> normalsOfModel(Image normals, const std::string& input, const SurfaceOptions& options) {
  const bool to_object = options.to == SurfaceMap::object_normal;
  MIRRORBALL_TRY(model, loadModel(options.model, {.inside_only = options.inside_only}));
  for (const std::string& warning : model.warnings) remark(warning);
  // What is wrong with the model is said under its name, before the map is looked at.
  MIRRORBALL_TRY(surface, withName(options.model, MappedSurface::make(model)));
  MIRRORBALL_TRY_VOID(withName(options.model, TexelCover::make(surface.uvTriangles(), {1, 1}, 1)));
  if (options.directx && to_object) flipGreen(normals);
  const NormalSpace space = to_object ? NormalSpace::object : NormalSpace::tangent;
  MIRRORBALL_TRY(turned, withName(input, normalsInSpace(normals, model, space, progressBar("normals"))));
  if (options.directx && !to_object) flipGreen(turned);
  return MadeMap{ImageSet(std::move(turned)), true};
}

/// A built-in surface by its name.
std::optional<HeightKind> builtinHeightsNamed(const std::string& name) {
  const auto names = builtinHeightNames();
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<HeightKind>(found - names.begin() + static_cast<std::ptrdiff_t>(HeightKind::orange));
}

}  // namespace

Result<MadeMap> makeSurfaceMap(const std::string& input, const SurfaceOptions& options) {
  constexpr int kBuiltinSide = 1024;
  if (const auto kind = builtinHeightsNamed(input); kind && options.model.empty()) {
    Image heights = builtinHeights(*kind, kBuiltinSide);
    if (options.to == SurfaceMap::height) return MadeMap{ImageSet(std::move(heights)), false};
    return withName(input, mapOfHeights(heights, options));
  }
  MIRRORBALL_TRY(bytes, readImageFile(input));
  if (!isOfNormals(options.to)) {
    MIRRORBALL_TRY(read, withName(input, decodeNumbers(bytes, {.layer = options.layer,
                                                               .progress = progressBar("reading " + shown(input))})));
    remarkOnPicture(input, read);
    return withName(input, mapOfHeights(heightsOf(std::move(read.picture), input), options));
  }
  MIRRORBALL_TRY(normals, withName(input, readNormals(input, bytes, options.layer)));
  if (options.to != SurfaceMap::height) return normalsOfModel(std::move(normals), input, options);
  return withName(input, heightsOfNormals(std::move(normals), options));
}

}  // namespace mirrorball::cli
