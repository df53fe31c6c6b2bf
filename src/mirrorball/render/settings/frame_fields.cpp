#include "mirrorball/render/settings/frame_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/type_ptr.hpp>

#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/color/hex_color.h"
#include "mirrorball/scene/place_text.h"

namespace mirrorball::frame_fields {

namespace {

constexpr int kLongestSide = 16384;

}  // namespace

constinit const Field kSize{
    [](const FrameSettings& s) { return sizeText(s.size); },
    [](const OptionText& text, std::string_view written, FrameSettings& s) -> Result<void> {
      const auto sides = split(std::string(written), written.find('X') == std::string_view::npos ? 'x' : 'X');
      glm::ivec2 size(0);
      for (int side = 0; side < 2 && side < static_cast<int>(sides.size()); ++side) {
        const auto number = parseNumber(sides[static_cast<std::size_t>(side)]);
        if (number && *number == std::floor(*number) && *number >= 1 && *number <= kLongestSide)
          size[side] = static_cast<int>(*number);
      }
      OptionText bounded = text;
      bounded.minimum = 1;
      bounded.maximum = kLongestSide;
      // A width alone keeps the shape.
      if (sides.size() == 1 && size.x > 0)
        size.y = std::clamp(int(std::lround(double(size.x) * s.size.y / s.size.x)), 1, kLongestSide);
      if (sides.size() > 2 || size.x == 0 || size.y == 0) return misused(bounded, "WIDTHxHEIGHT or WIDTH", written);
      s.size = size;
      return {};
    }};

namespace {

constexpr std::array<std::string_view, 3> kBackgroundNames{"env", "blur", "transparent"};
constexpr std::array<BackgroundKind, 3> kBackgroundKinds{BackgroundKind::environment, BackgroundKind::blur,
                                                         BackgroundKind::transparent};

Result<void> parseBackground(const OptionText& text, std::string_view written, FrameSettings& settings) {
  const std::string name(text.name);
  if (isHexCode(written))
    return fail(ErrorCode::usage, name + " " + std::string(written) + ": a colour begins with #, in quotes: '#" +
                                      std::string(written) + "'");
  if (const auto index = indexOfName(written, kBackgroundNames)) {
    settings.background = kBackgroundKinds[*index];
    return {};
  }
  if (const auto color = parseHexColor(written)) {
    settings.background = BackgroundKind::display_color;
    settings.background_color = *color;
    return {};
  }
  constexpr OptionText kRadiance{.name = "background", .minimum = 0, .maximum = 1e6};
  if (const auto numbers = parseVector(kRadiance, written)) {
    settings.background = BackgroundKind::radiance;
    settings.background_color = *numbers;
    return {};
  }
  const auto meant = nearestWord(written, kBackgroundNames);
  return fail(ErrorCode::usage, name + " takes " + join(kBackgroundNames) + ", #rrggbb or R,G,B (" +
                                    rangeText(kRadiance) + "); it was given '" + excerpt(written) + "'" +
                                    (meant ? "; did you mean '" + std::string(*meant) + "'?" : ""));
}

std::string writtenBackground(const FrameSettings& settings) {
  for (std::size_t i = 0; i < kBackgroundKinds.size(); ++i)
    if (settings.background == kBackgroundKinds[i]) return std::string(kBackgroundNames[i]);
  if (settings.background == BackgroundKind::display_color) return hexColor(settings.background_color);
  return writeNumbers({&settings.background_color.x, 3});
}

}  // namespace

constinit const Field kBackground{writtenBackground, parseBackground};

namespace {

/// Whether a text cannot be meant as numbers.
bool isName(std::string_view text) { return text.find_first_not_of("0123456789+-.,eE ") != std::string_view::npos; }

Result<void> parseOrbit(const OptionText& text, std::string_view written, FrameSettings& settings) {
  if (isName(written)) {
    settings.camera.name = written;
    return {};
  }
  MIRRORBALL_TRY(numbers, parseNumbers(text, written));
  if (std::abs(numbers[1]) > 90.0f) return misused({.name = text.name}, "an elevation from -90 to 90 degrees", written);
  if (numbers.size() > 2 && numbers[2] <= 0.0f)
    return misused({.name = text.name}, "a distance above 0, in model radii", written);
  settings.camera.azimuth_deg = numbers[0];
  settings.camera.elevation_deg = numbers[1];
  settings.camera.distance = numbers.size() > 2 ? std::optional(numbers[2]) : std::nullopt;
  return {};
}

std::string writtenOrbit(const FrameSettings& settings) {
  if (!settings.camera.name.empty()) return settings.camera.name;
  std::vector<float> numbers{settings.camera.azimuth_deg, settings.camera.elevation_deg};
  if (settings.camera.distance) numbers.push_back(*settings.camera.distance);
  return writeNumbers(numbers);
}

}  // namespace

constinit const Field kOrbit{writtenOrbit, parseOrbit};

namespace {

/// A place that need not be told.
template <auto Part, auto Place>
constexpr Field kOptionalPlace{[](const FrameSettings& s) {
                                 const std::optional<glm::dvec3>& place = s.*Part.*Place;
                                 return place ? writtenPlace(*place) : std::string();
                               },
                               [](const OptionText& text, std::string_view written, FrameSettings& s) -> Result<void> {
                                 MIRRORBALL_TRY(numbers, parseExactNumbers(text, written));
                                 s.*Part.*Place = glm::dvec3(numbers[0], numbers[1], numbers[2]);
                                 return {};
                               }};

}  // namespace

constinit const Field kTarget = kOptionalPlace<&FrameSettings::camera, &CameraOptions::target>;
constinit const Field kCapturedAt = kOptionalPlace<&FrameSettings::proxy, &ProxyOptions::captured_at>;

constinit const Field kOrthographic{
    [](const FrameSettings& s) {
      return s.camera.orthographic_height ? formatNumber(*s.camera.orthographic_height) : "";
    },
    [](const OptionText& text, std::string_view written, FrameSettings& s) -> Result<void> {
      MIRRORBALL_TRY(numbers, parseNumbers(text, written));
      s.camera.orthographic_height = numbers[0];
      return {};
    }};

constinit const Field kRotation{[](const FrameSettings& s) {
                                  const glm::vec3& turn = s.env_rotation_deg;
                                  return writeNumbers({&turn.x, turn.z != 0.0f   ? std::size_t{3}
                                                                : turn.y != 0.0f ? std::size_t{2}
                                                                                 : std::size_t{1}});
                                },
                                [](const OptionText& text, std::string_view written, FrameSettings& s) -> Result<void> {
                                  MIRRORBALL_TRY(numbers, parseNumbers(text, written));
                                  numbers.resize(3, 0.0f);
                                  s.env_rotation_deg = glm::vec3(numbers[0], numbers[1], numbers[2]);
                                  return {};
                                }};

constinit const Field kProxy{[](const FrameSettings& s) { return writtenProxy(s.proxy); },
                             [](const OptionText& text, std::string_view written, FrameSettings& s) -> Result<void> {
                               MIRRORBALL_TRY(proxy, parseProxy(text.name, written));
                               proxy.captured_at = s.proxy.captured_at;
                               proxy.ground_roughness = s.proxy.ground_roughness;
                               s.proxy = std::move(proxy);
                               return {};
                             }};

constinit const Field kGroundRoughness{
    [](const FrameSettings& s) { return formatNumber(s.proxy.ground_roughness); },
    [](const OptionText& text, std::string_view written, FrameSettings& s) -> Result<void> {
      MIRRORBALL_TRY(numbers, parseNumbers(text, written));
      s.proxy.ground_roughness = numbers.front();
      return {};
    }};

constinit const Field kProbes{
    [](const FrameSettings& s) { return s.probes == FrameSettings::kAutoProbes ? "auto" : std::to_string(s.probes); },
    [](const OptionText& text, std::string_view written, FrameSettings& s) -> Result<void> {
      if (written == "auto") {
        s.probes = FrameSettings::kAutoProbes;
        return {};
      }
      const auto count = parseInteger(text, written);
      if (!count) return misused(text, "'auto' or a number", written);
      s.probes = *count;
      return {};
    }};

/// As matrices are written, row after row; GLM's are columns.
constinit const Field kTextureMatrix{
    [](const FrameSettings& s) {
      const glm::mat4 rows = glm::transpose(s.texture_matrix);
      return writeNumbers({&rows[0].x, 16});
    },
    [](const OptionText& text, std::string_view written, FrameSettings& s) -> Result<void> {
      MIRRORBALL_TRY(numbers, parseNumbers(text, written));
      s.texture_matrix = glm::transpose(glm::make_mat4(numbers.data()));
      return {};
    }};

constinit const Field kWavelength{
    [](const FrameSettings& s) { return s.wavelength_nm > 0.0f ? formatNumber(s.wavelength_nm) : std::string(); },
    [](const OptionText& text, std::string_view written, FrameSettings& s) -> Result<void> {
      MIRRORBALL_TRY(numbers, parseNumbers(text, written));
      s.wavelength_nm = numbers[0];
      return {};
    }};

constinit const Field kLight{[](const FrameSettings&) { return std::string(); },
                             [](const OptionText& text, std::string_view written, FrameSettings& s) -> Result<void> {
                               MIRRORBALL_TRY(n, parseExactNumbers(text, written));
                               if (s.lights.size() == FrameSettings::kMaxLights)
                                 return fail(ErrorCode::usage, std::string(text.name) + " may be given " +
                                                                   std::to_string(FrameSettings::kMaxLights) +
                                                                   " times at most");
                               s.lights.push_back({{n[0], n[1], n[2]}, {n[3], n[4], n[5]}});
                               return {};
                             },
                             true};

}  // namespace mirrorball::frame_fields
