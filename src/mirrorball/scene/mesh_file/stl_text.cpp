#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/mesh_file/number_text.h"
#include "mirrorball/scene/mesh_file/stl_facets.h"
#include "mirrorball/scene/mesh_file/text_scanner.h"

namespace mirrorball {
namespace {

bool isSameLetter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

bool isKeyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), isSameLetter);
}

/// How often a keyword occurs in a text.
std::size_t keywordCount(std::string_view text, std::string_view keyword) {
  std::size_t count = 0;
  auto at = text.begin();
  while ((at = std::search(at, text.end(), keyword.begin(), keyword.end(), isSameLetter)) != text.end()) {
    ++count;
    at += std::ptrdiff_t(keyword.size());
  }
  return count;
}

class StlTextReader {
 public:
  explicit StlTextReader(std::string_view text) : scanner_(text) {}

  StlFacets read() {
    for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) take(word);
    endFacet();
    if (!has_end_) facets_.remarks.emplace_back("does not end with 'endsolid'; it may be truncated");
    if (of_other_corners_ > 0)
      facets_.remarks.push_back(countedAre(of_other_corners_, "facet") + " left out that " +
                                (of_other_corners_ == 1 ? "has" : "have") + " not three corners");
    for (std::string& remark : numbers_.remarks()) facets_.remarks.push_back(std::move(remark));
    return std::move(facets_);
  }

 private:
  void take(std::string_view word) {
    if (isKeyword(word, "vertex")) {
      addCorner();
    } else if (isKeyword(word, "facet") || isKeyword(word, "endfacet")) {
      endFacet();
    } else if (isKeyword(word, "solid") || isKeyword(word, "endsolid")) {
      endFacet();
      scanner_.restOfLine();  // its name, which may be any words
      has_end_ = isKeyword(word, "endsolid") || is_after_end_;
    }
    is_after_end_ = isKeyword(word, "end");
  }

  void addCorner() {
    std::array<std::string_view, 3> words;
    for (std::string_view& word : words) word = scanner_.word();
    glm::dvec3& corner = facet_[count_++];
    // What a file ends with, and not behind, may be a part of a number.
    if (scanner_.isAtEnd()) return;
    for (int axis = 0; axis < 3; ++axis) corner[axis] = numbers_.read(words[std::size_t(axis)], scanner_.line()).value;
    if (count_ < 3) return;
    count_ = 0;
    const auto isPlace = [](glm::dvec3 place) { return !std::isnan(toPlace(place).x); };
    if (std::all_of(facet_.begin(), facet_.end(), isPlace))
      facets_.corners.insert(facets_.corners.end(), facet_.begin(), facet_.end());
    else
      ++facets_.repair.triangles_of_no_place;
  }

  void endFacet() {
    if (count_ > 0) ++of_other_corners_;
    count_ = 0;
  }

  TextScanner scanner_;
  NumberReader numbers_;
  StlFacets facets_;
  std::array<glm::dvec3, 3> facet_{};
  std::size_t count_ = 0;  // of its corners so far
  std::size_t of_other_corners_ = 0;
  bool is_after_end_ = false;  // "end solid" is what some programs write
  bool has_end_ = false;
};

}  // namespace

std::optional<std::string_view> stlText(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kBegin = 512;
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (all.substr(0, kBegin).find('\0') != std::string_view::npos) return {};
  const std::string_view text = withoutByteOrderMark(all);
  constexpr std::string_view kVertex = "vertex";
  if (std::search(text.begin(), text.end(), kVertex.begin(), kVertex.end(), isSameLetter) == text.end()) return {};
  return text;
}

Result<StlFacets> readStlText(std::string_view text) {
  MIRRORBALL_TRY_VOID(checkStlMemory(keywordCount(text, "vertex")));
  return StlTextReader(text).read();
}

}  // namespace mirrorball
