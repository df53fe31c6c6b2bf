#include "mirrorball/scene/gltf/glb_builder.h"

#include <utility>

#include "mirrorball/codec/glb_container.h"

namespace mirrorball::gltf {
namespace {

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
  if (!buffer_.empty()) append("buffers", {{"byteLength", buffer_.size()}});
  if (!extensions.empty()) json["extensionsUsed"] = extensions;
  return glbFile(json.dump(), buffer_);
}

}  // namespace mirrorball::gltf
