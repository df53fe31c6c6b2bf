// Holds what widens the lobe of bumps that a pixel averages away to the mean over the pixel, and prints the table of
// docs/truth/relief.md: a plane of a rough mirror by the renderer's formulas, on the CPU. The error
// is that of radiance that is clipped at 1 in each pixel.
//   one lobe   widened by the mean of the slopes' variances
//   Toksvig    by the length of the mean normal (2005, "Mipmapping normal maps")
//   LEAN       a Gaussian of their covariance (Olano & Baker 2010)
//   strata     what the renderer does

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "formula/bsdf.h"
#include "formula/constants.h"
#include "formula/prefilter.h"
#include "formula/relief.h"
#include "formula/surface.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/scene/relief/height_texture.h"

using namespace mirrorball;

namespace {

constexpr int kSide = 512;  // texels of a tile
constexpr glm::ivec2 kSize{64, 36};
constexpr int kTruthSamples = 512;
constexpr int kLobeSamples = 16;
constexpr float kRoughness = 0.1f;
constexpr float kElevation = 0.61f;  // 35°

/// Means over a part of a tile.
struct Moments {
  glm::vec2 slope{0.0f};
  glm::vec3 squares{0.0f};  ///< of x², y² and x y of the slopes: LEAN's
  glm::vec3 normal{0.0f};   ///< of the unit normals: Toksvig's
  float variance = 0.0f;    ///< of a slope, which the texture keeps beside its mean: ours
};

Moments operator*(float s, const Moments& m) { return {s * m.slope, s * m.squares, s * m.normal, s * m.variance}; }
Moments operator+(const Moments& a, const Moments& b) {
  return {a.slope + b.slope, a.squares + b.squares, a.normal + b.normal, a.variance + b.variance};
}

glm::vec3 normalOf(glm::vec2 slope) { return glm::normalize(glm::vec3(-slope.x, 1.0f, -slope.y)); }

/// A tile of a built-in surface, as deep as it is on the plane, with mip levels.
class Bumps {
 public:
  explicit Bumps(HeightKind kind) {
    const HeightSize size = ownSize(kind);
    const float depth = size.scale * size.frequency / std::sqrt(2.0f);
    std::vector<Moments> level(std::size_t{kSide} * kSide);
    parallelFor(kSide, 8, [&](std::size_t b, std::size_t e) {
      for (std::size_t y = b; y < e; ++y)
        for (int x = 0; x < kSide; ++x) {
          const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / float(kSide);
          const glm::vec2 s = depth * glm::vec2(formula::builtinHeight(static_cast<int>(kind), uv));
          level[y * kSide + std::size_t(x)] = {s, {s.x * s.x, s.y * s.y, s.x * s.y}, normalOf(s), 0.0f};
        }
    });
    levels_.push_back(level);
    for (int side = kSide / 2; side >= 1; side /= 2) {
      std::vector<Moments> next(std::size_t(side) * std::size_t(side));
      const auto& last = levels_.back();
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          const std::size_t i = std::size_t(2 * y) * std::size_t(2 * side) + std::size_t(2 * x);
          next[std::size_t(y * side + x)] =
              0.25f * (last[i] + last[i + 1] + last[i + std::size_t(2 * side)] + last[i + std::size_t(2 * side) + 1]);
        }
      for (Moments& m : next)
        m.variance = 0.5f * std::max(m.squares.x + m.squares.y - glm::dot(m.slope, m.slope), 0.0f);
      levels_.push_back(std::move(next));
    }
  }

  Moments at(glm::vec2 uv, float lod) const {
    lod = std::clamp(lod, 0.0f, float(levels_.size() - 1));
    const int low = std::min(int(lod), int(levels_.size()) - 2);
    const float t = lod - float(low);
    return (1.0f - t) * bilinear(uv, low) + t * bilinear(uv, low + 1);
  }

 private:
  Moments bilinear(glm::vec2 uv, int level) const {
    const int side = kSide >> level;
    const glm::vec2 p = (uv - glm::floor(uv)) * float(side) - 0.5f;
    const glm::vec2 f = glm::floor(p), t = p - f;
    const auto texel = [&](int dx, int dy) -> const Moments& {
      const int x = (int(f.x) + dx + side) % side, y = (int(f.y) + dy + side) % side;
      return levels_[std::size_t(level)][std::size_t(y * side + x)];
    };
    return (1.0f - t.y) * ((1.0f - t.x) * texel(0, 0) + t.x * texel(1, 0)) +
           t.y * ((1.0f - t.x) * texel(0, 1) + t.x * texel(1, 1));
  }
  std::vector<std::vector<Moments>> levels_;
};

/// Green light of an environment.
class Light {
 public:
  explicit Light(const char* name) : table_(1024 * 512) {
    const Environment environment = *builtinEnvironment(name);
    parallelFor(512, 4, [&](std::size_t b, std::size_t e) {
      for (std::size_t y = b; y < e; ++y)
        for (std::size_t x = 0; x < 1024; ++x) {
          const float theta = (float(y) + 0.5f) / 512.0f * formula::kPi,
                      phi = (float(x) + 0.5f) / 1024.0f * formula::kTwoPi;
          const glm::vec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
          table_[y * 1024 + x] = environment.radiance(d).y;
        }
    });
  }
  float at(glm::vec3 d) const {
    const int y = std::clamp(int(std::acos(std::clamp(d.y, -1.0f, 1.0f)) / formula::kPi * 512.0f), 0, 511);
    float phi = std::atan2(d.z, d.x) / formula::kTwoPi;
    if (phi < 0.0f) phi += 1.0f;
    return table_[std::size_t(y) * 1024 + std::size_t(std::min(int(phi * 1024.0f), 1023))];
  }

 private:
  std::vector<float> table_;
};

glm::vec2 random2(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const glm::vec3 r = formula::gridRandom(glm::ivec3(int(a), int(b), int(c)));
  return {r.x, r.y};
}

/// The i-th point of the R2 sequence, moved.
glm::vec2 shiftOf(glm::vec2 shift, int i) { return formula::evenPoint(shift, float(i) + 0.5f); }

/// The light of a round lobe about the mirrored ray, as prefiltered cubes hold it: of an eye along the normal.
float roundLobe(const Light& light, glm::vec3 v, glm::vec3 n, float variance, glm::vec2 shift, int count) {
  const float r = formula::widenedRoughness(kRoughness, variance);
  const float alpha = r * r;
  n = formula::facingNormal(n, -v);
  const glm::vec3 mirrored = glm::reflect(-v, n);
  const glm::vec3 t = formula::anyTangent(mirrored), b = glm::cross(mirrored, t);
  float sum = 0.0f, weight = 0.0f;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 l = formula::sampleGgx(glm::vec2(alpha), {0.0f, 0.0f, 1.0f}, shiftOf(shift, i));
    if (l.z <= 0.0f) continue;
    sum += light.at(l.x * t + l.y * b + l.z * mirrored);
    weight += 1.0f;
  }
  return sum / weight;
}

/// The light of LEAN's Gaussian of slopes over the flat surface, by reflection at each.
float leanLobe(const Light& light, glm::vec3 v, const Moments& m, glm::vec2 shift) {
  const float base = 0.5f * kRoughness * kRoughness * kRoughness * kRoughness;
  const float xx = std::max(m.squares.x - m.slope.x * m.slope.x, 0.0f) + base;
  const float yy = std::max(m.squares.y - m.slope.y * m.slope.y, 0.0f) + base;
  const float xy = m.squares.z - m.slope.x * m.slope.y;
  const float a = std::sqrt(xx), b = xy / a, c = std::sqrt(std::max(yy - b * b, base));
  float sum = 0.0f;
  for (int i = 0; i < kLobeSamples; ++i) {
    const glm::vec2 u = shiftOf(shift, i);
    const float radius = std::sqrt(-2.0f * std::log(1.0f - u.x));
    const glm::vec2 g = radius * glm::vec2(std::cos(formula::kTwoPi * u.y), std::sin(formula::kTwoPi * u.y));
    const glm::vec3 n = formula::facingNormal(normalOf(m.slope + glm::vec2(a * g.x, b * g.x + c * g.y)), -v);
    sum += light.at(glm::reflect(-v, n));
  }
  return sum / float(kLobeSamples);
}

/// What a sample of a pixel sees of the plane: its place in tiles, how that changes to the next pixels, and the eye.
struct Seen {
  glm::vec2 uv, across, down;
  glm::vec3 v;
};

/// A camera above the plane, aimed at a place that is that many texels a pixel wide.
struct View {
  glm::vec3 eye;
  float tan_half;
  glm::mat3 frame;
  View(float texels_a_pixel, float elevation) {
    const glm::vec3 back(0.0f, std::sin(elevation), std::cos(elevation));
    frame = glm::mat3({1, 0, 0}, glm::cross(back, glm::vec3(1, 0, 0)), back);
    tan_half = 0.25f;
    const float distance = texels_a_pixel / kSide * float(kSize.y) / (2.0f * tan_half);
    eye = distance * back;
  }
  glm::vec3 ray(glm::vec2 p) const {
    const glm::vec2 c = (2.0f * p - glm::vec2(kSize)) / float(kSize.y) * tan_half;
    return glm::normalize(frame * glm::vec3(c.x, -c.y, -1.0f));
  }
  glm::vec2 place(glm::vec2 p) const {
    const glm::vec3 d = ray(p);
    const glm::vec3 hit = eye - d * (eye.y / d.y);
    return {hit.x + 0.37f, hit.z + 0.21f};
  }
  Seen at(glm::vec2 p) const {
    const glm::vec2 here = place(p);
    return {here, place(p + glm::vec2(1, 0)) - here, place(p + glm::vec2(0, 1)) - here, -ray(p)};
  }
};

float lodOf(const Seen& s, float part) {
  return std::log2(std::max(glm::length(s.across), glm::length(s.down)) * part * kSide);
}

enum class Method { mean_normal, one_lobe, toksvig, lean, strata };
constexpr std::array<const char*, 5> kNames{"mean normal", "one lobe", "Toksvig", "LEAN", "strata"};  // by Method

/// As shaders/surface/look_up_strata.glsl reads them: each as if it were a quarter as wide.
float lightOfStrata(const Bumps& bumps, const Light& light, const Seen& s, float part, glm::vec2 shift) {
  float sum = 0.0f;
  for (int i = 0; i < formula::kStrata; ++i) {
    const glm::vec2 at = part * formula::placeInStratum(i, shift);
    const float width = 0.25f * part / float(formula::kStrataAcross);
    const Moments m = bumps.at(s.uv + at.x * s.across + at.y * s.down, lodOf(s, width));
    sum += roundLobe(light, s.v, normalOf(m.slope), m.variance, shiftOf(shift, i), kLobeSamples / 2);
  }
  return sum / float(formula::kStrata);
}

/// What a sample of a pixel shows.
float sampleOf(Method method, const Bumps& bumps, const Light& light, const Seen& s, int samples, glm::vec2 shift) {
  const float part = 1.0f / std::sqrt(float(samples));
  const Moments m = bumps.at(s.uv, lodOf(s, part));
  const float length = glm::length(m.normal);
  switch (method) {
    case Method::one_lobe:
      return roundLobe(light, s.v, normalOf(m.slope), m.variance, shift, kLobeSamples);
    case Method::toksvig:
      return roundLobe(light, s.v, m.normal / length, std::max(1.0f - length, 0.0f) / length, shift, kLobeSamples);
    case Method::lean:
      return leanLobe(light, s.v, m, shift);
    case Method::strata:
      return lightOfStrata(bumps, light, s, part, shift);
    case Method::mean_normal:
      break;
  }
  return roundLobe(light, s.v, normalOf(m.slope), 0.0f, shift, kLobeSamples);
}

template <typename Sample>
std::vector<float> picture(const View& view, int samples, const Sample& sample) {
  std::vector<float> out(std::size_t(kSize.x * kSize.y));
  parallelFor(std::size_t(kSize.y), 1, [&](std::size_t b, std::size_t e) {
    for (std::size_t y = b; y < e; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        float sum = 0.0f;
        for (int i = 0; i < samples; ++i) {
          const Seen s = view.at(glm::vec2(x, y) + formula::sampleOffset(i, samples));
          sum += sample(s, random2(std::uint32_t(x), std::uint32_t(y), std::uint32_t(i)));
        }
        out[y * std::size_t(kSize.x) + std::size_t(x)] = std::min(sum / float(samples), 1.0f);
      }
  });
  return out;
}

double errorOf(const std::vector<float>& found, const std::vector<float>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) sum += double(found[i] - truth[i]) * double(found[i] - truth[i]);
  return std::sqrt(sum / double(truth.size()));
}

void printRow(HeightKind kind, const Bumps& bumps, const Light& light, float texels) {
  const View view(texels, kElevation);
  const auto truth = picture(view, kTruthSamples, [&](const Seen& s, glm::vec2 shift) {
    return roundLobe(light, s.v, normalOf(bumps.at(s.uv, 0.0f).slope), 0.0f, shift, 4);
  });
  std::printf("| %s, %g texels |", std::string(builtinHeightNames()[std::size_t(kind) - 1]).c_str(), double(texels));
  for (const int samples : {4, 8})
    for (std::size_t method = 0; method < kNames.size(); ++method) {
      const auto found = picture(view, samples, [&](const Seen& s, glm::vec2 shift) {
        return sampleOf(static_cast<Method>(method), bumps, light, s, samples, shift);
      });
      std::printf(" %.3f |", errorOf(found, truth));
    }
  std::printf("\n");
}

}  // namespace

int main() {
  const Light light("studio");
  std::printf("| surface, a pixel |");
  for (const int samples : {4, 8})
    for (const char* name : kNames) std::printf(" %s, %d |", name, samples);
  std::printf("\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const HeightKind kind : {HeightKind::orange, HeightKind::brick, HeightKind::waves}) {
    const Bumps bumps(kind);
    for (const float texels : {2.0f, 8.0f, 32.0f}) printRow(kind, bumps, light, texels);
  }
}
