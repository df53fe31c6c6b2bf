#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "formula/bsdf.h"
#include "mirrorball/bake/lobe_row/lobe_row_fit.h"
#include "mirrorball/bake/lobe_row/lobe_row_table.h"
#include "mirrorball/bake/lobe_row/rough_lobe.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr int kSize = formula::kLobeRowSize;
constexpr int kMiddle = kSize / 2;
constexpr std::array<int, 3> kRows{2, 4, 6};

/// How strongly a row is pulled to its neighbours. Without, lobes change their roles from one to the next.
constexpr double kSmoothness = 3e-3;

/// How often all rows are fitted beside the mean of their neighbours.
constexpr int kSweeps = 10;

/// The lobe of a place of the table. Rows below a roughness of 0.08 are that one's, since small lobes are alike but for
/// their size; and neither end of n·v has a lobe.
RoughLobe lobeAt(int x, int y) {
  constexpr int kCircles = 56;
  const double root = double(x) / (kSize - 1);
  const float roughness = std::max(float(y) / float(kSize - 1), 0.08f);
  return RoughLobe::make(roughness, std::clamp(root * root, 2e-3, 0.99999), kCircles);
}

/// The rows of one count of lobes, for all places.
class RowGrid {
 public:
  RowGrid(const std::vector<RoughLobe>& lobes, ProgressCounter& counter)
      : lobes_(lobes), counter_(counter), rows_(lobes.size()) {}

  void fit(int count) {
    at(kMiddle, kMiddle) = mirrorball::fitted(lobe(kMiddle, kMiddle), RowParameters::even(count), {}, 200);
    for (int y = kMiddle + 1; y < kSize; ++y) fitBeside(kMiddle, y, kMiddle, y - 1);
    for (int y = kMiddle - 1; y >= 0; --y) fitBeside(kMiddle, y, kMiddle, y + 1);
    parallelFor(kSize, 1, [&](std::size_t begin, std::size_t) {
      const int y = static_cast<int>(begin);
      for (int x = kMiddle + 1; x < kSize; ++x) fitBeside(x, y, x - 1, y);
      for (int x = kMiddle - 1; x >= 0; --x) fitBeside(x, y, x + 1, y);
    });
    for (int sweep = 0; sweep < kSweeps; ++sweep) smooth();
  }

  /// What fit() tells the counter of.
  static constexpr std::size_t kSteps = std::size_t(kSize) * kSize * (1 + kSweeps);

  const RowParameters& row(int x, int y) const { return rows_[std::size_t(y * kSize + x)]; }

 private:
  RowParameters& at(int x, int y) { return rows_[std::size_t(y * kSize + x)]; }
  const RoughLobe& lobe(int x, int y) const { return lobes_[std::size_t(y * kSize + x)]; }

  void fitBeside(int x, int y, int beside_x, int beside_y) {
    if (counter_.stopped()) return;
    const RowParameters& beside = row(beside_x, beside_y);
    at(x, y) = mirrorball::fitted(lobe(x, y), beside, {&beside, kSmoothness}, 40);
    counter_.advance();
  }

  /// The mean of the neighbours; at an edge, of the one inside.
  RowParameters meanBeside(int x, int y) const {
    RowParameters mean = row(x, y);
    const std::array<const RowParameters*, 4> beside{
        &row(x == 0 ? 1 : x - 1, y), &row(x == kSize - 1 ? kSize - 2 : x + 1, y), &row(x, y == 0 ? 1 : y - 1),
        &row(x, y == kSize - 1 ? kSize - 2 : y + 1)};
    for (std::size_t k = 0; k < mean.values.size(); ++k) {
      mean.values[k] = 0.0;
      for (const RowParameters* one : beside) mean.values[k] += one->values[k] / 4.0;
    }
    return mean;
  }

  void smooth() {
    std::vector<RowParameters> smoothed = rows_;
    parallelFor(rows_.size(), kSize, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !counter_.stopped(); ++i) {
        const RowParameters mean = meanBeside(static_cast<int>(i) % kSize, static_cast<int>(i) / kSize);
        smoothed[i] = mirrorball::fitted(lobes_[i], rows_[i], {&mean, kSmoothness}, 15);
        counter_.advance();
      }
    });
    rows_ = std::move(smoothed);
  }

  const std::vector<RoughLobe>& lobes_;
  ProgressCounter& counter_;
  std::vector<RowParameters> rows_;
};

}  // namespace

Result<Image> fittedLobeRowTable(const ProgressFunction& progress) {
  ProgressCounter counter(progress, RowGrid::kSteps * kRows.size());
  std::vector<RoughLobe> lobes;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) lobes.push_back(lobeAt(x, y));
  Image table(kSize * kLobesInRows, kSize, 4);
  for (const int count : kRows) {
    RowGrid grid(lobes, counter);
    grid.fit(count);
    MIRRORBALL_TRY_VOID(counter.result());
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const std::vector<glm::vec4> texels = texelsOf(grid.row(x, y));
        for (int lobe = 0; lobe < count; ++lobe) {
          float* texel = table.texel((formula::firstOfRow(count) + lobe) * kSize + x, y);
          for (int channel = 0; channel < 4; ++channel) texel[channel] = texels[std::size_t(lobe)][channel];
        }
      }
  }
  return table;
}

}  // namespace mirrorball
