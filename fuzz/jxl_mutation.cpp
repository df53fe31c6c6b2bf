#include "jxl_mutation.h"

#include <algorithm>
#include <utility>

#include "chance.h"
#include "mirrorball/codec/byte_order.h"

namespace mirrorball::fuzz {
namespace {

constexpr std::uint8_t kJxlSignature[] = {0, 0, 0, 12, 'J', 'X', 'L', ' ', 13, 10, 0x87, 10};
constexpr std::size_t kJxlPlace = 4;  // bytes of a box jxlp that say which part of the code stream it has

/// Changes a code stream. A picture's size and samples are in its first bytes, then the frame's header, and all that is
/// behind takes the decoder of pixels.
void changeJxlCode(Bytes& code, std::mt19937& random) {
  constexpr std::size_t kStart = 2;  // FF 0A
  const std::size_t half = std::max(code.size() / 2, kStart);
  const std::size_t kept =
      onceIn(16, random) ? kStart : half + below(std::max<std::size_t>(code.size() - half, 1), random);
  changeBytes(code, kept, random);
}

/// The code stream in boxes, cut at up to three places.
void appendJxlCode(std::vector<FileBox>& boxes, const Bytes& code, std::mt19937& random) {
  if (onceIn(2, random)) {
    boxes.push_back({"jxlc", code});
    return;
  }
  std::size_t at = 0;
  for (std::uint32_t left = static_cast<std::uint32_t>(below(4, random)), part = 0;; --left, ++part) {
    constexpr std::uint32_t kLast = 1u << 31;
    const std::size_t end = left == 0 ? code.size() : at + below(code.size() - at + 1, random);
    FileBox box{"jxlp"};
    appendBig(box.content, left == 0 ? part | kLast : part, kJxlPlace);
    box.content.insert(box.content.end(), code.begin() + static_cast<std::ptrdiff_t>(at),
                       code.begin() + static_cast<std::ptrdiff_t>(end));
    boxes.push_back(std::move(box));
    at = end;
    if (left == 0) return;
  }
}

}  // namespace

std::optional<JxlParts> jxlPartsIn(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > 2 && bytes[0] == 0xff && bytes[1] == 0x0a) return JxlParts{Bytes(bytes.begin(), bytes.end())};
  if (bytes.size() < std::size(kJxlSignature) ||
      !std::ranges::equal(bytes.first(std::size(kJxlSignature)), kJxlSignature))
    return std::nullopt;
  auto boxes = boxesIn(bytes);
  if (!boxes) return std::nullopt;
  JxlParts parts;
  for (FileBox& box : *boxes) {
    if (box.type == "jxlc" || (box.type == "jxlp" && box.content.size() >= kJxlPlace)) {
      const auto start = box.content.begin() + (box.type == "jxlp" ? kJxlPlace : 0);
      parts.code.insert(parts.code.end(), start, box.content.end());
    } else if (box.type != "JXL " && box.type != "ftyp") {
      parts.boxes.push_back(std::move(box));
    }
  }
  if (parts.code.size() <= 2) return std::nullopt;
  return parts;
}

Bytes jxlOfParts(const JxlParts& parts, std::mt19937& random) {
  if (parts.boxes.empty() && !onceIn(8, random)) return parts.code;
  std::vector<FileBox> boxes;
  boxes.push_back({"ftyp", {'j', 'x', 'l', ' ', 0, 0, 0, 0, 'j', 'x', 'l', ' '}});
  // A level stands before the code, and others on either side of it.
  const bool are_behind = onceIn(2, random);
  for (const FileBox& box : parts.boxes)
    if (!are_behind || box.type == "jxll") boxes.push_back(box);
  appendJxlCode(boxes, parts.code, random);
  for (const FileBox& box : parts.boxes)
    if (are_behind && box.type != "jxll") boxes.push_back(box);
  Bytes bytes(std::begin(kJxlSignature), std::end(kJxlSignature));
  const Bytes others = bytesOfBoxes(boxes);
  bytes.insert(bytes.end(), others.begin(), others.end());
  return bytes;
}

Bytes changedJxl(const Bytes& file, std::mt19937& random) {
  auto parts = jxlPartsIn(file);
  if (!parts) {
    Bytes bytes = file;
    changeBytes(bytes, 0, random);
    return bytes;
  }
  if (!parts->boxes.empty() && onceIn(4, random))
    changeBytes(oneIn(parts->boxes, random).content, 0, random);
  else
    changeJxlCode(parts->code, random);
  return jxlOfParts(*parts, random);
}

}  // namespace mirrorball::fuzz
