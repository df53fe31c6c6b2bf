#include "mirrorball/scene/gltf/gltf_container.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

#include "mirrorball/base/text.h"

// glTF 2.0, section 4.4: a header, then chunks of a length, a type, and the bytes.

namespace mirrorball::gltf {
namespace {

using Span = std::span<const std::uint8_t>;

constexpr std::size_t kGlbHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;
constexpr std::size_t kJsonAt = kGlbHeaderSize + kChunkHeaderSize;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN"

bool isGlb(Span bytes) { return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0; }

std::uint32_t wordAt(Span bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16 |
         std::uint32_t{bytes[at + 3]} << 24;
}

std::string reaches(const char* what, std::uint64_t end, std::size_t size) {
  return std::string(what) + " reaches byte " + std::to_string(end) + ", but the file has " + std::to_string(size);
}

/// JSON as parsers take it: programs of Windows put a byte-order mark before it, and some pad it with zeros where the
/// format wants blanks.
std::string_view plainJson(std::string_view json) {
  json = withoutByteOrderMark(json);
  return json.substr(0, json.find_last_not_of('\0') + 1);
}

/// Where the second chunk begins: behind the first, or at the multiple of 4 to which some programs pad the first
/// without counting that in its length.
std::size_t secondChunkAt(Span bytes, std::size_t end_of_first) {
  const std::size_t padded = (end_of_first + 3) / 4 * 4;
  const auto isBinary = [&](std::size_t at) {
    return bytes.size() >= at + kChunkHeaderSize && wordAt(bytes, at + 4) == kBinaryChunk;
  };
  return !isBinary(end_of_first) && isBinary(padded) ? padded : end_of_first;
}

/// The binary chunk, as far as the file has it: chunks say their own lengths, so that the one of the whole file, which
/// some programs write wrongly, is not needed.
Span binaryChunk(Span bytes, std::size_t end_of_first, Remarks& remarks) {
  const std::size_t at = secondChunkAt(bytes, end_of_first);
  if (bytes.size() < at + kChunkHeaderSize || wordAt(bytes, at + 4) != kBinaryChunk) return {};
  const Span rest = bytes.subspan(at + kChunkHeaderSize);
  const std::size_t size = wordAt(bytes, at);
  if (size > rest.size()) {
    const std::string cut = reaches("its second chunk", at + kChunkHeaderSize + std::uint64_t{size}, bytes.size());
    remarks.suspect({ErrorCode::bad_file, cut + "; it is truncated"});
    // What pads a chunk is of no use to anybody.
    if (size - rest.size() > 3) remarks.tell(cut + "; it is truncated, and what it lacks is left out");
  }
  return rest.first(std::min(size, rest.size()));
}

Result<Container> takeGlbApart(Span bytes, Remarks& remarks) {
  const auto truncated = [&](const char* what, std::uint64_t end) {
    return fail(ErrorCode::bad_file, reaches(what, end, bytes.size()) + "; it is truncated");
  };
  if (bytes.size() < kJsonAt) return truncated("its header", kJsonAt);
  if (const std::uint32_t version = wordAt(bytes, 4); version != 2)
    return fail(ErrorCode::unsupported, "is of glTF version " + std::to_string(version) +
                                            "; only version 2 is read, which gltf-pipeline makes of version 1");
  if (wordAt(bytes, kGlbHeaderSize + 4) != kJsonChunk) return fail(ErrorCode::bad_file, "its first chunk is not JSON");
  const std::size_t json_size = wordAt(bytes, kGlbHeaderSize);
  if (json_size > bytes.size() - kJsonAt) return truncated("its JSON chunk", std::uint64_t{kJsonAt} + json_size);
  if (const std::uint32_t length = wordAt(bytes, 8); length > bytes.size())
    remarks.suspect({ErrorCode::bad_file, reaches("its length", length, bytes.size()) + "; it is truncated"});
  return Container{.json = plainJson({reinterpret_cast<const char*>(bytes.data()) + kJsonAt, json_size}),
                   .binary = binaryChunk(bytes, kJsonAt + json_size, remarks)};
}

}  // namespace

Result<Container> takeApart(Span bytes, Remarks& remarks) {
  if (isGlb(bytes)) return takeGlbApart(bytes, remarks);
  return Container{.json = plainJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()})};
}

}  // namespace mirrorball::gltf
