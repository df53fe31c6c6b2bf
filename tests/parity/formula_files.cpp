#include "parity/formula_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include "shaders/embedded_text.h"

namespace mirrorball::parity {
namespace {

namespace fs = std::filesystem;

fs::path sourceFolder() { return MIRRORBALL_SOURCE_DIR; }

std::string readText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

FormulaFile parse(const fs::path& path) {
  static const std::regex kNeeds(R"(Needs: ([a-z_, ]+)\.)");
  static const std::regex kWord(R"([a-z_]+)");
  static const std::regex kFunction(R"((?:^|\n)FN\s+\w+\s+(\w+)\s*\()");
  FormulaFile file{path.filename().string(), {}, {}};
  const std::string text = readText(path);
  if (std::smatch needs; std::regex_search(text, needs, kNeeds)) {
    const std::string words = needs[1];
    for (std::sregex_iterator word(words.begin(), words.end(), kWord), end; word != end; ++word) {
      file.needs.push_back(word->str() + ".glsl");
    }
  }
  for (std::sregex_iterator found(text.begin(), text.end(), kFunction), end; found != end; ++found) {
    file.functions.push_back((*found)[1]);
  }
  return file;
}

void collect(const std::vector<FormulaFile>& files, std::string_view name, std::vector<std::string_view>& ordered) {
  if (std::ranges::find(ordered, name) != ordered.end()) return;
  const auto file = std::ranges::find(files, name, &FormulaFile::name);
  if (file != files.end()) {
    for (const std::string& needed : file->needs) collect(files, needed, ordered);
  }
  ordered.push_back(name);
}

}  // namespace

std::vector<FormulaFile> allFormulaFiles() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(sourceFolder() / "formula")) {
    if (entry.path().extension() == ".glsl") paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  std::vector<FormulaFile> files;
  std::ranges::transform(paths, std::back_inserter(files), parse);
  return files;
}

std::string includesOf(const std::vector<FormulaFile>& files, std::string_view name) {
  std::vector<std::string_view> ordered;
  collect(files, name, ordered);
  std::string lines;
  for (std::string_view file : ordered) lines += "#include \"" + std::string(file) + "\"\n";
  return lines;
}

std::optional<std::string_view> findParityText(std::string_view name) {
  if (const auto embedded = embeddedText(name)) return embedded;
  static std::map<std::string, std::string, std::less<>> texts;
  if (const auto known = texts.find(name); known != texts.end()) return known->second;
  const fs::path path = sourceFolder() / "tests/parity" / name;
  if (fs::exists(path)) return texts.emplace(name, readText(path)).first->second;
  return std::nullopt;
}

}  // namespace mirrorball::parity
