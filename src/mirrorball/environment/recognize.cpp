#include "mirrorball/environment/recognize.h"

#include <algorithm>
#include <vector>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr const char* kProjectionKey = "mirrorball:projection";
constexpr const char* kLayoutKey = "mirrorball:layout";
constexpr const char* kBallDistanceKey = "mirrorball:ball_distance";

std::string sizeText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// "4:3" of a layout.
std::string proportionText(CubeLayout layout) {
  const glm::ivec2 cells = cellsOf(layout);
  return std::to_string(cells.x) + ":" + std::to_string(cells.y);
}

/// What the metadata says, as far as it says something that this program knows.
Result<FormHint> hintOfMetadata(const Metadata& metadata) {
  const auto find = [&](const char* key) {
    const auto entry = metadata.find(key);
    return entry == metadata.end() ? std::string() : entry->second;
  };
  FormHint hint;
  if (const std::string projection = find(kProjectionKey); !projection.empty()) {
    MIRRORBALL_TRY(named, projectionNamed(projection));
    hint.projection = named;
    if (const std::string distance = find(kBallDistanceKey); named == Projection::ball && !distance.empty()) {
      MIRRORBALL_TRY(ball, ballAtDistance(distance));
      hint.projection = ball;
    }
    if (const std::string layout = find(kLayoutKey); !layout.empty()) {
      MIRRORBALL_TRY(named_layout, cubeLayoutNamed(layout));
      if (named_layout == CubeLayout::faces)
        return fail(ErrorCode::bad_shape,
                    "is one face of a cube; the names of all six must end in _px _nx _py _ny _pz _nz");
      hint.layout = named_layout;
    }
  } else if (find("envmap") == "latlong") {
    hint.projection = Projection::equirect;
  } else if (find("envmap") == "cube") {
    return fail(ErrorCode::unsupported,
                "is a cube in OpenEXR's own arrangement (its envmap attribute), which this version does not read; "
                "convert it to latlong with exrenvmap");
  }
  return hint;
}

/// The form that a hint and the shape give together; the hint names a projection or a layout.
Result<MapForm> formOfHint(const FormHint& hint, int width, int height) {
  MapForm form;
  form.projection = hint.projection.value_or(Projection::cube);
  if (faceCount(form.projection) != 6) {
    const bool is_double = form.projection == Projection::equirect || form.projection == Projection::paraboloid;
    if (width == (is_double ? 2 : 1) * height) return form;
    return fail(ErrorCode::bad_shape, "is " + sizeText(width, height) + ", and a map of projection " +
                                          std::string(nameOf(form.projection)) +
                                          (is_double ? " is 2:1; crop or scale it" : " is square; crop it"));
  }

  const auto layout = hint.layout ? hint.layout : layoutOfShape(width, height);
  if (!layout)
    return fail(ErrorCode::bad_shape,
                "is " + sizeText(width, height) + ", which is no cube layout that is known (4:3 3:4 6:1 1:6 3:2)");
  form.layout = *layout;
  const glm::ivec2 cells = cellsOf(form.layout);
  if (width % cells.x != 0 || height % cells.y != 0 || width / cells.x != height / cells.y)
    return fail(ErrorCode::bad_shape, "is " + sizeText(width, height) + ", and the cube layout " +
                                          std::string(nameOf(form.layout)) + " is " + proportionText(form.layout));
  return form;
}

Result<Recognition> recognizeShape(int width, int height) {
  if (width == 2 * height) return Recognition{{Projection::equirect}, "its shape, 2:1"};
  if (width == height) return Recognition{{Projection::sphere}, "its shape, 1:1"};
  if (const auto layout = layoutOfShape(width, height))
    return Recognition{{Projection::cube, *layout}, "its shape, " + proportionText(*layout)};
  return fail(ErrorCode::bad_shape,
              "is " + sizeText(width, height) +
                  ", which is neither 2:1 (equirect) nor 1:1 (sphere) nor a cube layout (4:3 3:4 6:1 1:6 3:2); "
                  "crop it, or name its form with --from");
}

}  // namespace

Result<FormHint> formHintNamed(std::string_view name) {
  const auto projection = projectionNamed(name);
  if (projection) return FormHint{*projection, std::nullopt};
  if (name.find(':') != std::string_view::npos) return tl::unexpected<Error>(projection.error());
  if (const auto layout = cubeLayoutNamed(name)) return FormHint{std::nullopt, *layout};
  std::vector<std::string_view> all(projectionNames().begin(), projectionNames().end());
  all.insert(all.end(), cubeLayoutNames().begin(), cubeLayoutNames().end());
  return tl::unexpected<Error>(unknownName("projection or cube layout", name, all));
}

Metadata metadataOf(const MapForm& form) {
  Metadata metadata;
  metadata[kProjectionKey] = nameOf(form.projection);
  if (faceCount(form.projection) == 6) metadata[kLayoutKey] = nameOf(form.layout);
  if (form.projection == Projection::ball)
    metadata[kBallDistanceKey] = formatNumber(double(form.projection.ball_distance));
  return metadata;
}

Projection projectionOfFaces(const Metadata& metadata, const FormHint& hint) {
  if (hint.projection) return *hint.projection;
  const auto stated = metadata.find(kProjectionKey);
  const bool is_eac = stated != metadata.end() && stated->second == nameOf(Projection::eac);
  return is_eac ? Projection::eac : Projection::cube;
}

Result<Recognition> recognize(const std::string& name, int width, int height, const Metadata& metadata,
                              const FormHint& hint) {
  const auto named = [&](auto&& failed) { return fail(failed.error().code, name + ": " + failed.error().message); };
  if (hint.projection || hint.layout) {
    auto form = formOfHint(hint, width, height);
    if (!form) return named(form);
    return Recognition{*form, "--from"};
  }
  auto stated = hintOfMetadata(metadata);
  if (!stated) return named(stated);
  if (stated->projection) {
    auto form = formOfHint(*stated, width, height);
    if (!form) return named(form);
    return Recognition{*form, "the file's metadata"};
  }
  auto shape = recognizeShape(width, height);
  if (!shape) return named(shape);
  return shape;
}

}  // namespace mirrorball
