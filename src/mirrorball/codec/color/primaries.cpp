#include "mirrorball/codec/color/primaries.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

/// XYZ of a chromaticity with Y = 1.
glm::dvec3 xyzOf(glm::dvec2 xy) { return {xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y}; }

bool areNear(const Primaries& a, const Primaries& b) {
  constexpr double kSame = 1e-3;  // files write three or four digits
  return glm::distance(a.red, b.red) < kSame && glm::distance(a.green, b.green) < kSame &&
         glm::distance(a.blue, b.blue) < kSame && glm::distance(a.white, b.white) < kSame;
}

/// The columns are the primaries' XYZ, scaled so that they sum to the white's (SMPTE RP 177). Made
/// of x, y, z instead of X/Y, Z/Y, since a primary may have y = 0.
glm::dmat3 xyzFromRgb(const Primaries& primaries) {
  const auto column = [](glm::dvec2 xy) { return glm::dvec3(xy, 1.0 - xy.x - xy.y); };
  const glm::dmat3 unscaled(column(primaries.red), column(primaries.green), column(primaries.blue));
  const glm::dvec3 scale = glm::inverse(unscaled) * xyzOf(primaries.white);
  return {unscaled[0] * scale.x, unscaled[1] * scale.y, unscaled[2] * scale.z};
}

/// Lam's Bradford cone responses (CIE 160:2004 gives the same matrix), row by row.
const glm::dmat3 kConesFromXyz =
    glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));

struct NamedPrimaries {
  std::string_view name;
  Primaries primaries;
};
constexpr NamedPrimaries kNamed[] = {
    {"BT.601, 625 lines", kRec601Of625Lines},
    {"BT.601, 525 lines", kRec601Of525Lines},
    {"Rec.2020", kRec2020},
    {"Display P3", kDisplayP3},
    {"DCI-P3", kDciP3},
    {"Adobe RGB", kAdobeRgb},
    {"ACES AP0", kAcesAp0},
    {"ACES AP1", kAcesAp1},
    {"CIE XYZ", kCieXyz},
};

}  // namespace

std::string primariesName(const Primaries& primaries) {
  const auto* named = std::find_if(std::begin(kNamed), std::end(kNamed),
                                   [&](const NamedPrimaries& known) { return areNear(known.primaries, primaries); });
  if (named != std::end(kNamed)) return std::string(named->name);
  const auto text = [](glm::dvec2 xy) {
    const auto digits = [](double value) { return formatNumber(std::round(value * 1e4) / 1e4); };
    return digits(xy.x) + " " + digits(xy.y);
  };
  return "red " + text(primaries.red) + ", green " + text(primaries.green) + ", blue " + text(primaries.blue) +
         ", white " + text(primaries.white);
}

std::string curveName(const TransferCurve& curve) {
  if (!curve.power) return "sRGB";
  return *curve.power == 1.0 ? "linear" : "gamma " + formatNumber(std::round(*curve.power * 1e3) / 1e3);
}

bool arePossible(const Primaries& primaries) {
  const glm::dvec2 a = primaries.green - primaries.red;
  const glm::dvec2 b = primaries.blue - primaries.red;
  if (!(std::abs(a.x * b.y - a.y * b.x) > 1e-6) || !(primaries.white.y > 1e-6)) return false;
  const glm::dmat3 matrix = xyzFromRgb(primaries);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!std::isfinite(matrix[c][r])) return false;
  return true;
}

glm::dmat3 adaptation(glm::dvec2 from_white, glm::dvec2 to_white) {
  const glm::dvec3 gain = (kConesFromXyz * xyzOf(to_white)) / (kConesFromXyz * xyzOf(from_white));
  const glm::dmat3 diagonal(gain.x, 0, 0, 0, gain.y, 0, 0, 0, gain.z);
  return glm::inverse(kConesFromXyz) * diagonal * kConesFromXyz;
}

std::optional<glm::mat3> rec709FromPrimaries(const Primaries& primaries) {
  if (!arePossible(primaries) || areNear(primaries, kRec709)) return {};
  return glm::mat3(rec709Matrix(primaries));
}

glm::dmat3 rec709Matrix(const Primaries& primaries) {
  return glm::inverse(xyzFromRgb(kRec709)) * adaptation(primaries.white, kRec709.white) * xyzFromRgb(primaries);
}

std::string describeColor(const TransferCurve& curve, const std::optional<Primaries>& stated, int channels) {
  const std::string encoding = curveName(curve);
  if (channels < 3) return encoding + ", grey";
  if (stated && !arePossible(*stated)) return encoding + ", Rec.709 assumed: the file's primaries are none";
  if (stated && !areNear(*stated, kRec709))
    return encoding + ", primaries of the file (" + primariesName(*stated) + "): converted";
  return curve.power ? encoding + ", Rec.709" : encoding;  // sRGB has these primaries by its name
}

bool convertToRec709(Image& image, const std::optional<Primaries>& stated) {
  if (!stated || image.channels() < 3) return false;
  const auto matrix = rec709FromPrimaries(*stated);
  if (matrix) transformColors(image, *matrix);
  return matrix.has_value();
}

void transformColors(Image& image, const glm::mat3& matrix, float rounding) {
  constexpr std::size_t kTexelsPerPiece = 1 << 15;
  const std::size_t stride = std::size_t(image.channels());
  parallelFor(image.texelCount(), kTexelsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float* texel = image.samples().data() + i * stride;
      const glm::vec3 color = matrix * glm::vec3(texel[0], texel[1], texel[2]);
      const float least = -rounding * std::max({color.x, color.y, color.z});
      for (int c = 0; c < 3; ++c) texel[c] = color[c] < 0.0f && color[c] > least ? 0.0f : color[c];
    }
  });
}

}  // namespace mirrorball
