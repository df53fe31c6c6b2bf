#include "boxes.h"

#include <algorithm>

#include "mirrorball/codec/byte_order.h"

namespace mirrorball::fuzz {
namespace {

/// How many bytes stand before the boxes that are in a box; nothing where none are.
std::optional<std::size_t> bytesBeforeBoxes(std::string_view type, std::span<const std::uint8_t> content) {
  if (type == "meta" || type == "iref") return 4;
  if (type == "iprp" || type == "ipco") return 0;
  if (type == "iinf") return !content.empty() && content[0] > 0 ? 8 : 6;  // by its version
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<FileBox>> boxesIn(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kHeader = 8, kLargeHeader = 16;
  std::vector<FileBox> boxes;
  while (!bytes.empty()) {
    if (bytes.size() < kHeader) return std::nullopt;
    std::uint64_t size = bigU32(bytes.data());
    std::size_t header = kHeader;
    if (size == 0) size = bytes.size();  // up to the end
    if (size == 1) {
      if (bytes.size() < kLargeHeader) return std::nullopt;
      size = std::uint64_t{bigU32(bytes.data() + 8)} << 32 | bigU32(bytes.data() + 12);
      header = kLargeHeader;
    }
    if (size < header || size > bytes.size()) return std::nullopt;
    FileBox box{std::string(bytes.begin() + 4, bytes.begin() + kHeader)};
    const auto content = bytes.first(static_cast<std::size_t>(size)).subspan(header);
    const std::size_t before = bytesBeforeBoxes(box.type, content).value_or(content.size());
    if (before > content.size()) return std::nullopt;
    box.content.assign(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(before));
    auto inner = boxesIn(content.subspan(before));
    if (!inner) return std::nullopt;
    box.boxes = std::move(*inner);
    boxes.push_back(std::move(box));
    bytes = bytes.subspan(static_cast<std::size_t>(size));
  }
  return boxes;
}

Bytes bytesOfBoxes(const std::vector<FileBox>& boxes) {
  constexpr std::size_t kHeader = 8;
  Bytes bytes;
  for (const FileBox& box : boxes) {
    const Bytes inner = bytesOfBoxes(box.boxes);
    appendBig(bytes, kHeader + box.content.size() + inner.size(), 4);
    bytes.insert(bytes.end(), box.type.begin(), box.type.end());
    bytes.insert(bytes.end(), box.content.begin(), box.content.end());
    bytes.insert(bytes.end(), inner.begin(), inner.end());
  }
  return bytes;
}

FileBox* firstBox(std::vector<FileBox>& boxes, std::string_view type) {
  const auto found = std::ranges::find(boxes, type, &FileBox::type);
  return found == boxes.end() ? nullptr : &*found;
}

void appendBig(Bytes& bytes, std::uint64_t number, std::size_t count) {
  for (std::size_t byte = count; byte-- > 0;) bytes.push_back(static_cast<std::uint8_t>(number >> 8 * byte));
}

}  // namespace mirrorball::fuzz
