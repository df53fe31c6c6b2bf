#include "mirrorball/codec/glb_container.h"

#include <cstddef>
#include <limits>

#include "mirrorball/codec/little_endian_writer.h"

namespace mirrorball {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;     // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBufferChunk = 0x004E4942;  // "BIN"
constexpr std::size_t kFileHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

constexpr std::size_t alignedToFour(std::size_t size) { return (size + 3) / 4 * 4; }

}  // namespace

Result<Bytes> glbFile(std::string json, std::span<const std::uint8_t> buffer) {
  json.resize(alignedToFour(json.size()), ' ');
  const std::size_t buffer_size = alignedToFour(buffer.size());
  const std::size_t size =
      kFileHeaderSize + kChunkHeaderSize + json.size() + (buffer.empty() ? 0 : kChunkHeaderSize + buffer_size);
  if (size > std::numeric_limits<std::uint32_t>::max())
    return fail(ErrorCode::too_large, "a .glb file ends at 4 GiB, and this one would have " + std::to_string(size) +
                                          " bytes; put less or smaller things into it");
  LittleEndianWriter file;
  file.u32(kGlbMagic);
  file.u32(2);
  file.u32(static_cast<std::uint32_t>(size));
  file.u32(static_cast<std::uint32_t>(json.size()));
  file.u32(kJsonChunk);
  file.append({reinterpret_cast<const std::uint8_t*>(json.data()), json.size()});
  if (buffer.empty()) return file.takeBytes();
  file.u32(static_cast<std::uint32_t>(buffer_size));
  file.u32(kBufferChunk);
  file.append(buffer);
  file.zeros(buffer_size - buffer.size());
  return file.takeBytes();
}

}  // namespace mirrorball
