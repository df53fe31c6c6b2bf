#include "mirrorball/codec/ldr/png_chunks.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <zlib.h>

#include "mirrorball/codec/byte_order.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

bool isOfType(Span chunk, std::string_view type) {
  return std::equal(type.begin(), type.end(), chunk.begin() + 4,
                    [](char letter, std::uint8_t byte) { return std::uint8_t(letter) == byte; });
}

void appendBigU32(Bytes& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

void appendChunk(Bytes& bytes, std::string_view type, Span data) {
  appendBigU32(bytes, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = bytes.size();
  bytes.insert(bytes.end(), type.begin(), type.end());
  bytes.insert(bytes.end(), data.begin(), data.end());
  appendBigU32(bytes,
               static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), bytes.data() + begin, bytes.size() - begin)));
}

}  // namespace

Result<std::optional<Bytes>> completedPng(Span bytes) {
  std::size_t at = kPngSignature;
  bool has_texels = false;
  std::optional<Span> cut;  // the data of a chunk of texels that are there in part
  while (bytes.size() - at >= kPngChunkHead) {
    const Span chunk = bytes.subspan(at);
    const std::size_t length = bigU32(chunk.data());
    const bool holds_texels = isOfType(chunk, "IDAT");
    has_texels = has_texels || holds_texels;
    if (chunk.size() < kPngChunkFrame || length > chunk.size() - kPngChunkFrame) {
      if (!has_texels)
        return fail(ErrorCode::bad_file, "the chunk at byte " + std::to_string(at) + " says it has " +
                                             std::to_string(length) +
                                             " bytes, more than the file; it is truncated or damaged");
      if (holds_texels) cut = chunk.subspan(kPngChunkHead, std::min(length, chunk.size() - kPngChunkHead));
      break;
    }
    if (isOfType(chunk, "IEND")) return std::optional<Bytes>();
    at += length + kPngChunkFrame;
  }
  if (!has_texels)
    return fail(ErrorCode::bad_file,
                "has no end chunk before its end at byte " + std::to_string(bytes.size()) + "; the file is truncated");
  Bytes completed(bytes.begin(), bytes.begin() + std::ptrdiff_t(at));
  if (cut) appendChunk(completed, "IDAT", *cut);
  appendChunk(completed, "IEND", {});
  return std::optional(std::move(completed));
}

}  // namespace mirrorball
