#include "mirrorball/scene/gltf/gltf_meshopt.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <meshoptimizer.h>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"

// EXT_meshopt_compression: a buffer view's bytes in one of three codings, and for vertices a filter after it. The
// library checks that a stream does not end early; that the sizes fit, which it takes for granted, is checked here.

namespace mirrorball::gltf {
namespace {

/// No coding makes more of a byte: of 16 bytes of vertices that are all alike, 2 bits are left.
constexpr std::size_t kMostOfAByte = 64;

constexpr auto kModes = std::to_array<std::string_view>({"ATTRIBUTES", "TRIANGLES", "INDICES"});
constexpr auto kFilters = std::to_array<std::string_view>({"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"});

/// What is wrong with the numbers of a compressed view; empty: nothing.
std::string problemOf(const BufferView& view) {
  const Compression& how = *view.compression;
  const auto isAny = [](const auto& names, std::string_view name) { return contains(names, name); };
  if (!isAny(kModes, how.mode)) return "mode is '" + excerpt(how.mode, 20) + "', none of " + join(kModes);
  if (!isAny(kFilters, how.filter)) return "filter is '" + excerpt(how.filter, 20) + "', none of " + join(kFilters);
  const std::size_t stride = how.byte_stride;
  const std::string written = "byteStride is " + std::to_string(stride);
  const bool is_vertices = how.mode == "ATTRIBUTES";
  if (is_vertices && (stride == 0 || stride % 4 != 0 || stride > 256)) return written + ", no multiple of 4 up to 256";
  if (!is_vertices && stride != 2 && stride != 4) return written + ", and indices have 2 or 4 bytes";
  if (!is_vertices && how.filter != "NONE") return "filter is " + how.filter + ", which is for vertices alone";
  if (how.filter == "OCTAHEDRAL" && stride != 4 && stride != 8) return written + ", and its filter takes 4 or 8";
  if (how.filter == "QUATERNION" && stride != 8) return written + ", and its filter takes 8";
  if (view.byte_stride != 0 && view.byte_stride != stride) return written + ", and its bufferView says otherwise";
  if (how.mode == "TRIANGLES" && how.count % 3 != 0) return "count is " + std::to_string(how.count) + ", no triangles";
  // The product does not overflow if it is the length.
  if (view.byte_length / stride != how.count || view.byte_length % stride != 0)
    return "count is " + std::to_string(how.count) + ", not the bufferView's byteLength over byteStride";
  return "";
}

/// Fills `to`, whose size is the view's; false if the bytes are damaged.
bool decode(const Compression& how, std::span<const std::uint8_t> from, Bytes& to) {
  std::uint8_t* const begin = to.data();
  const std::size_t count = how.count, stride = how.byte_stride;
  if (how.mode == "TRIANGLES") return meshopt_decodeIndexBuffer(begin, count, stride, from.data(), from.size()) == 0;
  if (how.mode == "INDICES") return meshopt_decodeIndexSequence(begin, count, stride, from.data(), from.size()) == 0;
  if (meshopt_decodeVertexBuffer(begin, count, stride, from.data(), from.size()) != 0) return false;
  if (how.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(begin, count, stride);
  if (how.filter == "QUATERNION") meshopt_decodeFilterQuat(begin, count, stride);
  if (how.filter == "EXPONENTIAL") meshopt_decodeFilterExp(begin, count, stride);
  return true;
}

Result<Bytes> decoded(const File& file, const BufferView& view, const std::string& key) {
  const Compression& how = *view.compression;
  MIRRORBALL_TRY(compressed, bufferBytes(file, how.buffer, how.byte_offset, how.byte_length, key));
  if (const std::string problem = problemOf(view); !problem.empty())
    return fail(ErrorCode::bad_file, key + "." + problem);
  if (view.byte_length / kMostOfAByte > how.byte_length)
    return fail(ErrorCode::bad_file,
                key + ": " + counted(how.byte_length, "byte") + " cannot hold " + std::to_string(view.byte_length));
  Bytes bytes(view.byte_length);
  if (!decode(how, compressed, bytes)) return fail(ErrorCode::bad_file, key + ": the compressed bytes are damaged");
  return bytes;
}

}  // namespace

Result<void> decodeMeshopt(File& file) {
  for (std::size_t i = 0; i < file.document.buffer_views.size(); ++i) {
    BufferView& view = file.document.buffer_views[i];
    if (!view.compression) continue;
    MIRRORBALL_TRY_VOID(file.files.budget().take(view.byte_length));
    Result<Bytes> bytes = decoded(file, view, quoted("bufferViews", i) + ".extensions.EXT_meshopt_compression");
    if (!bytes) {
      loseView(file, view, std::move(bytes).error());
      continue;
    }
    view = {
        .buffer = static_cast<int>(file.buffers.size()), .byte_length = bytes->size(), .byte_stride = view.byte_stride};
    file.buffers.push_back(file.storage.emplace_back(std::move(*bytes)));
  }
  return {};
}

}  // namespace mirrorball::gltf
