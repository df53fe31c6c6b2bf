#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/gltf_document.h"
#include "mirrorball/scene/gltf/gltf_remarks.h"
#include "mirrorball/scene/mesh_file/named_file.h"
#include "mirrorball/scene/model_files.h"

namespace mirrorball::gltf {

/// A glTF file: its JSON, and the bytes of its buffers. Everything that reads an accessor, a buffer view or a picture
/// checks its range here.
struct File {
  std::string name;   ///< for warnings
  NamedFiles& named;  ///< the files that it names
  ModelFiles& files;  ///< their memory, and progress
  Remarks& remarks;   ///< what is odd about it; one thread at a time
  Document document;
  std::vector<std::span<const std::uint8_t>> buffers;  ///< as far as they are there
  std::map<int, Error> lost_buffers;                   ///< why those are empty that cannot be read
  std::vector<Bytes> storage;                          ///< of the buffers that lie in the JSON
};

/// Reads the container, the JSON, and the buffers. A buffer that cannot be read is an error of whoever asks for it.
///
/// bytes    must live as long as the result, which points into them
/// named    so must this
/// remarks  and this
/// errors   bad_file; unsupported; too_large
Result<File> openFile(std::span<const std::uint8_t> bytes, const std::filesystem::path& path, NamedFiles& named,
                      Remarks& remarks);

/// Whether an error is of a part of the file, without which the rest may be shown, and not of what the machine has or
/// the user wants.
bool isDamage(const Error& error);

/// What is left out of a part of the file, for a remark after work of several threads.
struct Damage {
  Error error;
  const char* what;  ///< Remarks::leaveOut
};

/// Notes damage, and lets other failures pass.
Result<void> notedIn(std::vector<Damage>& damage, const char* what, Result<void> result);

/// Has a buffer view lead to an error, which whoever asks for its bytes gets.
void loseView(File& file, BufferView& view, Error damage);

/// The bytes of the file that a uri names, unless it is data: percent-encoded, as it should be, or as it is written.
///
/// key      what holds the uri, for messages
/// size     as NamedFiles::read's
/// returns  the same place for names of one file
/// errors   as NamedFiles::read's
Result<std::span<const std::uint8_t>> readNamedFile(const File& file, const std::string& uri, const std::string& key,
                                                    std::optional<std::size_t> size = {});

/// An attribute's numbers: `components` to an element.
struct Numbers {
  std::vector<float> values;
  std::size_t components = 0;
  std::size_t count() const { return components == 0 ? 0 : values.size() / components; }
};

/// Reads an accessor as floats, NaN and infinity among them: normalised integers become [0, 1] or [−1, 1], sparse
/// values are put in.
///
/// key      what refers to the accessor, for messages
/// errors   bad_file (out of range); too_large
Result<Numbers> readNumbers(const File& file, int accessor, const std::string& key);

/// Reads an accessor as readNumbers does, for what is useless if one of its numbers is NaN.
///
/// errors   as well bad_file: a value that is not finite
Result<Numbers> readFiniteNumbers(const File& file, int accessor, const std::string& key);

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
