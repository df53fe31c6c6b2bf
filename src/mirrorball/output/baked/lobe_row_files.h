#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// Where the rows of lobes of a set go: a texture of half floats, which hold the table as it is, and the same numbers
/// as text, for programs that read no such textures.
struct LobeRowFiles {
  std::string folder;
  int lobes = 4;  ///< 2, 4 or 6
  int zstandard_level = 0;
  bool has_text = true;

  static constexpr const char* kTextureName = "lobe_rows.ktx2";
  static constexpr const char* kTextName = "lobe_rows.json";
  std::string texture() const { return folder + "/" + kTextureName; }
  std::string text() const { return folder + "/" + kTextName; }
};

/// What a program must know to read a table of rows: the microfacets, lobes, size, axes, and what the channels are.
nlohmann::ordered_json lobeRowFacts(int lobes);

/// Writes the texture, which says what it is.
///
/// rows     lobeRowTable(files.lobes)
/// errors   as writeImageSet's
Result<void> writeLobeRows(const Image& rows, const LobeRowFiles& files);

/// lobe_rows.json: the facts and the numbers, of five digits, which tell half floats apart; a row of texels a line.
std::string lobeRowText(const Image& rows);

/// A table of lobe rows that was found in a file.
struct FoundLobeRows {
  std::string format;  ///< the file's
  glm::ivec2 size;     ///< [texels]
  int lobes;           ///< in a row
};

/// A table of lobe rows that bake wrote, by what the file says.
///
/// returns  nothing where it is none, or there is no such file
/// errors   what reading a file finds that says it is a table
Result<std::optional<FoundLobeRows>> lobeRowsIn(const std::string& path);

}  // namespace mirrorball
