#include "mirrorball/environment/file/dual_fisheye.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "formula/constants.h"
#include "formula/projection.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/image/filter.h"

namespace mirrorball {
namespace {

/// One circle of a picture.
class FisheyeCircle {
 public:
  /// is_back   it is the right one
  FisheyeCircle(const Image& picture, bool is_back, const DualFisheye& fisheye)
      : picture_(picture),
        is_back_(is_back),
        half_fov_(glm::radians(0.5f * float(fisheye.fov_deg.value_or(DualFisheye::kUsualFov_deg)))) {
    const int half = picture.width() / 2;
    first_column_ = is_back ? picture.width() - half : 0;
    columns_ = half;
    center_ = {float(first_column_) + 0.5f * float(half), 0.5f * float(picture.height())};
    radius_ = 0.5f * float(std::min(half, picture.height()));
    const glm::dvec2 turns = fisheye.turn_deg.value_or(glm::dvec2(0.0));
    const auto turn = float(glm::radians(is_back ? turns.y : turns.x));
    cosine_ = std::cos(turn);
    sine_ = std::sin(turn);
  }

  /// The share of its light in a direction: from 1 where the other circle does not reach to 0 beyond its own rim.
  float weight(glm::vec3 direction) const {
    const float angle = std::acos(std::clamp(is_back_ ? -direction.z : direction.z, -1.0f, 1.0f));
    const float overlap = 2.0f * half_fov_ - formula::kPi;
    if (overlap <= 0.0f) return angle <= half_fov_ ? 1.0f : 0.0f;
    return std::clamp((half_fov_ - angle) / overlap, 0.0f, 1.0f);
  }

  glm::vec3 light(glm::vec3 direction) const {
    // A lens sees +X on its left if it looks along +Z, and on its right if it looks back. The angular map has a whole
    // turn between its rims, and +X on the right.
    const glm::vec3 seen = is_back_ ? glm::vec3(direction.x, direction.y, -direction.z)
                                    : glm::vec3(-direction.x, direction.y, direction.z);
    const glm::vec2 upright = (formula::angularPosition(seen) - 0.5f) * (2.0f * radius_ * formula::kPi / half_fov_);
    glm::vec2 offset(cosine_ * upright.x + sine_ * upright.y, cosine_ * upright.y - sine_ * upright.x);
    // Nothing from beyond the rim is mixed in.
    constexpr float kTexelsOfCubic = 2.0f;
    const float distance = glm::length(offset), most = std::max(radius_ - kTexelsOfCubic, 0.0f);
    if (distance > most) offset *= most / distance;
    return glm::vec3(bicubic(center_ + offset, [this](int x, int y) {
      return glm::vec4(rgbAt(picture_, std::clamp(x, first_column_, first_column_ + columns_ - 1),
                             std::clamp(y, 0, picture_.height() - 1)),
                       1.0f);
    }));
  }

 private:
  const Image& picture_;
  bool is_back_;
  float half_fov_;  // rad
  int first_column_ = 0;
  int columns_ = 0;
  glm::vec2 center_{0.0f};
  float radius_ = 0.0f;
  float cosine_ = 1.0f;
  float sine_ = 0.0f;
};

std::optional<glm::dvec2> oneOrTwoNumbers(std::string_view text) {
  const std::vector<std::string> parts = split(text, ',');
  const auto first = parseNumber(parts.front()), last = parseNumber(parts.back());
  if (parts.size() > 2 || !first || !last) return std::nullopt;
  return glm::dvec2(*first, *last);
}

}  // namespace

Result<void> applyDualFisheyeWord(const std::string& word, DualFisheye& fisheye) {
  constexpr std::string_view kFov = "fov=", kTurn = "turn=";
  if (word.starts_with(kFov)) {
    const auto fov = parseNumber(std::string_view(word).substr(kFov.size()));
    if (!fov || *fov < 180.0 || *fov > 300.0)
      return fail(ErrorCode::usage, "'" + excerpt(word) +
                                        "' should be the field of view of each circle: fov=D in degrees, from 180 "
                                        "to 300, as in fov=190");
    fisheye.fov_deg = *fov;
    return {};
  }
  if (word.starts_with(kTurn)) {
    fisheye.turn_deg = oneOrTwoNumbers(std::string_view(word).substr(kTurn.size()));
    if (fisheye.turn_deg) return {};
    return fail(ErrorCode::usage, "'" + excerpt(word) +
                                      "' should be by how many degrees the left and the right circle are to be "
                                      "turned clockwise until they are upright, as in turn=-90,90");
  }
  return fail(ErrorCode::usage,
              "'" + excerpt(word) + "' says nothing of a dual fisheye picture; fov=D and turn=L,R do");
}

std::string assumedText(const DualFisheye& fisheye) {
  if (fisheye.fov_deg && fisheye.turn_deg) return {};
  const std::string fov = formatNumber(DualFisheye::kUsualFov_deg);
  std::string assumed = fisheye.fov_deg ? "" : fov + " degrees wide";
  if (!fisheye.turn_deg) assumed += std::string(assumed.empty() ? "" : " and ") + "upright";
  std::string others = fisheye.fov_deg ? "" : "fov=D";
  if (!fisheye.turn_deg) others += std::string(others.empty() ? "" : " and ") + "turn=L,R";
  return "its two circles are taken as " + assumed + ", the left one in front; {option:from} dual-fisheye with " +
         others + " says otherwise";
}

Image stitched(const Image& picture, const DualFisheye& fisheye) {
  const FisheyeCircle front(picture, false, fisheye), back(picture, true, fisheye);
  const glm::ivec2 size(2 * picture.height(), picture.height());
  Image panorama = Image::withoutValues(size.x, size.y, 3);
  // At the rim a circle's texels are half as wide as the panorama's: four points in each of these.
  constexpr std::array<glm::vec2, 4> kPoints{{{0.25f, 0.25f}, {0.75f, 0.25f}, {0.25f, 0.75f}, {0.75f, 0.75f}}};
  constexpr std::size_t kRowsPerPiece = 16;
  parallelFor(std::size_t(size.y), kRowsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < size.x; ++x) {
        glm::vec3 sum(0.0f);
        for (const glm::vec2 point : kPoints) {
          const glm::vec3 direction = formula::equirectDirection((glm::vec2(x, y) + point) / glm::vec2(size));
          for (const FisheyeCircle* circle : {&front, &back})
            if (const float weight = circle->weight(direction); weight > 0.0f) sum += weight * circle->light(direction);
        }
        sum /= float(kPoints.size());
        std::copy_n(&sum.x, 3, panorama.texel(x, y));
      }
  });
  return panorama;
}

}  // namespace mirrorball
