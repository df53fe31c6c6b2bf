#include "mirrorball/scene/gltf/gltf_file.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_container.h"
#include "mirrorball/scene/gltf/gltf_meshopt.h"
#include "mirrorball/scene/gltf/gltf_uri.h"

namespace mirrorball::gltf {
namespace {

/// What a buffer's uri names.
Result<std::span<const std::uint8_t>> readBuffer(File& file, const std::string& uri, const std::string& key,
                                                 std::size_t size) {
  if (!isData(uri)) return readNamedFile(file, uri, key, size);
  MIRRORBALL_TRY_VOID(withName(key, file.files.budget().take(uri.size() / 4 * 3)));
  MIRRORBALL_TRY(bytes, decodeData(uri, key));
  return std::span<const std::uint8_t>(file.storage.emplace_back(std::move(bytes)));
}

/// The bytes of a buffer: of its uri, or the binary chunk, which only the first may be. Another without a uri has its
/// content in an extension that is not read.
///
/// size   how long it is to be [bytes]
Result<std::span<const std::uint8_t>> readSource(File& file, std::size_t index, std::span<const std::uint8_t> binary,
                                                 std::size_t size) {
  const Buffer& buffer = file.document.buffers[index];
  if (buffer.uri) return readBuffer(file, *buffer.uri, quoted("buffers", index) + ".uri", size);
  return index > 0 ? std::span<const std::uint8_t>() : binary;
}

/// Up to which byte the views of each buffer reach.
std::vector<std::size_t> endsOfViews(const Document& document) {
  std::vector<std::size_t> ends(document.buffers.size(), 0);
  const auto include = [&](int buffer, std::size_t offset, std::size_t length) {
    if (buffer < 0 || std::size_t(buffer) >= ends.size()) return;
    const bool fits = length <= std::numeric_limits<std::size_t>::max() - offset;
    ends[std::size_t(buffer)] = std::max(ends[std::size_t(buffer)], fits ? offset + length : offset);
  };
  for (const BufferView& view : document.buffer_views) {
    include(view.buffer, view.byte_offset, view.byte_length);
    if (view.compression)
      include(view.compression->buffer, view.compression->byte_offset, view.compression->byte_length);
  }
  return ends;
}

/// Reads the buffers as far as they are there: what lies beyond is missed by whoever asks for it.
Result<void> readBuffers(File& file, std::span<const std::uint8_t> binary) {
  const std::vector<std::size_t> ends = endsOfViews(file.document);
  for (std::size_t i = 0; i < file.document.buffers.size(); ++i) {
    const Buffer& buffer = file.document.buffers[i];
    file.buffers.emplace_back();
    if (buffer.is_fallback) continue;
    const std::size_t size = std::max(buffer.byte_length, ends[i]);
    Result<std::span<const std::uint8_t>> bytes = readSource(file, i, binary, size);
    if (!bytes) {
      if (!isDamage(bytes.error())) return fail(std::move(bytes));
      file.remarks.suspect(bytes.error());
      file.lost_buffers.emplace(static_cast<int>(i), std::move(bytes).error());
      continue;
    }
    if (bytes->size() < buffer.byte_length)
      file.remarks.suspect(
          {ErrorCode::bad_file, quoted("buffers", i) + ".byteLength is " + std::to_string(buffer.byte_length) +
                                    ", but " + (buffer.uri ? "'" + excerpt(*buffer.uri) + "'" : "the binary chunk") +
                                    " has " + counted(bytes->size(), "byte")});
    const bool says_too_few = ends[i] > buffer.byte_length && bytes->size() > buffer.byte_length;
    if (says_too_few)
      file.remarks.tellOnce(quoted("buffers", i), "has more bytes than its byteLength, and they are used");
    file.buffers.back() = bytes->first(std::min(bytes->size(), size));
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

bool isDamage(const Error& error) {
  return error.code == ErrorCode::bad_file || error.code == ErrorCode::unsupported || error.code == ErrorCode::io ||
         error.code == ErrorCode::not_found;
}

Result<void> notedIn(std::vector<Damage>& damage, const char* what, Result<void> result) {
  if (result || !isDamage(result.error())) return result;
  damage.push_back({std::move(result).error(), what});
  return {};
}

void loseView(File& file, BufferView& view, Error damage) {
  const int buffer = static_cast<int>(file.buffers.size());
  file.buffers.emplace_back();
  file.remarks.suspect(damage);
  file.lost_buffers.emplace(buffer, std::move(damage));
  view = {.buffer = buffer};
}

Result<std::span<const std::uint8_t>> readNamedFile(const File& file, const std::string& uri, const std::string& key,
                                                    std::optional<std::size_t> size) {
  const std::vector<std::string> readings{percentDecoded(uri), uri};
  auto found = file.named.read(readings, size);
  if (!found) return tl::unexpected<Error>({found.error().code, key + " " + found.error().message});
  return found->bytes;
}

Result<File> openFile(std::span<const std::uint8_t> bytes, const std::filesystem::path& path, NamedFiles& named,
                      Remarks& remarks) {
  ModelFiles& files = named.files();
  File file{.name = path.string(),
            .named = named,
            .files = files,
            .remarks = remarks,
            .document = {},
            .buffers = {},
            .lost_buffers = {},
            .storage = {}};
  MIRRORBALL_TRY(container, takeApart(bytes, remarks));
  MIRRORBALL_TRY(document, parseDocument(container.json, files.budget(), remarks));
  file.document = std::move(document);
  file.storage.reserve(file.document.buffers.size() + file.document.buffer_views.size());
  MIRRORBALL_TRY_VOID(readBuffers(file, container.binary));
  MIRRORBALL_TRY_VOID(decodeMeshopt(file));
  return file;
}

}  // namespace mirrorball::gltf
