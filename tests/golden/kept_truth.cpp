#include "golden/kept_truth.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <span>
#include <sstream>
#include <utility>

#include "golden/made_picture.h"
#include "mirrorball/base/content_hash.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball::golden {
namespace {

namespace fs = std::filesystem;

fs::path sourcePath(std::string_view relative) { return fs::path(MIRRORBALL_SOURCE_DIR) / relative; }

fs::path hashesPath() { return sourcePath("tests/golden/truths/hashes.txt"); }

/// Readers of files are not among them: drawn and traced pictures are of what they read alike.
bool isSource(const fs::path& path) {
  const std::string folder = path.parent_path().filename(), name = path.filename();
  if (folder == "file" || folder == "mesh_file" || folder == "gltf") return false;
  if (name.ends_with("_test.cpp") || name.find("_testing.") != std::string::npos) return false;
  return name.ends_with(".cpp") || name.ends_with(".h") || name.ends_with(".inc") || name.ends_with(".exr") ||
         name.ends_with(".glsl");
}

/// In the order of their names, so that the hash is the same on every file system.
std::set<fs::path> filesBelow(const fs::path& folder) {
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.insert(entry.path());
  return files;
}

void addText(ContentHash& hash, std::string_view text) { hash.addAll(std::span(text.data(), text.size())); }

/// Without the lines that are comments, and without indentation.
void addSource(ContentHash& hash, const fs::path& path) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos || line.compare(begin, 2, "//") == 0) continue;
    addText(hash, std::string_view(line).substr(begin));
    addText(hash, "\n");
  }
}

std::string hashOfSources() {
  ContentHash hash;
  for (const std::string_view folder :
       {"formula", "src/mirrorball/bake", "src/mirrorball/codec/color", "src/mirrorball/environment",
        "src/mirrorball/height_field", "src/mirrorball/image", "src/mirrorball/rays", "src/mirrorball/scene",
        "src/mirrorball/study", "src/mirrorball/trace"})
    for (const fs::path& path : filesBelow(sourcePath(folder)))
      if (isSource(path)) addSource(hash, path);
  addSource(hash, sourcePath("apps/cli/render_reference.cpp"));
  return hash.digits();
}

void addFile(ContentHash& hash, const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  addText(hash, std::string(std::istreambuf_iterator<char>(file), {}));
}

/// The pictures and heights that a command names.
void addInputs(ContentHash& hash, const std::string& command) {
  for (const std::string& word : split(command, ' ')) {
    const std::string value = word.substr(word.find('=') + 1);
    if (value.starts_with("pictures/")) addFile(hash, sourcePath("tests/golden") / value);
    if (value.starts_with("heights/")) addFile(hash, sourcePath("docs") / value);
  }
}

std::map<std::string, std::string> readHashes() {
  std::map<std::string, std::string> hashes;
  std::ifstream file(hashesPath());
  for (std::string name, hash; file >> name >> hash;) hashes[name] = hash;
  return hashes;
}

}  // namespace

bool isUpdatingTruths() {
  const char* const value = std::getenv("MIRRORBALL_UPDATE_TRUTHS");
  return value != nullptr && std::string_view(value) == "1";
}

fs::path truthPath(const std::string& name) { return sourcePath("tests/golden/truths") / (name + ".png"); }

std::string truthHash(const Case& golden_case) {
  static const std::string of_sources = hashOfSources();
  const std::string command = tracedCommandOf(golden_case);
  ContentHash hash;
  addText(hash, of_sources);
  addText(hash, command);
  addInputs(hash, command);
  return hash.digits();
}

std::string keptHash(const std::string& name) { return readHashes()[name]; }

Result<void> keepTruth(const Case& golden_case) {
  MIRRORBALL_TRY(picture, pictureMadeBy(tracedCommandOf(golden_case)));
  MIRRORBALL_TRY_VOID(writeFile(truthPath(golden_case.name), picture));
  std::map<std::string, std::string> hashes = readHashes();
  std::erase_if(hashes, [](const auto& row) {
    return std::ranges::none_of(cases(), [&](const Case& known) { return known.name == row.first; });
  });
  hashes[golden_case.name] = truthHash(golden_case);
  std::ostringstream text;
  for (const auto& [name, hash] : hashes) text << name << ' ' << hash << '\n';
  const std::string rows = text.str();
  return writeFile(hashesPath(), bytesOf(std::span<const char>(rows)));
}

Result<Image> keptTruth(const std::string& name) {
  MIRRORBALL_TRY(file, readFile(truthPath(name)));
  MIRRORBALL_TRY(decoded, decodeImage(file));
  return std::move(decoded.image);
}

}  // namespace mirrorball::golden
