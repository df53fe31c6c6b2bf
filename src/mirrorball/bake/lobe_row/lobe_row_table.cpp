#include "mirrorball/bake/lobe_row/lobe_row_table.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "formula/bsdf.h"
#include "mirrorball/bake/lobe_row/lobe_row_file.h"
#include "mirrorball/codec/texture/texture_file.h"

namespace mirrorball {

namespace {

glm::vec4 bilinearTexel(const Image& table, glm::vec2 place) {
  const auto at = [&](int x, int y) {
    return rgbaAt(table, std::clamp(x, 0, table.width() - 1), std::clamp(y, 0, table.height() - 1));
  };
  const glm::vec2 corner = glm::floor(place - 0.5f);
  const glm::vec2 part = place - 0.5f - corner;
  const int x = static_cast<int>(corner.x);
  const int y = static_cast<int>(corner.y);
  return glm::mix(glm::mix(at(x, y), at(x + 1, y), part.x), glm::mix(at(x, y + 1), at(x + 1, y + 1), part.x), part.y);
}

}  // namespace

Result<Image> lobeRowTable() {
  MIRRORBALL_TRY(decoded, decodeImageSet(lobeRowFile()));
  return std::move(decoded.images.at(0, 0));
}

Result<Image> lobeRowTable(int lobes) {
  MIRRORBALL_TRY(all, lobeRowTable());
  Image rows(lobes * formula::kLobeRowSize, all.height(), all.channels());
  const auto begin = std::size_t(formula::firstOfRow(lobes) * formula::kLobeRowSize * all.channels());
  for (int y = 0; y < rows.height(); ++y)
    std::copy_n(all.row(y).begin() + std::ptrdiff_t(begin), rows.row(y).size(), rows.row(y).begin());
  return rows;
}

std::vector<glm::vec4> lobeRowIn(const Image& table, int first, int count, float perceptual_roughness, float cosine) {
  std::vector<glm::vec4> row;
  for (int lobe = first; lobe < first + count; ++lobe)
    row.push_back(bilinearTexel(table, formula::placeInLobeRows(lobe, perceptual_roughness, cosine)));
  return row;
}

}  // namespace mirrorball
