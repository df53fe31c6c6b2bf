#include "mirrorball/codec/color/coded_color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include <glm/glm.hpp>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

std::optional<Primaries> primariesOf(int number) {
  switch (number) {
    case 5:
      return kRec601Of625Lines;
    case 6:
    case 7:
      return kRec601Of525Lines;
    case 9:
      return kRec2020;
    case 10:
      return kCieXyz;
    case 11:
      return kDciP3;
    case 12:
      return kDisplayP3;
    default:
      return std::nullopt;
  }
}

float lightOfRec709(float code) {
  return code < 0.081f ? code / 4.5f : std::pow((code + 0.099f) / 1.099f, 1.0f / 0.45f);
}

float lightOfPq(float code) {
  constexpr float kM1 = 2610.0f / 16384.0f;
  constexpr float kM2 = 2523.0f / 4096.0f * 128.0f;
  constexpr float kC1 = 3424.0f / 4096.0f;
  constexpr float kC2 = 2413.0f / 4096.0f * 32.0f;
  constexpr float kC3 = 2392.0f / 4096.0f * 32.0f;
  constexpr float kBrightest = 10000.0f;  // cd/m²
  const float root = std::pow(std::clamp(code, 0.0f, 1.0f), 1.0f / kM2);
  return kBrightest / kGraphicsWhite * std::pow(std::max(root - kC1, 0.0f) / (kC2 - kC3 * root), 1.0f / kM1);
}

/// The light of the scene, up to 1.
float sceneOfHlg(float code) {
  constexpr float kA = 0.17883277f;
  constexpr float kB = 1.0f - 4.0f * kA;
  const float c = 0.5f - kA * std::log(4.0f * kA);
  code = std::max(code, 0.0f);
  return code <= 0.5f ? code * code / 3.0f : (std::exp((code - c) / kA) + kB) / 12.0f;
}

/// The light of a display, from that of the scene.
glm::vec3 displayOfHlg(glm::vec3 scene) {
  constexpr float kBrightest = 1000.0f;  // cd/m²
  constexpr float kSystemGamma = 1.2f;   // of such a display
  const float luminance = glm::dot(scene, glm::vec3(0.2627f, 0.6780f, 0.0593f));
  return kBrightest / kGraphicsWhite * std::pow(luminance, kSystemGamma - 1.0f) * scene;
}

float lightOf(float code, const CodedColor& color) {
  switch (color.transfer) {
    case Transfer::srgb:
      return formula::linearFromSrgb1(code);
    case Transfer::rec709:
      return lightOfRec709(code);
    case Transfer::gamma:
      return std::pow(std::max(code, 0.0f), float(color.gamma));
    case Transfer::pq:
      return lightOfPq(code);
    case Transfer::hlg:
      return sceneOfHlg(code);
    case Transfer::linear:
      break;
  }
  return code;
}

/// Of the curve.
std::string curveName(const CodedColor& color) {
  switch (color.transfer) {
    case Transfer::rec709:
      return "Rec.709's curve";
    case Transfer::pq:
      return "PQ";
    case Transfer::hlg:
      return "HLG";
    case Transfer::linear:
    case Transfer::gamma:
    case Transfer::srgb:
      break;
  }
  return curveName(*curveOf(color));
}

}  // namespace

CodedColor codedColor(int primaries, int transfer) {
  CodedColor color{.primaries = primariesOf(primaries)};
  switch (transfer) {
    case 1:
    case 6:
    case 14:
    case 15:
      color.transfer = Transfer::rec709;
      break;
    case 4:
      color = {Transfer::gamma, 2.2, color.primaries};
      break;
    case 5:
      color = {Transfer::gamma, 2.8, color.primaries};
      break;
    case 8:
      color.transfer = Transfer::linear;
      break;
    case 16:
      color.transfer = Transfer::pq;
      break;
    case 18:
      color.transfer = Transfer::hlg;
      break;
    default:
      break;
  }
  return color;
}

CodedColor codedColor(const TransferCurve& curve, const std::optional<Primaries>& primaries) {
  if (!curve.power) return {.primaries = primaries};
  return {*curve.power == 1.0 ? Transfer::linear : Transfer::gamma, *curve.power, primaries};
}

bool isSrgb(const CodedColor& color) {
  return color.transfer == Transfer::srgb && !(color.primaries && rec709FromPrimaries(*color.primaries));
}

std::optional<TransferCurve> curveOf(const CodedColor& color) {
  switch (color.transfer) {
    case Transfer::srgb:
      return kSrgbCurve;
    case Transfer::linear:
      return kLinearLight;
    case Transfer::gamma:
      return TransferCurve{color.gamma};
    case Transfer::rec709:
    case Transfer::pq:
    case Transfer::hlg:
      break;
  }
  return std::nullopt;
}

std::string statedSpace(const CodedColor& color, int channels) {
  if (!color.unread_profile.empty())
    return color.unread_profile.starts_with("sRGB") ? "" : "an ICC profile, " + color.unread_profile;
  const bool has_other_primaries = channels >= 3 && color.primaries && rec709FromPrimaries(*color.primaries);
  const bool is_usual = color.transfer == Transfer::srgb || color.transfer == Transfer::linear;
  if (is_usual && !has_other_primaries) return {};
  return curveName(color) + (has_other_primaries ? ", " + primariesName(*color.primaries) : "");
}

void tellUnapplied(const std::string& space, std::vector<std::string>& oddities) {
  if (!space.empty())
    oddities.push_back("states a colour space (" + space +
                       "), which does not count for numbers: they are read as they are stored");
}

int codePointOf(OutputPrimaries primaries) {
  constexpr int kRec709Number = 1;
  constexpr int kRec2020Number = 9;
  constexpr int kDisplayP3Number = 12;
  if (primaries == OutputPrimaries::p3) return kDisplayP3Number;
  return primaries == OutputPrimaries::rec2020 ? kRec2020Number : kRec709Number;
}

bool decodeColor(Image& codes, const CodedColor& color) {
  if (color.transfer == Transfer::linear) return convertToRec709(codes, color.primaries);
  constexpr std::size_t kTexelsPerPiece = 1 << 14;
  const auto stride = static_cast<std::size_t>(codes.channels());
  const std::size_t colors = std::min<std::size_t>(stride, 3);
  parallelFor(codes.texelCount(), kTexelsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float* texel = codes.samples().data() + i * stride;
      for (std::size_t c = 0; c < colors; ++c) texel[c] = lightOf(texel[c], color);
      if (color.transfer != Transfer::hlg) continue;
      const glm::vec3 scene(texel[0], texel[colors > 1 ? 1 : 0], texel[colors - 1]);
      const glm::vec3 shown = displayOfHlg(scene);
      for (std::size_t c = 0; c < colors; ++c) texel[c] = shown[static_cast<int>(c)];
    }
  });
  convertToRec709(codes, color.primaries);
  return true;
}

std::string describeColor(const CodedColor& color, int channels) {
  if (color.unread_profile.starts_with("sRGB")) return "sRGB";
  if (!color.unread_profile.empty())
    return "sRGB assumed: its ICC profile (" + color.unread_profile + ") is not applied";
  const auto named = [&](std::string_view name) {
    constexpr std::string_view kLinear = "linear";
    return std::string(name) + describeColor(kLinearLight, color.primaries, channels).substr(kLinear.size());
  };
  if (const auto curve = curveOf(color)) return describeColor(*curve, color.primaries, channels);
  return named(curveName(color));
}

}  // namespace mirrorball
