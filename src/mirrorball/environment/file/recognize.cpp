#include "mirrorball/environment/file/recognize.h"

#include <algorithm>
#include <vector>

#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr const char* kProjectionKey = "mirrorball:projection";
constexpr const char* kLayoutKey = "mirrorball:layout";
constexpr const char* kBallDistanceKey = "mirrorball:ball_distance";
constexpr const char* kArrangementKey = "mirrorball:arrangement";
constexpr const char* kCentreKey = "mirrorball:centre";
constexpr const char* kTexelsKey = "mirrorball:texels";
constexpr const char* kTexelsOnEdges = "on-edges";
constexpr const char* kEnvmapKey = "envmap";
constexpr const char* kSheetKey = "mirrorball:sheet";
constexpr const char* kBrdfTableValue = "brdf";
constexpr const char* kLobeRowsValue = "lobe rows";

bool isTable(const Metadata& metadata, std::string_view value) {
  const auto said = metadata.find(kTableKey);
  return said != metadata.end() && said->second == value;
}

/// "4:3" of a layout.
std::string proportionText(CubeLayout layout) {
  const glm::ivec2 cells = cellsOf(layout);
  return std::to_string(cells.x) + ":" + std::to_string(cells.y);
}

bool isCube(const FormHint& hint) { return hint.namesForm() && hint.allowsCube(); }

/// The axis in the middle of a panorama.
Result<SignedAxis> centreNamed(std::string_view name) {
  MIRRORBALL_TRY(axis, signedAxisNamed(name));
  if (vectorOf(axis).y == 0.0f) return axis;
  return fail(ErrorCode::usage,
              "the centre of a panorama is on the horizon: +x, -x, +z or -z, not " + std::string(nameOf(axis)));
}

/// Takes up what a program's preset says of the hint's projection.
Result<void> applyPreset(std::string_view name, FormHint& hint) {
  MIRRORBALL_TRY(preset, presetNamed(name));
  MIRRORBALL_TRY(form, formFor(preset, hint.projection.value_or(Projection::cube), preset.layout));
  hint.arrangement = form.arrangement;
  hint.centre = form.centre;
  hint.has_texels_on_edges = form.has_texels_on_edges;
  return {};
}

/// Takes up one word about a panorama.
Result<void> applyPanoramaWord(const std::string& word, const std::string& value, FormHint& hint) {
  if (word.starts_with("centre=") || word.starts_with("center=")) {
    MIRRORBALL_TRY(centre, centreNamed(value));
    hint.centre = centre;
  } else if (word == "crop=none") {
    hint.is_whole = true;
  } else if (word.starts_with("crop=") || word.starts_with("fov=")) {
    MIRRORBALL_TRY(part, panoramaPartNamed(word));
    hint.part = part;
  } else if (word == "fill=smooth" || word == "fill=black") {
    hint.rest = value == "smooth" ? PanoramaRest::smooth : PanoramaRest::black;
  } else if (word == "level=no" || word == "level=yes") {
    hint.stays_tilted = value == "no";
  } else if (const auto half = std::find(kPictureHalfNames.begin(), kPictureHalfNames.end(), value);
             word.starts_with("eye=") && half != kPictureHalfNames.end()) {
    hint.eye = static_cast<PictureHalf>(half - kPictureHalfNames.begin());
  } else {
    return fail(ErrorCode::usage,
                "'" + excerpt(word) +
                    "' says nothing of a map of projection equirect; for=PROGRAM, centre=AXIS, "
                    "crop=X,Y,W,H/FULLWxFULLH or crop=none, fov=HxV, fill=smooth or fill=black, level=no, and "
                    "eye=top, bottom, left or right do");
  }
  return {};
}

/// Whether a value in double quotes has its first one alone: layer="key
bool isOpen(std::string_view word) {
  const std::size_t quote = word.find("=\"");
  return quote != std::string_view::npos && (word.size() == quote + 2 || !word.ends_with('"'));
}

/// Words with commas between. A number after a comma goes on with the word before it: "crop=0,256,2048,512/2048x1024",
/// and so does all that is in double quotes: layer="key,fill".
std::vector<std::string> wordsIn(std::string_view text) {
  std::vector<std::string> words;
  for (const std::string& part : split(text, ',')) {
    const std::size_t digit = part.starts_with('-') ? 1 : 0;
    const bool is_number = digit < part.size() && part[digit] >= '0' && part[digit] <= '9';
    if (!words.empty() && (is_number || isOpen(words.back())))
      words.back() += "," + part;
    else
      words.push_back(part);
  }
  return words;
}

/// Refuses what words say against each other.
Result<void> checkPanorama(const FormHint& hint) {
  if (hint.is_whole && hint.part)
    return fail(ErrorCode::usage, "crop=none says that the picture shows the whole panorama, and another word a part");
  if (hint.has_texels_on_edges && (hint.part || hint.rest))
    return fail(ErrorCode::usage, "a panorama with OpenEXR's texels is whole: leave crop, fov and fill out");
  return {};
}

/// Takes up one word of those after the colon.
Result<void> applyWord(const std::string& word, FormHint& hint) {
  const std::string key = word.substr(0, word.find('='));
  const std::string value = key.size() < word.size() ? word.substr(key.size() + 1) : std::string();
  if (!hint.namesForm())
    return fail(ErrorCode::usage, "'" + excerpt(word) + "' needs the form before it, as in equirect:" + excerpt(word));
  if (hint.fisheye) return applyDualFisheyeWord(word, *hint.fisheye);
  if (key == "for") return applyPreset(value, hint);
  if (hint.projection == Projection::equirect) return applyPanoramaWord(word, value, hint);
  if (!isCube(hint))
    return fail(ErrorCode::usage, "'" + excerpt(word) + "' says nothing of a map of projection " +
                                      std::string(nameOf(*hint.projection)) + ", which takes no parameters");
  if (key == "layout" && hint.projection) {
    MIRRORBALL_TRY(layout, cubeLayoutNamed(value));
    hint.layout = layout;
    return {};
  }
  MIRRORBALL_TRY(arrangement, rearranged(hint.arrangement, word));
  hint.arrangement = arrangement;
  return {};
}

/// The value of the word that names a layer, which every form may have; the word is taken out.
Result<std::string> takeLayer(std::vector<std::string>& words) {
  constexpr std::string_view kLayerKey = "layer=";
  std::string layer;
  for (const std::string& word : words) {
    if (!word.starts_with(kLayerKey)) continue;
    if (isOpen(word)) return fail(ErrorCode::usage, "'" + excerpt(word) + "' lacks its second quotation mark");
    const bool is_second = !layer.empty();
    layer = word.substr(kLayerKey.size());
    if (layer.size() > 1 && layer.starts_with('"') && layer.ends_with('"')) layer = layer.substr(1, layer.size() - 2);
    if (layer.empty() || is_second)
      return fail(ErrorCode::usage, "'" + excerpt(word) + "' should name one layer, as in layer=rgba");
  }
  std::erase_if(words, [&](const std::string& word) { return word.starts_with(kLayerKey); });
  return layer;
}

/// What OpenEXR's own attribute says: its registration, and a cube's faces in a strip downwards.
Result<FormHint> hintOfEnvmap(const std::string& envmap) {
  if (envmap == "latlong") return formHintNamed("equirect:for=openexr");
  if (envmap == "cube") return formHintNamed("cube:layout=vstrip,for=openexr");
  return FormHint{};
}

/// What the metadata says, as far as it says something that this program knows.
Result<FormHint> hintOfMetadata(const Metadata& metadata) {
  const auto find = [&](const char* key) {
    const auto entry = metadata.find(key);
    return entry == metadata.end() ? std::string() : entry->second;
  };
  const std::string projection = find(kProjectionKey);
  if (projection.empty()) return hintOfEnvmap(find(kEnvmapKey));
  FormHint hint;
  MIRRORBALL_TRY(named, projectionNamed(projection));
  hint.projection = named;
  if (const std::string distance = find(kBallDistanceKey); named == Projection::ball && !distance.empty()) {
    MIRRORBALL_TRY(ball, ballAtDistance(distance));
    hint.projection = ball;
  }
  if (const std::string layout = find(kLayoutKey); !layout.empty()) {
    MIRRORBALL_TRY(named_layout, cubeLayoutNamed(layout));
    hint.layout = named_layout;
  }
  if (const std::string arrangement = find(kArrangementKey); faceCount(named) == 6 && !arrangement.empty()) {
    MIRRORBALL_TRY(frames, rearranged(CubeArrangement{}, arrangement));
    hint.arrangement = frames;
  }
  if (const std::string centre = find(kCentreKey); named == Projection::equirect && !centre.empty()) {
    MIRRORBALL_TRY(axis, centreNamed(centre));
    hint.centre = axis;
  }
  const bool may_lie_on_edges = named == Projection::cube || named == Projection::equirect;
  hint.has_texels_on_edges = may_lie_on_edges && find(kTexelsKey) == kTexelsOnEdges;
  return hint;
}

/// A form of which a hint says all but a cube's layout.
MapForm formWith(const FormHint& hint, Projection projection, CubeLayout layout) {
  return {projection, layout, hint.arrangement, hint.centre, hint.has_texels_on_edges};
}

/// What to say of a picture that may be a part of a panorama.
constexpr std::string_view kHowToNamePart =
    "a part of a panorama is named by equirect:fov=HxV, in degrees around its middle, or "
    "equirect:crop=X,Y,W,H/FULLWxFULLH";

/// Whether a picture may be the panorama that a hint says it is, or its part.
Result<void> checkPanoramaShape(const FormHint& hint, glm::ivec2 size) {
  const bool is_right = hint.part ? heightOfWhole(size, *hint.part).has_value() : isNearlyWholePanorama(size);
  if (is_right) return {};
  if (hint.fisheye)
    return fail(ErrorCode::bad_shape,
                "is " + sizeText(size) + ", and two fisheye circles side by side are 2:1; crop it to them");
  if (!hint.part)
    return fail(ErrorCode::bad_shape, "is " + sizeText(size) +
                                          ", and a map of projection equirect is 2:1; crop or scale it, or " +
                                          std::string(kHowToNamePart));
  const glm::dvec2 extent = hint.part->end - hint.part->begin;
  return fail(ErrorCode::bad_shape, "is " + sizeText(size) + ", and " + textOf(*hint.part) + " of a panorama are " +
                                        formatNumber(2.0 * extent.x / extent.y) + ":1");
}

/// The form that a hint and the shape give together; the hint names a projection or a layout.
Result<MapForm> formOfHint(const FormHint& hint, int width, int height) {
  MapForm form = formWith(hint, hint.projection.value_or(Projection::cube), CubeLayout::hcross);
  if (faceCount(form.projection) != 6) {
    if (form.projection == Projection::equirect && !form.has_texels_on_edges) {
      MIRRORBALL_TRY_VOID(checkPanoramaShape(hint, {width, height}));
      return form;
    }
    const bool is_double = form.projection == Projection::equirect || form.projection == Projection::paraboloid;
    if (width == (is_double ? 2 : 1) * height) return form;
    return fail(ErrorCode::bad_shape, "is " + sizeText({width, height}) + ", and a map of projection " +
                                          std::string(nameOf(form.projection)) +
                                          (is_double ? " is 2:1; crop or scale it" : " is square; crop it"));
  }

  const auto layout = hint.layout ? hint.layout : layoutOfShape(width, height);
  if (!layout)
    return fail(ErrorCode::bad_shape,
                "is " + sizeText({width, height}) + ", which is no cube layout that is known (4:3 3:4 6:1 1:6 3:2)");
  form.layout = *layout;
  const glm::ivec2 cells = cellsOf(form.layout);
  if (width % cells.x != 0 || height % cells.y != 0 || width / cells.x != height / cells.y)
    return fail(ErrorCode::bad_shape, "is " + sizeText({width, height}) + ", and the cube layout " +
                                          std::string(nameOf(form.layout)) + " is " + proportionText(form.layout));
  return form;
}

Result<Recognition> recognizeShape(int width, int height) {
  if (width == 2 * height)
    return Recognition{.form = {Projection::equirect}, .told_by = "its shape, 2:1", .is_by_shape = true};
  if (width == height)
    return Recognition{.form = {Projection::sphere}, .told_by = "its shape, 1:1", .is_by_shape = true};
  if (const auto layout = layoutOfShape(width, height))
    return Recognition{{Projection::cube, *layout}, "its shape, " + proportionText(*layout), true, true};
  if (isNearlyWholePanorama({width, height}))
    return Recognition{.form = {Projection::equirect}, .told_by = "its shape, nearly 2:1", .is_by_shape = true};
  return fail(ErrorCode::bad_shape,
              "is " + sizeText({width, height}) +
                  ", which is neither 2:1 (equirect) nor 1:1 (sphere) nor a cube layout (4:3 3:4 6:1 1:6 3:2); " +
                  (width > height ? std::string(kHowToNamePart) + "; crop it" : "crop it"),
              FixHint::name_form);
}

}  // namespace

std::span<const std::string_view> readFormNames() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all(projectionNames().begin(), projectionNames().end());
    all.push_back(kDualFisheyeName);
    return all;
  }();
  return names;
}

Result<FormHint> formHintNamed(std::string_view name) {
  if (name.empty()) return FormHint{};
  // Without a form there are words alone: "layer=rgba".
  const bool has_form = name.substr(0, name.find(':')).find('=') == std::string_view::npos;
  const std::string_view base = has_form ? name.substr(0, name.find(':')) : std::string_view();
  std::vector<std::string> words;
  if (base.size() < name.size()) words = wordsIn(name.substr(has_form ? base.size() + 1 : 0));
  FormHint hint;
  MIRRORBALL_TRY(layer, takeLayer(words));
  hint.layer = std::move(layer);
  hint.swaps_red_and_blue = std::erase(words, "swap=rb") > 0;
  const auto projection = projectionNamed(base);
  if (projection && *projection == Projection::ball) {
    MIRRORBALL_TRY(ball,
                   projectionNamed(words.empty() ? std::string(base) : std::string(base) + ":" + join(words, ",")));
    hint.projection = ball;
    return hint;
  }
  if (projection) {
    hint.projection = *projection;
  } else if (const auto layout = cubeLayoutNamed(base)) {
    hint.layout = *layout;
  } else if (base == kDualFisheyeName) {
    hint.projection = Projection::equirect;
    hint.fisheye = DualFisheye{};
  } else if (has_form) {
    std::vector<std::string_view> all(readFormNames().begin(), readFormNames().end());
    all.insert(all.end(), cubeLayoutNames().begin(), cubeLayoutNames().end());
    return tl::unexpected<Error>(unknownName("projection or cube layout", base, all, projectionAliases()));
  }
  for (const std::string& word : words) MIRRORBALL_TRY_VOID(applyWord(word, hint));
  MIRRORBALL_TRY_VOID(checkPanorama(hint));
  return hint;
}

Metadata metadataOf(const MapForm& form) {
  const bool is_cube = faceCount(form.projection) == 6;
  // The attribute speaks of a whole map: one face of six is none.
  if (form.has_texels_on_edges && !(is_cube && form.layout == CubeLayout::faces))
    return {{kEnvmapKey, is_cube ? "cube" : "latlong"}};
  Metadata metadata;
  metadata[kProjectionKey] = nameOf(form.projection);
  if (is_cube) {
    metadata[kLayoutKey] = nameOf(form.layout);
    if (const std::string arrangement = textOf(form.arrangement); !arrangement.empty())
      metadata[kArrangementKey] = arrangement;
  }
  if (form.centre != SignedAxis::plus_z) metadata[kCentreKey] = nameOf(form.centre);
  if (form.has_texels_on_edges) metadata[kTexelsKey] = kTexelsOnEdges;
  if (form.projection == Projection::ball)
    metadata[kBallDistanceKey] = formatNumber(double(form.projection.ball_distance));
  return metadata;
}

Metadata metadataOfLevelSheet() { return {{kSheetKey, "mip levels"}}; }

Metadata metadataOfBrdfTable() { return {{kTableKey, kBrdfTableValue}}; }
bool isBrdfTable(const Metadata& metadata) { return isTable(metadata, kBrdfTableValue); }

Metadata metadataOfLobeRows() { return {{kTableKey, kLobeRowsValue}}; }
bool isLobeRows(const Metadata& metadata) { return isTable(metadata, kLobeRowsValue); }

bool isRecognizedUnsaid(const MapForm& form) {
  if (form.has_texels_on_edges) return false;
  if (form.projection == Projection::equirect) return form.centre == SignedAxis::plus_z;
  if (form.projection == Projection::cube)
    return form.arrangement == CubeArrangement{} || form.arrangement == asSeen(CubeArrangement{});
  return form.projection == Projection::sphere;
}

Recognition recognizeFaces(const Metadata& metadata, const FormHint& hint, const std::string& told_by) {
  const auto stated = hintOfMetadata(metadata);
  const bool is_told = stated && stated->projection && stated->layout == CubeLayout::faces;
  if (hint.namesForm()) {
    const Projection of_file = is_told ? *stated->projection : Projection(Projection::cube);
    return {formWith(hint, hint.projection.value_or(of_file), CubeLayout::faces), ""};
  }
  if (!is_told) return {{Projection::cube, CubeLayout::faces}, told_by, true};
  return {formWith(*stated, *stated->projection, CubeLayout::faces), told_by};
}

bool statesForm(const Metadata& metadata) {
  const auto stated = hintOfMetadata(metadata);
  return !stated || stated->namesForm();
}

Result<Recognition> recognize(int width, int height, const Metadata& metadata, const FormHint& hint) {
  if (hint.namesForm()) {
    MIRRORBALL_TRY(form, formOfHint(hint, width, height));
    return Recognition{form, ""};
  }
  if (metadata.contains(kSheetKey))
    return fail(ErrorCode::bad_shape, "is a sheet of mip levels, no map; name what it was made of",
                FixHint::take_one_level);
  if (isBrdfTable(metadata))
    return fail(ErrorCode::bad_shape, "is a BRDF table, no map; `mirrorball info` tells what it holds");
  if (isLobeRows(metadata))
    return fail(ErrorCode::bad_shape, "is a table of lobe rows, no map; `mirrorball info` tells what it holds");
  const auto stated_form = hintOfMetadata(metadata);
  // Nobody has typed what is wrong here.
  if (!stated_form)
    return fail(ErrorCode::bad_file, "its own metadata is wrong: " + stated_form.error().message, FixHint::name_form);
  const FormHint& stated = *stated_form;
  if (stated.layout == CubeLayout::faces)
    return fail(ErrorCode::bad_shape,
                "is one face of a cube; the names of all six must end in _px _nx _py _ny _pz _nz, or as "
                "docs/conventions.md says");
  if (stated.projection) {
    MIRRORBALL_TRY(form, formOfHint(stated, width, height));
    return Recognition{form, "the file's metadata"};
  }
  return recognizeShape(width, height);
}

}  // namespace mirrorball
