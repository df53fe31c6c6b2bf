#include "mirrorball/scene/mesh_file/named_file.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/foreign_file.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

std::string withSlashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

/// Of a path of any system.
std::string withoutFolders(const std::string& name) { return name.substr(name.find_last_of('/') + 1); }

/// What a folder holds, as far as anybody puts models there: the first of names that differ in capitals alone.
std::map<std::string, std::string> namesIn(const fs::path& folder) {
  constexpr std::size_t kMost = 100'000;
  std::map<std::string, std::string> names;
  std::error_code status;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, status), end;
       !status && entry != end && names.size() < kMost; entry.increment(status)) {
    const std::string name = entry->path().filename().string();
    std::string& kept = names[lowerCase(name)];
    if (kept.empty() || name < kept) kept = name;
  }
  return names;
}

/// Whether a file begins with letters alone, which numbers do not look like.
bool beginsWithLetters(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLetters = 8;
  return bytes.size() >= kLetters && std::all_of(bytes.begin(), bytes.begin() + kLetters, [](std::uint8_t byte) {
           return (byte >= 0x20 && byte < 0x7F) || byte == '\t' || byte == '\r' || byte == '\n';
         });
}

/// The error for what stands in a file's place, as NamedFiles::read's `size` says. A pointer of Git LFS may well be as
/// long as a small file; the first three numbers of a sound one may be those with which a compressed one begins.
std::optional<Error> errorOfStandIn(std::span<const std::uint8_t> bytes, std::optional<std::size_t> size) {
  constexpr std::size_t kFilled = 4;  // up to a multiple of which a file is filled, where it is
  const bool has_size = size && bytes.size() >= *size && bytes.size() - *size < kFilled;
  if (has_size && !beginsWithLetters(bytes)) return {};
  return foreignFileError(FileUse::any, bytes);
}

}  // namespace

std::string NamedFiles::spelledOnDisk(const std::string& name) {
  fs::path spelled;
  for (const fs::path& part : fs::path(name)) {
    // What leads out of the model's folder is not searched for.
    if (part == ".." || part.is_absolute()) return {};
    const fs::path folder = folder_ / spelled;
    const auto [listing, is_new] = listings_.try_emplace(folder);
    if (is_new) listing->second = namesIn(folder);
    const auto found = listing->second.find(lowerCase(part.string()));
    if (part != "." && found == listing->second.end()) return {};
    if (part != ".") spelled /= found->second;
  }
  return spelled.string();
}

Result<fs::path> NamedFiles::findReading(const std::string& name, std::string& path) {
  const std::string whole = withSlashes(name);
  auto first = files_.find(path = whole);
  if (first) return first;
  for (const std::string& other : {spelledOnDisk(whole), withoutFolders(whole), spelledOnDisk(withoutFolders(whole))})
    if (!other.empty() && other != whole)
      if (auto found = files_.find(path = other)) return found;
  return first;
}

Result<NamedFiles::Found> NamedFiles::read(std::span<const std::string> readings, std::optional<std::size_t> size) {
  Result<fs::path> first = fail(ErrorCode::bad_file, "names no file");
  for (std::size_t i = 0; i < readings.size(); ++i) {
    std::string path;
    auto found = findReading(readings[i], path);
    if (i == 0) first = found;
    if (!found) continue;
    if (path != withSlashes(readings[i]) && told_.insert(path).second)
      remarks_.push_back("'" + excerpt(readings[i]) + "' is read from '" + excerpt(path) + "' in the model's folder");
    MIRRORBALL_TRY(bytes, files_.read(*found));
    if (auto foreign = errorOfStandIn(bytes, size))
      return tl::unexpected<Error>({foreign->code, "'" + excerpt(readings[i]) + "' " + foreign->message});
    return Found{bytes, path};
  }
  first.error().message.insert(0, "'" + (readings.empty() ? std::string() : excerpt(readings[0])) + "' ");
  return tl::unexpected<Error>(first.error());
}

std::vector<std::string> readingsOfName(std::string_view line) {
  std::vector<std::string> readings;
  const auto add = [&](std::string_view name) {
    name = trimmed(name);
    if (name.size() > 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    if (!name.empty() && std::find(readings.begin(), readings.end(), name) == readings.end())
      readings.emplace_back(name);
  };
  add(line);
  add(line.substr(0, line.find(" #")));
  return readings;
}

}  // namespace mirrorball
