#include "mirrorball/codec/exr_sizes.h"

#include <algorithm>
#include <string_view>

#include "mirrorball/codec/byte_order.h"
#include "mirrorball/image/image.h"

namespace mirrorball {
namespace {

/// The most texels that one byte of a real file stands for: a black 8192 × 4096 image of one
/// channel has 5300 a byte with DWAB, and at most 450 with the other compressions. More than this
/// is a lie that would only cost memory.
constexpr std::size_t kMostTexelsPerByte = 1 << 14;

/// In the version field, behind the magic number: the file has several parts.
constexpr std::uint32_t kMultiPart = 0x1000;

class HeaderWalker {
 public:
  HeaderWalker(std::span<const std::uint8_t> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

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
    return fail(ErrorCode::bad_file, name_ + ": the header ends early, at byte " + std::to_string(bytes_.size()) +
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
        return fail(ErrorCode::bad_file, name_ + ": the header's attribute at byte " + std::to_string(at_ - 4) +
                                             " says it has " + std::to_string(size) +
                                             " bytes, more than the file; it is truncated or damaged");
      MIRRORBALL_TRY_VOID(checkAttribute(attribute, type, size));
      at_ += size;
    }
  }

  Result<void> checkAttribute(std::string_view attribute, std::string_view type, std::size_t size) {
    if (attribute == "dataWindow" && type == "box2i" && size == 16)
      return checkTexels(name_, signedAt(at_ + 8) - signedAt(at_) + 1, signedAt(at_ + 12) - signedAt(at_ + 4) + 1);
    if (attribute == "tiles" && type == "tiledesc" && size == 9)
      return checkTexels(name_ + ": one of its tiles", numberAt(at_), numberAt(at_ + 4));
    if (attribute == "chunkCount" && type == "int" && size == 4) {
      constexpr std::size_t kOffsetSize = 8;
      if (numberAt(at_) > bytes_.size() / kOffsetSize) return truncated();
    }
    return {};
  }

  Result<void> checkTexels(const std::string& what, long long width, long long height) const {
    MIRRORBALL_TRY_VOID(checkDimensions(what, width, height));
    if (static_cast<std::size_t>(width * height) / kMostTexelsPerByte > bytes_.size())
      return fail(ErrorCode::bad_file, what + ": says its size is " + std::to_string(width) + "x" +
                                           std::to_string(height) + ", which the file's " +
                                           std::to_string(bytes_.size()) +
                                           " bytes cannot hold; it is truncated or damaged");
    return {};
  }

  std::span<const std::uint8_t> bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

}  // namespace

Result<void> checkExrSizes(std::span<const std::uint8_t> bytes, const std::string& name) {
  return HeaderWalker(bytes, name).walk();
}

}  // namespace mirrorball
