#include "mirrorball/scene/gltf_file.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "mirrorball/base/file.h"

namespace mirrorball {
namespace {

constexpr std::size_t kGlbHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
// tinygltf copies extras and extensions recursively: this much nesting is safe for the stack, and far more than files have.
constexpr int kDeepestNesting = 200;

bool isGlb(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
}

std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16 |
         std::uint32_t{bytes[at + 3]} << 24;
}

/// Checks the chunks' lengths (glTF 2.0, section 4.4) and returns the JSON. tinygltf 2.7 reads up to eight bytes past
/// the end of a second chunk that is too long, so it must not see one.
Result<std::string_view> glbJson(std::span<const std::uint8_t> bytes, const std::string& name) {
  const auto truncated = [&](const std::string& what, std::uint64_t needed) {
    return fail(ErrorCode::bad_file, name + ": " + what + " reaches byte " + std::to_string(needed) +
                                         ", but the file has " + std::to_string(bytes.size()) +
                                         "; it is truncated");
  };
  if (bytes.size() < kGlbHeaderSize + kChunkHeaderSize)
    return truncated("its header", kGlbHeaderSize + kChunkHeaderSize);
  if (const std::uint32_t version = wordAt(bytes, 4); version != 2)
    return fail(ErrorCode::unsupported,
                name + ": is of glTF version " + std::to_string(version) + "; only version 2 is read");
  const std::uint64_t length = wordAt(bytes, 8);
  if (length > bytes.size()) return truncated("its length", length);

  const std::uint64_t json_size = wordAt(bytes, kGlbHeaderSize);
  if (wordAt(bytes, kGlbHeaderSize + 4) != kJsonChunk)
    return fail(ErrorCode::bad_file, name + ": its first chunk is not JSON");
  const std::uint64_t json_at = kGlbHeaderSize + kChunkHeaderSize;
  if (json_at + json_size > length) return truncated("its JSON chunk", json_at + json_size);

  const std::uint64_t next = json_at + json_size;
  if (length - next >= kChunkHeaderSize) {
    const std::uint64_t end = next + kChunkHeaderSize + wordAt(bytes, static_cast<std::size_t>(next));
    if (end > length) return truncated("its second chunk", end);
  }
  return std::string_view(reinterpret_cast<const char*>(bytes.data()) + json_at, static_cast<std::size_t>(json_size));
}

/// Whether brackets nest deeper than the parser may follow.
bool nestsTooDeeply(std::string_view json) {
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char letter = json[i];
    if (in_text) {
      if (letter == '\\') ++i;
      else if (letter == '"') in_text = false;
    } else if (letter == '"') {
      in_text = true;
    } else if (letter == '{' || letter == '[') {
      if (++depth > kDeepestNesting) return true;
    } else if (letter == '}' || letter == ']') {
      --depth;
    }
  }
  return false;
}

/// What the callbacks share while tinygltf reads the files beside the model.
struct Neighbours {
  std::string folder;          // with its final slash
  std::string missing;         // the last file asked for that is not there
  std::string last_read;       // the last file read, and its size
  std::size_t last_size = 0;
};

/// Only ordinary files beside or below the model count: tinygltf would also try the working directory.
bool fileExists(const std::string& path, void* user_data) {
  auto& neighbours = *static_cast<Neighbours*>(user_data);
  if (!path.starts_with(neighbours.folder)) return false;
  std::error_code status;
  if (std::filesystem::is_regular_file(path, status)) return true;
  neighbours.missing = path.substr(neighbours.folder.size());
  return false;
}

std::string samePath(const std::string& path, void*) { return path; }

bool readWholeFile(std::vector<unsigned char>* out, std::string* problem, const std::string& path, void* user_data) {
  auto& neighbours = *static_cast<Neighbours*>(user_data);
  Result<Bytes> bytes = readFile(path);
  if (!bytes) {
    *problem = bytes.error().message;
    return false;
  }
  neighbours.last_read = path.substr(neighbours.folder.size());
  neighbours.last_size = bytes->size();
  *out = std::move(*bytes);
  return true;
}

/// Keeps a picture's bytes as they are; they are decoded later, in parallel, if a material uses them. The range of one
/// in a buffer view is not checked yet, so its bytes are not touched here.
bool keepEncoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                 int size, void*) {
  if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
  return true;
}

/// One line of printable letters from the parser's message.
std::string cleaned(std::string_view message) {
  constexpr std::size_t kLongest = 200;
  std::string line;
  for (const char letter : message.substr(0, std::min(message.find('\n'), kLongest)))
    line += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
  return line.empty() ? "it is not valid glTF" : line;
}

/// tinygltf stops at the first buffer that it cannot read, and has then kept those before it.
std::string bufferProblem(const tinygltf::Model& model, const Neighbours& neighbours, const std::string& message) {
  const std::string key = "buffers[" + std::to_string(model.buffers.size()) + "]";
  if (message.starts_with("Failed to decode 'uri'"))
    return key + ".uri is no base64 data of byteLength bytes";
  if (message.starts_with("File not found") && !neighbours.missing.empty())
    return key + ".uri: '" + cleaned(neighbours.missing) + "' is missing; put it beside the model";
  if (message.starts_with("File size mismatch"))
    return key + ".byteLength is not the size of '" + cleaned(neighbours.last_read) + "', which has " +
           std::to_string(neighbours.last_size) + " bytes";
  return cleaned(message);
}

Result<void> checkSupported(const tinygltf::Model& model, const std::string& name,
                            std::span<const std::string_view> known_extensions) {
  if (!model.asset.version.starts_with("2.") || model.asset.minVersion > "2.0")
    return fail(ErrorCode::unsupported, name + ": asset.version is '" + cleaned(model.asset.version) +
                                            "'; only glTF 2.0 is read");
  for (const std::string& extension : model.extensionsRequired)
    if (std::find(known_extensions.begin(), known_extensions.end(), extension) == known_extensions.end())
      return fail(ErrorCode::unsupported, name + ": extensionsRequired names " + cleaned(extension) +
                                              ", which this program cannot read; export the model without it");
  return {};
}

}  // namespace

Result<GltfFile> readGltfFile(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                              std::span<const std::string_view> known_extensions) {
  GltfFile file;
  file.name = path.string();
  if (bytes.size() > std::numeric_limits<std::int32_t>::max())
    return fail(ErrorCode::too_large, file.name + ": is larger than 2 GiB; keep its buffers in files of their own");
  std::string_view json(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (isGlb(bytes)) {
    MIRRORBALL_TRY(chunk, glbJson(bytes, file.name));
    json = chunk;
  }
  if (nestsTooDeeply(json)) return fail(ErrorCode::bad_file, file.name + ": its JSON nests too deeply");

  Neighbours neighbours;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  neighbours.folder = (folder / "").string();
  tinygltf::TinyGLTF parser;
  parser.SetFsCallbacks({fileExists, samePath, readWholeFile, nullptr, &neighbours});
  parser.SetImageLoader(keepEncoded, nullptr);
  std::string problem;
  std::string warning;
  bool read = false;
  try {
    const auto size = static_cast<unsigned int>(bytes.size());
    read = isGlb(bytes)
               ? parser.LoadBinaryFromMemory(&file.model, &problem, &warning, bytes.data(), size, neighbours.folder)
               : parser.LoadASCIIFromString(&file.model, &problem, &warning, json.data(), size, neighbours.folder);
  } catch (const std::exception& exception) {
    problem = exception.what();
  }
  // A file that needs an extension often cannot be read without it: the reason comes before its consequence.
  MIRRORBALL_TRY_VOID(checkSupported(file.model, file.name, known_extensions));
  if (!read) {
    const bool at_buffers = file.model.bufferViews.empty() && file.model.accessors.empty();
    return fail(ErrorCode::bad_file, file.name + ": " +
                                         (at_buffers ? bufferProblem(file.model, neighbours, problem) : cleaned(problem)));
  }
  return file;
}

}  // namespace mirrorball
