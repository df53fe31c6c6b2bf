#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/gltf_document.h"
#include "mirrorball/scene/model_files.h"

namespace mirrorball::gltf {

/// A glTF file: its JSON, and the bytes of its buffers. Everything that reads an accessor, a buffer view or a picture
/// checks its range here.
struct File {
  std::string name;   ///< for warnings
  ModelFiles& named;  ///< the files that it names
  Document document;
  std::vector<std::span<const std::uint8_t>> buffers;
  std::vector<Bytes> storage;  ///< of the buffers that lie in the JSON
};

/// Reads the container (.glb or .gltf, recognised by its first bytes), the JSON, and the buffers.
///
/// bytes    must live as long as the result, which points into them
/// named    so must this
/// errors   bad_file; unsupported; io; too_large
Result<File> openFile(std::span<const std::uint8_t> bytes, const std::filesystem::path& path, ModelFiles& named);

/// Whether a uri has the bytes itself.
bool isData(std::string_view uri);

/// The bytes of such a uri, in base64.
///
/// key      what holds the uri, for messages
/// errors   bad_file
Result<Bytes> decodeData(const std::string& uri, const std::string& key);

/// The file that another uri names.
///
/// key      what holds the uri, for messages
/// errors   as ModelFiles::find's
Result<std::filesystem::path> findFile(const File& file, const std::string& uri, const std::string& key);

/// An attribute's numbers: `components` to an element.
struct Numbers {
  std::vector<float> values;
  std::size_t components = 0;
  std::size_t count() const { return components == 0 ? 0 : values.size() / components; }
};

/// Reads an accessor as floats: normalised integers become [0, 1] or [−1, 1], sparse values are put in.
///
/// key      what refers to the accessor, for messages
/// errors   bad_file (out of range; a value that is not finite); too_large
Result<Numbers> readNumbers(const File& file, int accessor, const std::string& key);

/// Refuses numbers among which there is NaN or infinity.
Result<void> checkFinite(const Numbers& numbers, const std::string& key);

/// Reads an accessor of unsigned integers, such as vertex indices.
Result<std::vector<std::uint32_t>> readIntegers(const File& file, int accessor, const std::string& key);

/// A part of a buffer.
///
/// key      what asks for it, for messages
/// errors   bad_file (the buffer does not have it)
Result<std::span<const std::uint8_t>> bufferBytes(const File& file, int buffer, std::size_t offset, std::size_t length,
                                                  const std::string& key);

/// The bytes of a buffer view, such as those of an embedded picture.
Result<std::span<const std::uint8_t>> viewBytes(const File& file, int view, const std::string& key);

/// Decodes what a primitive keeps in KHR_draco_mesh_compression.
struct DracoMesh {
  std::map<std::string, Numbers> attributes;
  std::vector<std::uint32_t> corners;  ///< three a triangle, each the index of a vertex
};
Result<DracoMesh> decodeDraco(const File& file, const Primitive& primitive, const std::string& key);

/// Refuses an index that is not that of one of `count` things.
Result<void> checkIndex(int index, std::size_t count, const std::string& key, const char* thing);

/// "accessors[3]"
std::string quoted(const char* array, std::size_t index);

}  // namespace mirrorball::gltf
