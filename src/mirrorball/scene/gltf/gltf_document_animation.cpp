#include "mirrorball/scene/gltf/gltf_document_animation.h"

#include <string>

#include "mirrorball/base/text.h"

// Khronos, "glTF 2.0 Specification" (ISO/IEC 12113:2022), section 3.11; KHR_animation_pointer.

namespace mirrorball::gltf {
namespace {

FileSampler parseKeys(const JsonReader& json) {
  return {.input = json["input"].required().index(),
          .output = json["output"].required().index(),
          .interpolation = json["interpolation"].text("LINEAR")};
}

FileChannel parseChannel(const JsonReader& json) {
  const JsonReader target = json["target"].required();
  FileChannel channel{.sampler = json["sampler"].required().index(), .pointer = {}, .key = target.key()};
  const std::string path = target["path"].required().text("");
  if (path == "pointer") {
    const JsonReader pointer = target["extensions"]["KHR_animation_pointer"]["pointer"].required();
    channel.pointer = pointer.text("");
    channel.key = pointer.key();
  } else if (const int node = target["node"].index(); node >= 0) {
    channel.pointer = "/nodes/" + std::to_string(node) + "/" + path;
    channel.key += ".node";
  }
  return channel;
}

}  // namespace

FileAnimation parseAnimation(const JsonReader& json) {
  FileAnimation animation{.name = printable(json["name"].text("")), .samplers = {}, .channels = {}};
  for (const JsonReader& sampler : json["samplers"].required().elements())
    animation.samplers.push_back(parseKeys(sampler));
  for (const JsonReader& channel : json["channels"].required().elements())
    animation.channels.push_back(parseChannel(channel));
  return animation;
}

}  // namespace mirrorball::gltf
