#include "mirrorball/bake/lobe_row/lobe_row_table.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "formula/bsdf.h"
#include "mirrorball/bake/lobe_row/lobe_row_file.h"
#include "mirrorball/codec/texture/texture_file.h"

namespace mirrorball {

Result<Image> lobeRowTable() {
  MIRRORBALL_TRY(decoded, decodeImageSet(lobeRowFile()));
  return std::move(decoded.images.at(0, 0));
}

Result<Image> lobeRowTable(int lobes) {
  MIRRORBALL_TRY(all, lobeRowTable());
  Image rows(lobes * formula::kLobeRowSize, all.height(), all.channels());
  const auto begin = std::size_t(formula::firstOfRow(lobes) * formula::kLobeRowSize * all.channels());
  for (int y = 0; y < rows.height(); ++y)
    std::ranges::copy(all.row(y).subspan(begin, rows.row(y).size()), rows.row(y).begin());
  return rows;
}

}  // namespace mirrorball
