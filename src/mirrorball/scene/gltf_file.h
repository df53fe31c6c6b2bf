#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <tiny_gltf.h>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// A glTF file as tinygltf reads it: the keys, the buffers' bytes, and the pictures' bytes still encoded. No index or
/// range in it is checked yet.
struct GltfFile {
  std::string name;  ///< for messages
  tinygltf::Model model;
};

/// Reads the container (.glb or .gltf, told by its first bytes), the JSON, and the buffers and pictures beside it.
///
/// errors   bad_file; unsupported (the version, or a required extension that `known_extensions` lacks)
Result<GltfFile> readGltfFile(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                              std::span<const std::string_view> known_extensions);

/// An attribute's numbers: `components` to an element.
struct GltfNumbers {
  std::vector<float> values;
  std::size_t components = 0;
  std::size_t count() const { return components == 0 ? 0 : values.size() / components; }
};

/// Reads an accessor as floats: normalised integers become [0, 1] or [−1, 1], sparse values are put in.
///
/// key      what refers to the accessor, for messages
/// errors   bad_file (out of range; a value that is not finite); too_large
Result<GltfNumbers> readNumbers(const GltfFile& file, int accessor, const std::string& key);

/// Reads an accessor of unsigned integers, such as vertex indices.
Result<std::vector<std::uint32_t>> readIntegers(const GltfFile& file, int accessor, const std::string& key);

/// The bytes of a buffer view, such as those of an embedded picture.
Result<std::span<const std::uint8_t>> viewBytes(const GltfFile& file, int view, const std::string& key);

/// Refuses an index that is not that of one of `count` things.
Result<void> checkIndex(const GltfFile& file, int index, std::size_t count, const std::string& key,
                        const char* things);

}  // namespace mirrorball
