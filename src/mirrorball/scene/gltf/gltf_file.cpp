#include "mirrorball/scene/gltf/gltf_file.h"

#include <array>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_meshopt.h"

namespace mirrorball::gltf {
namespace {

constexpr std::size_t kGlbHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN"

struct Container {
  std::string_view json;
  std::span<const std::uint8_t> binary;  // of a .glb with a second chunk
};

bool isGlb(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
}

std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16 |
         std::uint32_t{bytes[at + 3]} << 24;
}

/// Takes a .glb apart (section 4.4): its header, then chunks of a length, a type, and the bytes.
Result<Container> readGlb(std::span<const std::uint8_t> bytes) {
  const auto truncated = [&](const char* what, std::uint64_t end) {
    return fail(ErrorCode::bad_file, std::string(what) + " reaches byte " + std::to_string(end) +
                                         ", but the file has " + std::to_string(bytes.size()) + "; it is truncated");
  };
  constexpr std::size_t kJsonAt = kGlbHeaderSize + kChunkHeaderSize;
  if (bytes.size() < kJsonAt) return truncated("its header", kJsonAt);
  if (const std::uint32_t version = wordAt(bytes, 4); version != 2)
    return fail(ErrorCode::unsupported, "is of glTF version " + std::to_string(version) + "; only version 2 is read");
  if (const std::uint32_t length = wordAt(bytes, 8); length > bytes.size())
    return truncated("its length", length);
  else
    bytes = bytes.first(std::max<std::size_t>(length, kJsonAt));

  if (wordAt(bytes, kGlbHeaderSize + 4) != kJsonChunk) return fail(ErrorCode::bad_file, "its first chunk is not JSON");
  const std::size_t json_size = wordAt(bytes, kGlbHeaderSize);
  if (json_size > bytes.size() - kJsonAt) return truncated("its JSON chunk", std::uint64_t{kJsonAt} + json_size);
  Container container;
  container.json = {reinterpret_cast<const char*>(bytes.data()) + kJsonAt, json_size};

  std::span<const std::uint8_t> rest = bytes.subspan(kJsonAt + json_size);
  if (rest.size() < kChunkHeaderSize) return container;
  const std::size_t size = wordAt(rest, 0);
  if (size > rest.size() - kChunkHeaderSize)
    return truncated("its second chunk", bytes.size() - rest.size() + kChunkHeaderSize + std::uint64_t{size});
  if (wordAt(rest, 4) == kBinaryChunk) container.binary = rest.subspan(kChunkHeaderSize, size);
  return container;
}

/// RFC 4648, with or without padding.
std::optional<Bytes> decodeBase64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  if (text.size() % 4 == 1) return {};
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    std::uint32_t digit = 0;
    if (letter >= 'A' && letter <= 'Z')
      digit = static_cast<std::uint32_t>(letter - 'A');
    else if (letter >= 'a' && letter <= 'z')
      digit = static_cast<std::uint32_t>(letter - 'a' + 26);
    else if (letter >= '0' && letter <= '9')
      digit = static_cast<std::uint32_t>(letter - '0' + 52);
    else if (letter == '+')
      digit = 62;
    else if (letter == '/')
      digit = 63;
    else
      return {};
    bits = (bits << 6 | digit) & 0xFFFFFF;
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> count));
    }
  }
  return bytes;
}

/// Turns "%20" into a space (RFC 3986, section 2.1).
std::string percentDecoded(std::string_view text) {
  const auto digit = [](char letter) {
    if (letter >= '0' && letter <= '9') return letter - '0';
    if (letter >= 'a' && letter <= 'f') return letter - 'a' + 10;
    if (letter >= 'A' && letter <= 'F') return letter - 'A' + 10;
    return -1;
  };
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0) {
      decoded += static_cast<char>(digit(text[i + 1]) * 16 + digit(text[i + 2]));
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

/// What a buffer's uri names.
Result<std::span<const std::uint8_t>> readBuffer(File& file, const std::string& uri, const std::string& key) {
  if (!isData(uri)) {
    MIRRORBALL_TRY(path, findFile(file, uri, key));
    return file.named.read(path);
  }
  MIRRORBALL_TRY_VOID(withName(key, file.named.budget().take(uri.size() / 4 * 3)));
  MIRRORBALL_TRY(bytes, decodeData(uri, key));
  return std::span<const std::uint8_t>(file.storage.emplace_back(std::move(bytes)));
}

Result<void> readBuffers(File& file, std::span<const std::uint8_t> binary) {
  for (std::size_t i = 0; i < file.document.buffers.size(); ++i) {
    const Buffer& buffer = file.document.buffers[i];
    const std::string key = quoted("buffers", i);
    if (buffer.is_fallback) {
      file.buffers.emplace_back();
      continue;
    }
    std::span<const std::uint8_t> bytes = binary;
    if (buffer.uri) {
      MIRRORBALL_TRY(read, readBuffer(file, *buffer.uri, key + ".uri"));
      bytes = read;
    } else if (i > 0 || binary.empty()) {
      // Only the first may be the binary chunk; another has its content in an extension that is not read.
      bytes = {};
    }
    if (bytes.size() < buffer.byte_length)
      return fail(ErrorCode::bad_file, key + ".byteLength is " + std::to_string(buffer.byte_length) + ", but " +
                                           (buffer.uri ? "'" + excerpt(*buffer.uri) + "'" : "the binary chunk") +
                                           " has " + counted(bytes.size(), "byte"));
    file.buffers.push_back(bytes.first(buffer.byte_length));
  }
  return {};
}

}  // namespace

std::string quoted(const char* array, std::size_t index) {
  return std::string(array) + "[" + std::to_string(index) + "]";
}

Result<void> checkIndex(int index, std::size_t count, const std::string& key, const char* thing) {
  if (index >= 0 && std::size_t(index) < count) return {};
  return fail(ErrorCode::bad_file, key + " is " + std::to_string(index) + ", but " + thereAre(count, thing));
}

bool isData(std::string_view uri) { return uri.starts_with("data:"); }

Result<Bytes> decodeData(const std::string& uri, const std::string& key) {
  constexpr std::string_view kMark = ";base64,";
  const std::size_t mark = uri.find(kMark);
  std::optional<Bytes> bytes;
  if (mark != std::string::npos) bytes = decodeBase64(std::string_view(uri).substr(mark + kMark.size()));
  if (!bytes) return fail(ErrorCode::bad_file, key + " is no base64 data: '" + excerpt(uri) + "'");
  return std::move(*bytes);
}

Result<std::filesystem::path> findFile(const File& file, const std::string& uri, const std::string& key) {
  auto path = file.named.find(percentDecoded(uri));
  if (!path) path.error().message.insert(0, key + " '" + excerpt(uri) + "' ");
  return path;
}

Result<File> openFile(std::span<const std::uint8_t> bytes, const std::filesystem::path& path, ModelFiles& named) {
  File file{.name = path.string(), .named = named, .document = {}, .buffers = {}, .storage = {}};
  Container container;
  if (isGlb(bytes)) {
    MIRRORBALL_TRY(glb, readGlb(bytes));
    container = glb;
  } else {
    container.json = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  MIRRORBALL_TRY(document, parseDocument(container.json, named.budget()));
  file.document = std::move(document);
  file.storage.reserve(file.document.buffers.size());
  MIRRORBALL_TRY_VOID(readBuffers(file, container.binary));
  MIRRORBALL_TRY_VOID(decodeMeshopt(file));
  return file;
}

}  // namespace mirrorball::gltf
