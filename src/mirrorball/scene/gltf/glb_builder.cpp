#include "mirrorball/scene/gltf/glb_builder.h"

#include <limits>
#include <utility>

#include "mirrorball/codec/little_endian_writer.h"

namespace mirrorball::gltf {
namespace {

constexpr std::size_t kWrittenHeaderSize = 12;
constexpr std::size_t kWrittenChunkHeaderSize = 8;

constexpr std::size_t alignedTo4(std::size_t size) { return (size + 3) / 4 * 4; }

}  // namespace

std::size_t GlbBuilder::appendView(std::span<const std::uint8_t> bytes, int target) {
  buffer_.resize(alignedTo4(buffer_.size()));
  OutputJson view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (target != 0) view["target"] = target;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  return append("bufferViews", std::move(view));
}

Result<Bytes> GlbBuilder::finish() {
  buffer_.resize(alignedTo4(buffer_.size()));
  if (!buffer_.empty()) append("buffers", {{"byteLength", buffer_.size()}});
  if (!extensions.empty()) json["extensionsUsed"] = extensions;
  std::string text = json.dump();
  text.resize(alignedTo4(text.size()), ' ');
  const std::size_t size =
      kWrittenHeaderSize + kWrittenChunkHeaderSize + text.size() + kWrittenChunkHeaderSize + buffer_.size();
  if (size > std::numeric_limits<std::uint32_t>::max())
    return fail(ErrorCode::too_large, "a .glb file ends at 4 GiB, and this one would have " + std::to_string(size) +
                                          " bytes; export fewer meshes or smaller textures");
  LittleEndianWriter file;
  file.append(std::span(reinterpret_cast<const std::uint8_t*>("glTF"), 4));
  file.u32(2);
  file.u32(static_cast<std::uint32_t>(size));
  file.u32(static_cast<std::uint32_t>(text.size()));
  file.append(std::span(reinterpret_cast<const std::uint8_t*>("JSON"), 4));
  file.append(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  file.u32(static_cast<std::uint32_t>(buffer_.size()));
  file.append(std::span(reinterpret_cast<const std::uint8_t*>("BIN\0"), 4));
  file.append(buffer_);
  return file.takeBytes();
}

}  // namespace mirrorball::gltf
