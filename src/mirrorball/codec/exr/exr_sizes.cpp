#include "mirrorball/codec/exr/exr_sizes.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/image/image.h"

namespace mirrorball {
namespace {

/// The most texels that one byte of a real file stands for: a black 8192 × 4096 image of one
/// channel has 5300 a byte with DWAB, and at most 450 with the other compressions. More than this
/// is a lie that would only cost memory.
constexpr std::size_t kMaxTexelsPerByte = 1 << 14;

/// In the version field, behind the magic number: the file has several parts.
constexpr std::uint32_t kMultiPart = 0x1000;

/// Attribute types that OpenEXR reads without a look at the stated size: were another size believed here, the two would
/// read different headers from there on.
struct FixedSize {
  std::string_view type;
  std::size_t size;
};
constexpr FixedSize kFixedSizes[] = {
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
};

class HeaderWalker {
 public:
  HeaderWalker(std::span<const std::uint8_t> bytes, std::uint64_t file_size) : bytes_(bytes), file_size_(file_size) {}

  Result<void> walk() {
    if (bytes_.size() < 8) return truncated();
    const bool multi_part = (numberAt(4) & kMultiPart) != 0;
    at_ = 8;
    do {
      MIRRORBALL_TRY_VOID(walkHeader());
      // An empty header ends the list of parts.
    } while (multi_part && at_ < bytes_.size() && bytes_[at_] != 0);
    return {};
  }

 private:
  tl::unexpected<Error> truncated() const {
    return fail(ErrorCode::bad_file, "the header ends early, at byte " + std::to_string(bytes_.size()) +
                                         "; the file is truncated or damaged");
  }

  std::uint32_t numberAt(std::size_t at) const { return littleU32(bytes_.data() + at); }
  long long signedAt(std::size_t at) const { return static_cast<std::int32_t>(numberAt(at)); }

  /// A text with a zero behind it.
  Result<std::string_view> takeText() {
    const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto end = std::find(begin, bytes_.end(), 0);
    if (end == bytes_.end()) return truncated();
    const std::string_view text(reinterpret_cast<const char*>(bytes_.data()) + at_,
                                static_cast<std::size_t>(end - begin));
    at_ += text.size() + 1;
    return text;
  }

  /// Attributes, each a name, a type, a size and so many bytes, up to an empty name.
  Result<void> walkHeader() {
    while (true) {
      MIRRORBALL_TRY(attribute, takeText());
      if (attribute.empty()) return {};
      MIRRORBALL_TRY(type, takeText());
      if (bytes_.size() - at_ < 4) return truncated();
      const std::size_t size = numberAt(at_);
      at_ += 4;
      if (size > bytes_.size() - at_)
        return fail(ErrorCode::bad_file, "the header's attribute at byte " + std::to_string(at_ - 4) + " says it has " +
                                             std::to_string(size) +
                                             " bytes, more than the file; it is truncated or damaged");
      if (!isRightSize(type, size))
        return fail(ErrorCode::bad_file, "the header's attribute at byte " + std::to_string(at_ - 4) + " says it has " +
                                             counted(size, "byte") +
                                             ", which its type does not have; the file is damaged");
      MIRRORBALL_TRY_VOID(checkAttribute(attribute, type, size));
      at_ += size;
    }
  }

  /// Whether an attribute's value, which lies within the file, ends where its size says.
  bool isRightSize(std::string_view type, std::size_t size) const {
    if (type == "chlist") return isChannelList(bytes_.subspan(at_, size));
    if (type == "preview")
      return size >= 8 && std::uint64_t{numberAt(at_)} * numberAt(at_ + 4) == (size - 8) / 4 && size % 4 == 0;
    const auto* fixed = std::find_if(std::begin(kFixedSizes), std::end(kFixedSizes),
                                     [&](const FixedSize& known) { return known.type == type; });
    return fixed == std::end(kFixedSizes) || fixed->size == size;
  }

  /// Names, each with 16 bytes behind it, then an empty name.
  static bool isChannelList(std::span<const std::uint8_t> list) {
    constexpr std::size_t kBytesBehindName = 16;
    while (!list.empty()) {
      const auto length = static_cast<std::size_t>(std::find(list.begin(), list.end(), 0) - list.begin());
      if (length == 0) return list.size() == 1;
      if (list.size() - length < 1 + kBytesBehindName) return false;
      list = list.subspan(length + 1 + kBytesBehindName);
    }
    return false;
  }

  Result<void> checkAttribute(std::string_view attribute, std::string_view type, std::size_t size) {
    if (attribute == "dataWindow" && type == "box2i" && size == 16)
      return checkTexels(signedAt(at_ + 8) - signedAt(at_) + 1, signedAt(at_ + 12) - signedAt(at_ + 4) + 1);
    if (attribute == "tiles" && type == "tiledesc" && size == 9)
      return withName("one of its tiles", checkTexels(numberAt(at_), numberAt(at_ + 4)));
    if (attribute == "chunkCount" && type == "int" && size == 4) {
      constexpr std::size_t kOffsetSize = 8;
      if (numberAt(at_) > file_size_ / kOffsetSize) return truncated();
    }
    return {};
  }

  Result<void> checkTexels(long long width, long long height) const {
    MIRRORBALL_TRY_VOID(checkDimensions(width, height));
    if (static_cast<std::size_t>(width * height) / kMaxTexelsPerByte > file_size_)
      return fail(ErrorCode::bad_file, "says its size is " + std::to_string(width) + "x" + std::to_string(height) +
                                           ", which the file's " + std::to_string(file_size_) +
                                           " bytes cannot hold; it is truncated or damaged");
    return {};
  }

  std::span<const std::uint8_t> bytes_;
  std::uint64_t file_size_;
  std::size_t at_ = 0;
};

}  // namespace

Result<void> checkExrSizes(std::span<const std::uint8_t> bytes, std::uint64_t file_size) {
  return HeaderWalker(bytes, file_size).walk();
}

}  // namespace mirrorball
