#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/output_json.h"

namespace mirrorball::gltf {

/// A .glb file as it grows: its JSON, and the bytes of its one buffer.
class GlbBuilder {
 public:
  OutputJson json;
  std::set<std::string> extensions;  ///< that it uses

  /// What an extension says at the root. It is then one that the file uses.
  OutputJson& extension(const char* name) {
    extensions.insert(name);
    return json["extensions"][name];
  }

  /// Appends an object to one of the arrays at the root.
  ///
  /// returns  its index
  std::size_t append(const char* array, OutputJson object) {
    OutputJson& list = json[array];
    list.push_back(std::move(object));
    return list.size() - 1;
  }

  /// Appends bytes to the buffer, from a multiple of 4 on, with a buffer view of them.
  ///
  /// target   what OpenGL would bind them to; 0: nothing, for pictures
  /// returns  the view's index
  std::size_t appendView(std::span<const std::uint8_t> bytes, int target = 0);

  /// The whole file.
  ///
  /// errors   too_large (a length is no 32-bit number)
  Result<Bytes> finish();

 private:
  Bytes buffer_;
};

}  // namespace mirrorball::gltf
