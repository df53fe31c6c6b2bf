#include "mirrorball/output/lamps/lamp_files.h"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/output/lamps/lamp_gltf.h"
#include "mirrorball/output/lamps/lamp_json.h"
#include "mirrorball/output/lamps/lamp_snippet.h"

namespace mirrorball {
namespace {

constexpr std::string_view kGlb = ".glb";
constexpr std::string_view kJson = ".json";

std::vector<std::string_view> endings() {
  std::vector<std::string_view> all{kGlb, kJson};
  for (const LampSnippet& snippet : lampSnippets()) all.push_back(snippet.ending);
  return all;
}

bool endsWith(std::string name, std::string_view ending) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return name.ends_with(ending);
}

Result<void> writeText(const std::string& path, const std::string& text) {
  return writeFile(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace

std::string lampFileEndings(const std::string& before_last) { return join(endings(), ", ", before_last); }

Result<void> checkLampFile(const std::string& path) {
  for (const std::string_view ending : endings())
    if (endsWith(path, ending)) return {};
  return fail(ErrorCode::usage, path + ": lamps are written to files that end in " + lampFileEndings());
}

Result<void> writeLamps(const std::string& path, std::span<const MapLamp> lamps) {
  MIRRORBALL_TRY_VOID(checkLampFile(path));
  if (endsWith(path, kGlb)) {
    MIRRORBALL_TRY(file, lampGlb(lamps));
    return writeFile(path, file);
  }
  if (endsWith(path, kJson)) return writeText(path, lampJson(lamps).dump(2) + "\n");
  for (const LampSnippet& snippet : lampSnippets())
    if (endsWith(path, snippet.ending)) return writeText(path, snippet.write(lamps));
  return {};
}

std::vector<std::string> lampFilesFor(const std::string& stem, const std::string& program) {
  std::vector<std::string> files{stem + std::string(kGlb), stem + std::string(kJson)};
  if (const LampSnippet* snippet = lampSnippetFor(program)) files.push_back(stem + std::string(snippet->ending));
  return files;
}

}  // namespace mirrorball
