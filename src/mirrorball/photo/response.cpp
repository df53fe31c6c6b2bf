#include "mirrorball/photo/response.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "formula/color.h"

namespace mirrorball {
namespace {

constexpr int kCodes = 256;
constexpr int kGreyCode = 128;

/// A symmetric positive definite system of 256 unknowns.
class NormalEquations {
 public:
  NormalEquations() : matrix_(std::size_t(kCodes) * kCodes, 0.0), right_(kCodes, 0.0) {}

  double& at(int row, int column) { return matrix_[std::size_t(row) * kCodes + std::size_t(column)]; }
  double& right(int row) { return right_[std::size_t(row)]; }

  /// By Cholesky's decomposition, in place.
  std::vector<double> solve() {
    for (int j = 0; j < kCodes; ++j) {
      for (int i = j; i < kCodes; ++i) {
        double sum = at(i, j);
        for (int k = 0; k < j; ++k) sum -= at(i, k) * at(j, k);
        at(i, j) = i == j ? std::sqrt(std::max(sum, 1e-12)) : sum / at(j, j);
      }
    }
    std::vector<double> x = right_;
    for (int i = 0; i < kCodes; ++i) {
      for (int k = 0; k < i; ++k) x[std::size_t(i)] -= at(i, k) * x[std::size_t(k)];
      x[std::size_t(i)] /= at(i, i);
    }
    for (int i = kCodes - 1; i >= 0; --i) {
      for (int k = i + 1; k < kCodes; ++k) x[std::size_t(i)] -= at(k, i) * x[std::size_t(k)];
      x[std::size_t(i)] /= at(i, i);
    }
    return x;
  }

 private:
  std::vector<double> matrix_;
  std::vector<double> right_;
};

/// What one channel of one place says: its code and the logarithm of the exposure, in each photograph that shows it.
struct Sample {
  std::vector<int> codes;
  std::vector<double> log_exposures;
};

/// Adds Σ w² (g(z) − ln t − ln E)² with the sample's light E at its best value, the weighted mean of g(z) − ln t.
void addSample(const Sample& sample, NormalEquations& equations) {
  double weights = 0.0;
  double log_exposure = 0.0;
  for (std::size_t j = 0; j < sample.codes.size(); ++j) {
    const double w = std::pow(trustInCode(sample.codes[j]), 2.0);
    weights += w;
    log_exposure += w * sample.log_exposures[j];
  }
  log_exposure /= weights;
  for (std::size_t j = 0; j < sample.codes.size(); ++j) {
    const double w = std::pow(trustInCode(sample.codes[j]), 2.0);
    equations.at(sample.codes[j], sample.codes[j]) += w;
    equations.right(sample.codes[j]) += w * (sample.log_exposures[j] - log_exposure);
    for (const int other : sample.codes)
      equations.at(sample.codes[j], other) -= w * std::pow(trustInCode(other), 2.0) / weights;
  }
}

/// ln light of a code by sRGB, whose slope near black is kept finite.
double srgbLogarithm(int code) {
  return std::log(double(formula::linearFromSrgb1((static_cast<float>(code) + 0.5f) / 255.5f)));
}

/// Adds λ Σ w² (g − s)″² with sRGB's s, and g(128) = s(128).
void addSmoothness(double strength, NormalEquations& equations) {
  constexpr std::array<double, 3> kSecondDifference{1.0, -2.0, 1.0};
  for (int code = 1; code + 1 < kCodes; ++code) {
    const double w = strength * std::pow(trustInCode(code), 2.0);
    const double bend = srgbLogarithm(code - 1) - 2.0 * srgbLogarithm(code) + srgbLogarithm(code + 1);
    for (int i = 0; i < 3; ++i) {
      const double share = w * kSecondDifference[std::size_t(i)];
      equations.right(code - 1 + i) += share * bend;
      for (int j = 0; j < 3; ++j) equations.at(code - 1 + i, code - 1 + j) += share * kSecondDifference[std::size_t(j)];
    }
  }
  equations.at(kGreyCode, kGreyCode) += 1e3 * strength;
  equations.right(kGreyCode) += 1e3 * strength * srgbLogarithm(kGreyCode);
}

/// g = ln light of every code, from samples of which no code is too often.
std::vector<double> solveCurve(const std::vector<Sample>& samples) {
  // Dark backgrounds would outvote all else: of each code in the first photograph that shows it, the first few count.
  constexpr int kMostOfOneCode = 60;
  std::array<int, kCodes> taken{};
  NormalEquations equations;
  int count = 0;
  for (const Sample& sample : samples) {
    if (taken[std::size_t(sample.codes.front())]++ >= kMostOfOneCode) continue;
    addSample(sample, equations);
    ++count;
  }
  // Stiff: cameras' curves bend from sRGB's over tens of codes, and a scene of few shades says nothing between them.
  constexpr double kSmoothness = 300.0;
  addSmoothness(kSmoothness * std::max(1.0, double(count) / kCodes), equations);
  return equations.solve();
}

/// Scaled to sRGB's light at code 128, and never falling.
std::array<float, kCodes> lightFromLogarithm(const std::vector<double>& logarithm) {
  const double grey = formula::linearFromSrgb1(kGreyCode / 255.0f);
  std::array<float, kCodes> light;
  double max_light = 0.0;
  for (std::size_t code = 0; code < kCodes; ++code) {
    max_light = std::max(max_light, grey * std::exp(logarithm[code] - logarithm[kGreyCode]));
    light[code] = static_cast<float>(max_light);
  }
  return light;
}

/// Of one curve for the three channels, scaled alike.
template <typename Curve>
Response responseBy(const Curve& curve) {
  const float grey = kGreyCode / 255.0f;
  const float scale = formula::linearFromSrgb1(grey) / curve(grey);
  Response response;
  for (auto& channel : response.light)
    for (std::size_t code = 0; code < kCodes; ++code) channel[code] = scale * curve(static_cast<float>(code) / 255.0f);
  return response;
}

}  // namespace

Response assumedResponse(ResponseKind kind) {
  if (kind == ResponseKind::srgb) return responseBy([](float encoded) { return formula::linearFromSrgb1(encoded); });
  return responseOfPower(kind == ResponseKind::gamma ? 2.2 : 1.0);
}

Response responseOfPower(double power) {
  return responseBy([power](float encoded) { return std::pow(encoded, static_cast<float>(power)); });
}

void forEachSmoothPlace(std::span<const Image8* const> codes,
                        const std::function<void(std::span<const std::array<double, 3>> mean)>& visit) {
  constexpr int kPlacesPerSide = 200;
  constexpr int kLargestStep = 20;  // between the darkest and the brightest code of the nine
  const Image8& first = *codes.front();
  const int step_x = std::max(1, first.width() / kPlacesPerSide);
  const int step_y = std::max(1, first.height() / kPlacesPerSide);
  std::vector<std::array<double, 3>> mean(codes.size());
  const auto isSmooth = [&](int x, int y) {
    for (std::size_t p = 0; p < codes.size(); ++p)
      for (int c = 0; c < 3; ++c) {
        int sum = 0, min = 255, max = 0;
        for (int j = -1; j <= 1; ++j)
          for (int i = -1; i <= 1; ++i) {
            const int code = codes[p]->texel(x + i, y + j)[c];
            sum += code;
            min = std::min(min, code);
            max = std::max(max, code);
          }
        if (max - min > kLargestStep) return false;
        mean[p][std::size_t(c)] = sum / 9.0;
      }
    return true;
  };
  for (int y = 1; y + 1 < first.height(); y += step_y)
    for (int x = 1; x + 1 < first.width(); x += step_x)
      if (isSmooth(x, y)) visit(mean);
}

Result<Response> recoverResponse(std::span<const Image8* const> codes, std::span<const double> exposures) {
  std::vector<Sample> samples;
  forEachSmoothPlace(codes, [&](std::span<const std::array<double, 3>> mean) {
    for (std::size_t c = 0; c < 3; ++c) {
      Sample sample;
      for (std::size_t p = 0; p < mean.size(); ++p) {
        const int code = static_cast<int>(std::lround(mean[p][c]));
        if (code < 2 || code >= kFirstClippedCode) continue;
        sample.codes.push_back(code);
        sample.log_exposures.push_back(std::log(exposures[p]));
      }
      if (sample.codes.size() >= 2) samples.push_back(std::move(sample));
    }
  });
  constexpr std::size_t kMinPlaces = 100;
  if (samples.size() < kMinPlaces)
    return fail(ErrorCode::bad_shape,
                "only " + std::to_string(samples.size()) +
                    " places are neither black nor clipped in two of the photographs, too few to recover the camera's "
                    "response; take them closer together",
                FixHint::name_response);
  Response response;
  response.light.fill(lightFromLogarithm(solveCurve(samples)));
  return response;
}

}  // namespace mirrorball
