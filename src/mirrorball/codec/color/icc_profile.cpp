#include "mirrorball/codec/color/icc_profile.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/glm.hpp>

#include "formula/color.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

/// Four letters as the number that they stand for in a profile.
constexpr std::uint32_t letters(const char (&text)[5]) {
  std::uint32_t number = 0;
  for (int i = 0; i < 4; ++i) number = number << 8 | static_cast<std::uint8_t>(text[i]);
  return number;
}

/// The number at `at`, 0 behind the end.
std::uint32_t numberAt(Span bytes, std::size_t at) {
  return at <= bytes.size() && bytes.size() - at >= 4 ? bigU32(bytes.data() + at) : 0;
}

/// As much of the range as lies within the bytes.
Span clipped(Span bytes, std::size_t begin, std::size_t size) {
  begin = std::min(begin, bytes.size());
  return bytes.subspan(begin, std::min(size, bytes.size() - begin));
}

/// The value of a tag, empty where there is none.
Span tagValue(Span profile, std::uint32_t signature) {
  constexpr std::size_t kHeader = 128;
  constexpr std::size_t kRow = 12;  // signature, offset, size
  const std::size_t begin = kHeader + 4;
  const std::size_t rows = profile.size() < begin ? 0 : (profile.size() - begin) / kRow;
  const std::size_t count = std::min<std::size_t>(numberAt(profile, kHeader), rows);
  for (std::size_t at = begin; at < begin + count * kRow; at += kRow)
    if (numberAt(profile, at) == signature)
      return clipped(profile, numberAt(profile, at + 4), numberAt(profile, at + 8));
  return {};
}

/// "sRGB IEC61966-2.1", "Display P3"; characters beyond ASCII become '?'; "unnamed" where it does not say.
std::string descriptionIn(Span profile) {
  const Span value = tagValue(profile, letters("desc"));
  const std::uint32_t type = numberAt(value, 0);
  std::string name;
  if (type == letters("desc")) {
    for (const std::uint8_t letter : clipped(value, 12, numberAt(value, 8))) name += static_cast<char>(letter);
  } else if (type == letters("mluc")) {
    // The first language's, in UTF-16.
    const Span text = clipped(value, numberAt(value, 24), numberAt(value, 20));
    for (std::size_t i = 0; i + 1 < text.size(); i += 2) name += text[i] == 0 ? static_cast<char>(text[i + 1]) : '?';
  }
  name = excerpt(name.substr(0, name.find('\0')));
  std::replace_if(
      name.begin(), name.end(), [](char letter) { return letter < 0; }, '?');
  return name.empty() ? "unnamed" : name;
}

/// An s15Fixed16Number.
double fixedAt(Span bytes, std::size_t at) { return static_cast<std::int32_t>(numberAt(bytes, at)) / 65536.0; }

/// The colour of a tag of XYZType.
std::optional<glm::dvec3> xyzIn(Span profile, const char (&tag)[5]) {
  const Span value = tagValue(profile, letters(tag));
  if (value.size() < 20 || numberAt(value, 0) != letters("XYZ ")) return {};
  return glm::dvec3(fixedAt(value, 8), fixedAt(value, 12), fixedAt(value, 16));
}

/// Light of a code by a table of 16-bit numbers.
double lightByTable(Span table, double code) {
  const double last = static_cast<double>(table.size() / 2 - 1);
  const double place = code * last;
  const auto at = [&](double index) {
    const auto i = 2 * static_cast<std::size_t>(index);
    return (table[i] * 256 + table[i + 1]) / 65535.0;
  };
  const double below = std::floor(place);
  return glm::mix(at(below), at(std::min(below + 1.0, last)), place - below);
}

/// sRGB's curve or linear light where a curve is that, to what writers round of its numbers.
template <typename LightOf>
std::optional<TransferCurve> knownCurve(const LightOf& lightOf) {
  constexpr int kSteps = 64;
  constexpr double kSame = 1e-3;
  bool is_srgb = true, is_linear = true;
  for (int i = 0; i <= kSteps; ++i) {
    const double code = i / double{kSteps};
    const double light = lightOf(code);
    is_srgb = is_srgb && std::abs(light - double{formula::linearFromSrgb1(static_cast<float>(code))}) < kSame;
    is_linear = is_linear && std::abs(light - code) < kSame;
  }
  if (is_linear) return kLinearLight;
  return is_srgb ? std::optional(kSrgbCurve) : std::nullopt;
}

std::optional<TransferCurve> powerCurve(double power) {
  return power > 0.1 && power < 10.0 ? std::optional(TransferCurve{power}) : std::nullopt;
}

/// A curve of curveType: none at all, a power, or a table.
std::optional<TransferCurve> tabulatedCurve(Span value) {
  const std::size_t count = numberAt(value, 8);
  if (value.size() < 12 || (value.size() - 12) / 2 < count) return {};
  if (count == 0) return kLinearLight;
  if (count == 1) return powerCurve((value[12] * 256 + value[13]) / 256.0);
  const Span table = value.subspan(12, 2 * count);
  return knownCurve([&](double code) { return lightByTable(table, code); });
}

/// A curve of parametricCurveType: X^g, or (aX + b)^g + e that is cX + f below d (ICC.1:2022, 10.18). The forms
/// between, without a straight part, are neither sRGB's nor a power.
std::optional<TransferCurve> parametricCurve(Span value) {
  if (value.size() < 16) return {};
  const int form = value[8] * 256 + value[9];
  const double g = fixedAt(value, 12);
  if (form == 0) return powerCurve(g);
  if ((form != 3 && form != 4) || value.size() < (form == 3 ? 32 : 40)) return {};
  const double a = fixedAt(value, 16), b = fixedAt(value, 20), c = fixedAt(value, 24), d = fixedAt(value, 28);
  const double e = form == 3 ? 0.0 : fixedAt(value, 32), f = form == 3 ? 0.0 : fixedAt(value, 36);
  return knownCurve([&](double code) { return code < d ? c * code + f : std::pow(a * code + b, g) + e; });
}

std::optional<TransferCurve> curveIn(Span profile, const char (&tag)[5]) {
  const Span value = tagValue(profile, letters(tag));
  if (numberAt(value, 0) == letters("curv")) return tabulatedCurve(value);
  return numberAt(value, 0) == letters("para") ? parametricCurve(value) : std::nullopt;
}

/// The primaries of a matrix, whose columns are adapted to D50: brought back to D65.
std::optional<Primaries> primariesIn(Span profile) {
  const auto red = xyzIn(profile, "rXYZ"), green = xyzIn(profile, "gXYZ"), blue = xyzIn(profile, "bXYZ");
  if (!red || !green || !blue) return {};
  const glm::dmat3 d65_from_d50 = glm::inverse(adaptation(kD65, kD50));
  const auto chromaticity = [&](glm::dvec3 xyz) {
    const glm::dvec3 adapted = d65_from_d50 * xyz;
    return glm::dvec2(adapted) / (adapted.x + adapted.y + adapted.z);
  };
  return Primaries{chromaticity(*red), chromaticity(*green), chromaticity(*blue), kD65};
}

}  // namespace

IccProfile readIccProfile(Span bytes) {
  IccProfile profile{.description = descriptionIn(bytes)};
  const bool is_rgb = numberAt(bytes, 16) == letters("RGB ") && numberAt(bytes, 20) == letters("XYZ ");
  if (!is_rgb || !tagValue(bytes, letters("A2B0")).empty()) return profile;
  const auto primaries = primariesIn(bytes);
  const auto red = curveIn(bytes, "rTRC"), green = curveIn(bytes, "gTRC"), blue = curveIn(bytes, "bTRC");
  if (!primaries || !arePossible(*primaries) || !red || !green || !blue) return profile;
  if (red->power != green->power || red->power != blue->power) return profile;
  profile.is_understood = true;
  profile.curve = *red;
  profile.primaries = primaries;
  return profile;
}

CodedColor codedColor(const IccProfile& profile) {
  if (!profile.is_understood) return {.unread_profile = profile.description};
  return codedColor(profile.curve, profile.primaries);
}

}  // namespace mirrorball
