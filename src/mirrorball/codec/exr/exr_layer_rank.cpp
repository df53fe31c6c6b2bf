#include "mirrorball/codec/exr/exr_layer_rank.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

/// What programs call the picture of a render, the surest first:
///   composite   Blender's picture after compositing, "Composite.Combined", beside that of each view layer
///   rgba        Arnold's picture and Nuke's main layer (ynput/ayon-core#776, Autodesk/arnold-usd#2115)
///   rgb, beauty as the documentation of viewers and pipelines has them (OpenRV's "EXR layers", ynput/ayon-core#439)
///   combined    Blender: "the render output before any compositing" (its manual, "Passes")
///   ci          RenderMan (Nuke's ExrChannelNameToNuke.cpp; prman-pixar/RenderManForBlender#468)
///   c           Houdini's plane of colour (SideFX' HDK, IMG_PlaneName)
///   image …     which say no more than that
constexpr std::array<std::string_view, 10> kPictureNames{"composite", "rgba", "rgb",   "beauty", "combined",
                                                         "ci",        "c",    "image", "color",  "colour"};

/// Of these, the words that are enough within a longer name.
constexpr std::array<std::string_view, 4> kPictureWords{"rgba", "rgb", "beauty", "combined"};

/// Words of passes that hold numbers: V-Ray's "Supported Render Elements", Blender's "Passes", IMG_PlaneName, and the
/// Cryptomatte specification. Those that are part of no other word are found anywhere in a name, as in "BumpNormals";
/// letters only where they are the whole name.
constexpr auto kNumbersParts = std::to_array<std::string_view>(
    {"normal", "depth", "crypto", "velocity", "vector", "index", "tangent", "variance"});
constexpr auto kNumbersWords =
    std::to_array<std::string_view>({"position", "pos", "id", "uv", "motion", "mv", "distance", "samples"});
constexpr auto kNumbersNames =
    std::to_array<std::string_view>({"n", "ns", "ng", "p", "pref", "pworld", "pz", "z", "st", "of"});

/// Those of passes that are weights, or colours of surfaces.
constexpr auto kAidParts = std::to_array<std::string_view>({"occlusion", "albedo", "shadow", "matte", "coverage"});
constexpr auto kAidWords = std::to_array<std::string_view>(
    {"ao", "mask", "mist", "alpha", "opacity", "basecolor", "wire", "facing", "noise", "filter"});

/// Those of passes that are shares of the light.
constexpr auto kLightParts = std::to_array<std::string_view>({"diffuse", "specular", "reflect", "refract", "emissi",
                                                              "indirect", "lighting", "subsurface", "transmission",
                                                              "caustic", "background", "environment", "atmosphere"});
constexpr auto kLightWords =
    std::to_array<std::string_view>({"direct", "gi", "sss", "coat", "sheen", "volume", "emit", "env", "diff", "gloss",
                                     "glossy", "trans", "light", "raw", "spec", "illum"});

/// A name's words in small letters: "MaterialID_01" has "material" and "id".
std::vector<std::string> wordsIn(std::string_view name) {
  std::vector<std::string> words(1);
  bool was_small = false;
  for (const char letter : name) {
    const auto code = static_cast<unsigned char>(letter);
    if (std::isupper(code) != 0 && was_small) words.emplace_back();
    if (std::isalpha(code) != 0)
      words.back() += static_cast<char>(std::tolower(code));
    else if (!words.back().empty())
      words.emplace_back();
    was_small = std::islower(code) != 0;
  }
  return words;
}

/// Whether a name is one of some names, has one of some words, or has some letters anywhere in it.
class NameWords {
 public:
  explicit NameWords(std::string_view name) : words_(wordsIn(name)), letters_(lowerCase(name)) {}

  bool hasWord(std::span<const std::string_view> words) const {
    return std::any_of(words_.begin(), words_.end(), [&](const std::string& word) {
      return std::find(words.begin(), words.end(), word) != words.end();
    });
  }
  bool isOneOf(std::span<const std::string_view> names) const {
    return std::find(names.begin(), names.end(), letters_) != names.end();
  }
  bool hasPart(std::span<const std::string_view> parts) const {
    return std::any_of(parts.begin(), parts.end(),
                       [&](std::string_view part) { return letters_.find(part) != std::string::npos; });
  }

 private:
  std::vector<std::string> words_;
  std::string letters_;
};

/// The place of a word among the names of pictures; their count where it is none.
int pictureOrder(const std::string& word) {
  const auto found = std::find(kPictureNames.begin(), kPictureNames.end(), lowerCase(word));
  return static_cast<int>(found - kPictureNames.begin());
}

}  // namespace

ExrNameRank exrNameRank(std::span<const std::string> words) {
  if (words.empty()) return {ExrLayerRank::plain};
  if (pictureOrder(words.back()) < static_cast<int>(kPictureNames.size())) {
    // "Composite.Combined" goes before "ViewLayer.Combined".
    int order = static_cast<int>(kPictureNames.size());
    for (const std::string& word : words) order = std::min(order, pictureOrder(word));
    return {ExrLayerRank::picture, order};
  }
  const NameWords name(words.back());
  if (name.hasPart(kNumbersParts) || name.hasWord(kNumbersWords) || name.isOneOf(kNumbersNames))
    return {ExrLayerRank::numbers};
  if (name.hasPart(kAidParts) || name.hasWord(kAidWords)) return {ExrLayerRank::aid};
  if (name.hasPart(kLightParts) || name.hasWord(kLightWords)) return {ExrLayerRank::light};
  if (name.hasWord(kPictureWords)) return {ExrLayerRank::variant};
  return {ExrLayerRank::unknown};
}

}  // namespace mirrorball
