#include "mirrorball/gl/shader_source.h"

#include <algorithm>
#include <cstddef>
#include <regex>

#include "shaders/embedded_text.h"

namespace mirrorball::gl {
namespace {

constexpr std::string_view kDesktopVersion = "#version 430 core\n";
constexpr std::string_view kEmbeddedVersion =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n"
    "precision highp sampler2D;\n"
    "precision highp samplerCube;\n";

// The shader's half of the agreement that lets a formula file be GLSL and C++; the other half is
// formula/formula.h.
constexpr std::string_view kPrelude =
    "#define FN\n"
    "#define CUBE_SAMPLER samplerCube\n"
    "vec4 sampleLod(samplerCube map, vec3 direction, float lod) {\n"
    "  return textureLod(map, direction, lod);\n"
    "}\n";

/// The name in `#include "name"`, or nothing for any other line.
std::optional<std::string_view> includedName(std::string_view line) {
  const auto skipBlanks = [&] {
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
  };
  const auto skip = [&](std::string_view word) {
    skipBlanks();
    if (!line.starts_with(word)) return false;
    line.remove_prefix(word.size());
    return true;
  };
  if (!skip("#") || !skip("include") || !skip("\"")) return std::nullopt;
  const std::size_t end = line.find('"');
  if (end == std::string_view::npos) return std::nullopt;
  return line.substr(0, end);
}

/// Says that the next line is line `line` of file number `file`.
std::string lineDirective(int line, std::size_t file) {
  return "#line " + std::to_string(line) + ' ' + std::to_string(file) + '\n';
}

}  // namespace

Result<ShaderSource> shaderSource(Api api, std::string_view entry, std::span<const std::string_view> defines,
                                  const FindText& find) {
  const auto findText = [&](std::string_view name) { return find ? find(name) : embeddedText(name); };
  std::optional<std::string_view> rest = findText(entry);
  if (!rest) return fail(ErrorCode::not_found, std::string(entry) + ": no such shader");

  ShaderSource source;
  source.files = {std::string(entry)};
  source.text = api == Api::desktop43 ? kDesktopVersion : kEmbeddedVersion;
  source.text += kPrelude;
  for (std::string_view define : defines) {
    source.text += "#define " + std::string(define) + '\n';
  }
  source.text += lineDirective(1, 0);

  for (int line_number = 1; !rest->empty(); ++line_number) {
    const std::size_t end = std::min(rest->find('\n'), rest->size() - 1) + 1;
    const std::string_view line = rest->substr(0, end);
    rest->remove_prefix(end);
    const std::optional<std::string_view> included = includedName(line);
    if (!included) {
      source.text += line;
      continue;
    }
    if (std::ranges::find(source.files, *included) != source.files.end()) {
      source.text += '\n';
      continue;
    }
    const std::optional<std::string_view> text = findText(*included);
    if (!text) {
      return fail(ErrorCode::not_found, std::string(entry) + ", line " + std::to_string(line_number) +
                                            ": no shader text is named " + std::string(*included));
    }
    source.text += lineDirective(1, source.files.size());
    source.files.emplace_back(*included);
    source.text += *text;
    if (!text->ends_with('\n')) source.text += '\n';
    source.text += lineDirective(line_number + 1, 0);
  }
  return source;
}

std::string namedLog(std::string_view log, std::span<const std::string> files) {
  // "0:12(5): error" is Mesa's form, "0(12) : error" NVIDIA's, "ERROR: 0:12:" that of most others.
  static const std::regex kPlace(R"(^(ERROR: |WARNING: )?(\d{1,9})(?::(\d+)(?:\(\d+\))?|\((\d+)\) ?):)");
  std::string named;
  while (!log.empty()) {
    const std::size_t end = std::min(log.find('\n'), log.size());
    std::string line(log.substr(0, end));
    log.remove_prefix(std::min(end + 1, log.size()));
    std::smatch place;
    if (std::regex_search(line, place, kPlace)) {
      const std::size_t file = std::stoul(place[2]);
      if (file < files.size()) {
        const std::string at = place[3].matched ? place[3].str() : place[4].str();
        line = place[1].str() + files[file] + ':' + at + ':' + place.suffix().str();
      }
    }
    if (line.find_first_not_of(" \t\r") != std::string::npos) {
      if (!named.empty()) named += '\n';
      named += line;
    }
  }
  return named;
}

}  // namespace mirrorball::gl
