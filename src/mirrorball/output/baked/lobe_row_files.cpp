#include "mirrorball/output/baked/lobe_row_files.h"

#include <array>
#include <cstdio>
#include <utility>

#include <nlohmann/json.hpp>

#include "formula/bsdf.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/file/recognize.h"
#include "mirrorball/output/baked/table_file.h"

namespace mirrorball {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDistribution = "ggx";  // that bake/lobe_row/ fits

Metadata lobeRowMetadata(int lobes) {
  Metadata metadata = metadataOfLobeRows();
  metadata["mirrorball:lobe_rows_distribution"] = kDistribution;
  metadata["mirrorball:lobe_rows_lobes"] = std::to_string(lobes);
  return metadata;
}

/// "[0.25,1,0.5,0.5]"
std::string textOfTexel(const float* texel) {
  std::array<char, 96> text;
  std::snprintf(text.data(), text.size(), "[%.5g,%.5g,%.5g,%.5g]", double(texel[0]), double(texel[1]), double(texel[2]),
                double(texel[3]));
  return text.data();
}

/// The texels of one lobe: a line for each roughness.
std::string textOfLobe(const Image& rows, int lobe) {
  std::string text;
  for (int y = 0; y < rows.height(); ++y) {
    text += y == 0 ? "      [" : ",\n      [";
    for (int x = 0; x < formula::kLobeRowSize; ++x)
      text += (x == 0 ? "" : ",") + textOfTexel(rows.texel(lobe * formula::kLobeRowSize + x, y));
    text += "]";
  }
  return text;
}

}  // namespace

Json lobeRowFacts(int lobes) {
  return {{"distribution", kDistribution},
          {"lobes", lobes},
          {"size", formula::kLobeRowSize},
          {"axes",
           "each lobe has size columns, lobes beside each other: sqrt(n.v) to the right, the perceptual roughness "
           "downwards; 0 and 1 are at the centres of a lobe's first and last texels"},
          {"channels",
           {"offset of the lobe's direction, normalize(r + alpha offset (n - (n.r) r)): r the mirror direction, alpha "
            "the perceptual roughness squared",
            "its perceptual roughness over the surface's; their product is at most 1",
            "weight of the light that facets reflect at normal incidence",
            "weight of the light that they reflect more at grazing angles"}}};
}

Result<void> writeLobeRows(const Image& rows, const LobeRowFiles& files) {
  return writeImageSet(files.texture(), ImageSet(rows),
                       {.zstandard_level = files.zstandard_level, .metadata = lobeRowMetadata(files.lobes)});
}

std::string lobeRowText(const Image& rows) {
  const int lobes = rows.width() / formula::kLobeRowSize;
  Json head = lobeRowFacts(lobes);
  head["order"] = "a list for each lobe, in it one for each roughness, in it the channels for each sqrt(n.v)";
  std::string text = head.dump(2);
  text.replace(text.rfind("\n}"), std::string::npos, ",\n  \"rows\": [\n");
  for (int lobe = 0; lobe < lobes; ++lobe)
    text += "    [\n" + textOfLobe(rows, lobe) + (lobe + 1 < lobes ? "\n    ],\n" : "\n    ]\n");
  return text + "  ]\n}\n";
}

Result<std::optional<FoundLobeRows>> lobeRowsIn(const std::string& path) {
  MIRRORBALL_TRY(file, tableFileIn(path));
  if (!file || !isLobeRows(file->metadata)) return std::nullopt;
  const glm::ivec2 size(file->table.width(), file->table.height());
  return FoundLobeRows{std::move(file->format), size, size.x / size.y};
}

}  // namespace mirrorball
