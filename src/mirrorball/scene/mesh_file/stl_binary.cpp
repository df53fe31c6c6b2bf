#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/mesh_file/number_text.h"
#include "mirrorball/scene/mesh_file/stl_facets.h"
#include "mirrorball/scene/mesh_file/vertex_colors.h"

namespace mirrorball {
namespace {

constexpr std::size_t kStlHeaderSize = 84;
constexpr std::size_t kStlCountAt = 80;
constexpr std::size_t kFacetSize = 50;
constexpr std::size_t kCornersAt = 12;  // after the facet's normal
constexpr std::size_t kAttributesAt = 48;
constexpr std::uint16_t kColorBit = 0x8000;

static_assert(std::endian::native == std::endian::little, "binary STL is read without swapping bytes");

template <typename Value>
Value valueAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  Value value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::array<glm::dvec3, 3> readCorners(std::span<const std::uint8_t> facet) {
  std::array<glm::dvec3, 3> corners;
  const auto numbers = valueAt<std::array<float, 9>>(facet, kCornersAt);
  for (std::size_t i = 0; i < 3; ++i) corners[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  return corners;
}

/// Whether a facet's normal is one, or 0 as programs write that have none.
bool hasNormal(std::span<const std::uint8_t> facet) {
  constexpr float kLengthError = 0.01f;
  const auto numbers = valueAt<std::array<float, 3>>(facet, 0);
  const float length = glm::length(glm::vec3(numbers[0], numbers[1], numbers[2]));
  return length == 0.0f || std::abs(length - 1.0f) < kLengthError;
}

/// The facets of a binary STL, as many as the file holds.
class BinaryStl {
 public:
  explicit BinaryStl(std::span<const std::uint8_t> bytes)
      : bytes_(bytes), named_(valueAt<std::uint32_t>(bytes, kStlCountAt)) {
    const std::size_t held = (bytes.size() - kStlHeaderSize) / kFacetSize;
    const bool fills_file = (bytes.size() - kStlHeaderSize) % kFacetSize == 0;
    // Something may lie behind the facets. But where none are named, and what looks like more of them, is facets.
    count_ = named_ > 0 && named_ < held && !(fills_file && areFacetsBehind(held)) ? named_ : held;
  }

  std::size_t count() const { return count_; }
  std::span<const std::uint8_t> facet(std::size_t index) const {
    return bytes_.subspan(kStlHeaderSize + index * kFacetSize, kFacetSize);
  }
  std::uint16_t attributes(std::size_t index) const { return valueAt<std::uint16_t>(facet(index), kAttributesAt); }

  /// Whether its bytes may be facets: of any other file some are numbers as no model has. Those that are none at all do
  /// not count.
  bool hasFacets() const {
    std::size_t likely = 0, unlikely = 0;
    for (std::size_t i = 0; i < count_; ++i)
      for (const glm::dvec3& corner : readCorners(facet(i)))
        for (int axis = 0; axis < 3; ++axis) {
          const double size = std::abs(corner[axis]);
          if (std::isfinite(size)) ++(size == 0.0 || (size > 1e-15 && size < 1e15) ? likely : unlikely);
        }
    return likely > 9 * unlikely || (hasStlSize(bytes_) && count_ > 0);
  }

  void tell(std::vector<std::string>& remarks) const {
    const std::size_t behind = bytes_.size() - kStlHeaderSize - count_ * kFacetSize;
    if (named_ != count_)
      remarks.push_back("its header names " + counted(named_, "facet") + ", and it holds " + std::to_string(count_) +
                        (named_ > count_ ? ", which are shown; it may be truncated" : ", which are shown"));
    else if (behind > 0)
      remarks.push_back(countedAre(behind, "byte") + " behind its last facet: left out");
  }

  /// The free text.
  std::string_view text() const { return {reinterpret_cast<const char*>(bytes_.data()), kStlCountAt}; }

 private:
  /// Whether what lies behind the named facets, up to that many, is more of them: triangles with normals of length 1 or
  /// 0, not far from the others. Zeros fill a file up.
  bool areFacetsBehind(std::size_t held) const {
    constexpr double kReach = 1000.0;  // of the others' size
    glm::dvec3 least(std::numeric_limits<double>::max()), greatest(std::numeric_limits<double>::lowest());
    for (std::size_t i = 0; i < named_; ++i)
      for (const glm::dvec3& corner : readCorners(facet(i))) {
        if (std::isnan(toPlace(corner).x)) continue;
        least = glm::min(least, corner);
        greatest = glm::max(greatest, corner);
      }
    const double reach = kReach * glm::length(greatest - least);
    const glm::dvec3 middle = 0.5 * (least + greatest);
    std::size_t likely = 0;
    for (std::size_t i = named_; i < held; ++i) {
      const std::array<glm::dvec3, 3> corners = readCorners(facet(i));
      const bool is_near = std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
        return glm::length(corner - middle) <= reach;  // no NaN is
      });
      const bool is_point = corners[0] == corners[1] && corners[1] == corners[2];
      likely += is_near && !is_point && hasNormal(facet(i)) ? 1 : 0;
    }
    return 10 * likely >= 9 * (held - named_);
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t named_;
  std::size_t count_;
};

/// A colour of 5 bits each, the first in the lowest.
glm::vec3 colorOfBits(std::uint16_t bits) { return glm::vec3(bits & 31, (bits >> 5) & 31, (bits >> 10) & 31) / 31.0f; }

/// The colours of the facets that are kept, in whichever of two ways the file has them.
class FacetColors {
 public:
  explicit FacetColors(const BinaryStl& file) : file_(file) {
    constexpr std::string_view kKey = "COLOR=";
    const std::size_t at = file.text().find(kKey);
    is_magics_ = at != std::string_view::npos && at + kKey.size() + 4 <= file.text().size();
    if (is_magics_)
      for (int channel = 0; channel < 3; ++channel)
        of_object_[channel] =
            static_cast<float>(static_cast<unsigned char>(file.text()[at + kKey.size() + std::size_t(channel)])) /
            255.0f;
    for (std::size_t i = 0; i < file.count(); ++i) {
      has_any_ = has_any_ || file.attributes(i) != 0;
      has_bit_ = has_bit_ || (file.attributes(i) & kColorBit) != 0;
    }
  }

  bool exist() const { return is_magics_ || has_bit_; }

  glm::vec3 linear(std::size_t facet) const {
    const std::uint16_t bits = file_.attributes(facet);
    const bool has_bit = (bits & kColorBit) != 0;
    if (is_magics_) return linearFromCodes(has_bit || !has_any_ ? of_object_ : colorOfBits(bits));
    const glm::vec3 color = colorOfBits(bits);
    return has_bit ? linearFromCodes({color.b, color.g, color.r}) : Material().base_color;
  }

  void tell(std::vector<std::string>& remarks) const {
    if (is_magics_ && !has_any_)
      remarks.emplace_back(
          "its facets have no colours, but it has one as a whole, by Magics' 'COLOR=', and is shown in it");
    if (!is_magics_ && has_bit_)
      remarks.emplace_back("the attributes of its facets are read as colours, in the way of SolidView and VisCAM");
  }

 private:
  const BinaryStl& file_;
  glm::vec3 of_object_{1.0f};
  bool is_magics_ = false;
  bool has_any_ = false;
  bool has_bit_ = false;
};

}  // namespace

bool hasStlSize(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kStlHeaderSize) return false;
  return bytes.size() == kStlHeaderSize + std::uint64_t{kFacetSize} * valueAt<std::uint32_t>(bytes, kStlCountAt);
}

Result<StlFacets> readStlBinary(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kStlHeaderSize + kFacetSize)
    return fail(ErrorCode::bad_file, "holds no facets; it is not an STL file, or ends before the first");
  const BinaryStl file(bytes);
  if (!file.hasFacets())
    return fail(ErrorCode::bad_file,
                "is not an STL file: it has no facets in words ('vertex …'), nor are its bytes those of binary ones");
  MIRRORBALL_TRY_VOID(checkStlMemory(std::uint64_t{3} * file.count()));
  StlFacets facets;
  const FacetColors colors(file);
  facets.corners.reserve(3 * file.count());
  if (colors.exist()) facets.colors.reserve(file.count());
  for (std::size_t i = 0; i < file.count(); ++i) {
    const std::array<glm::dvec3, 3> corners = readCorners(file.facet(i));
    const auto isPlace = [](glm::dvec3 place) { return !std::isnan(toPlace(place).x); };
    if (!std::all_of(corners.begin(), corners.end(), isPlace)) {
      ++facets.repair.triangles_of_no_place;
      continue;
    }
    facets.corners.insert(facets.corners.end(), corners.begin(), corners.end());
    if (colors.exist()) facets.colors.push_back(colors.linear(i));
  }
  file.tell(facets.remarks);
  colors.tell(facets.remarks);
  return facets;
}

}  // namespace mirrorball
