#include "mirrorball/gl/shader_source.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdio>

#include "mirrorball/base/range.h"
#include "shaders/embedded_text.h"

namespace mirrorball::gl {
namespace {

constexpr std::string_view kDesktopVersion = "#version 430 core\n";
constexpr std::string_view kEmbeddedVersion =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n"
    "precision highp sampler2D;\n"
    "precision highp samplerCube;\n"
    "precision highp usampler2D;\n";

// The shader's half of the agreement that lets a formula file be GLSL and C++; the other half is
// formula/glsl_begin.inc.
constexpr std::string_view kPrelude =
    "#define FN\n"
    "#define CUBE_SAMPLER samplerCube\n"
    "#define INITIALLY(value)\n"
    "#define MAKE(Type) Type\n"
    "#define HAS_FILM(material) (material.iridescence > 0.0)\n"
    "vec4 sampleLod(samplerCube map, vec3 direction, float lod) {\n"
    "  return textureLod(map, direction, lod);\n"
    "}\n"
    "#define MAP_SAMPLER sampler2D\n"
    "vec4 sampleMap(sampler2D map, vec2 uv) { return textureLod(map, uv, 0.0); }\n"
    "vec4 fetchMap(sampler2D map, ivec2 texel, int level) { return texelFetch(map, texel, level); }\n"
    "ivec2 mapSize(sampler2D map, int level) { return textureSize(map, level); }\n"
    "#define WORD_SAMPLER usampler2D\n"
    "uvec4 fetchWords(usampler2D words, int texel) {\n"
    "  return texelFetch(words, ivec2(texel & 4095, texel >> 12), 0);\n"  // Texture::kWordTexels a row
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

/// Appends a file, and in place of its #include lines the files that they name.
Result<void> append(ShaderSource& source, std::string_view name, std::string_view rest, const FindText& find) {
  const std::size_t file = source.files.size();
  source.files.emplace_back(name);
  source.text += lineDirective(1, file);
  for (int line_number = 1; !rest.empty(); ++line_number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end);
    const std::optional<std::string_view> included = includedName(line);
    if (!included) {
      source.text += line;
      if (rest.empty() && !line.ends_with('\n')) source.text += '\n';
      continue;
    }
    if (contains(source.files, *included)) {
      source.text += '\n';
      continue;
    }
    const std::optional<std::string_view> text = find(*included);
    if (!text) {
      return fail(ErrorCode::not_found, std::string(name) + ", line " + std::to_string(line_number) +
                                            ": no shader text is named " + std::string(*included));
    }
    MIRRORBALL_TRY_VOID(append(source, *included, *text, find));
    source.text += lineDirective(line_number + 1, file);
  }
  return {};
}

}  // namespace

Result<ShaderSource> shaderSource(Api api, std::string_view entry, std::span<const std::string_view> defines,
                                  const FindText& find) {
  const FindText find_text = find ? find : FindText(embeddedText);
  const std::optional<std::string_view> text = find_text(entry);
  if (!text) return fail(ErrorCode::not_found, std::string(entry) + ": no such shader");
  ShaderSource source;
  source.text = api == Api::desktop43 ? kDesktopVersion : kEmbeddedVersion;
  source.text += kPrelude;
  for (std::string_view define : defines) source.text += "#define " + std::string(define) + '\n';
  MIRRORBALL_TRY_VOID(append(source, entry, *text, find_text));
  return source;
}

namespace {

/// The place that a message of a driver's compiler begins with, and where in the message it stands.
struct Place {
  std::size_t file = 0;
  int line = 0;
  std::size_t begin = 0;
  std::size_t end = 0;  ///< of the colon behind it
};

std::optional<Place> placeIn(const std::string& message) {
  Place place;
  for (const std::string_view kind : {"ERROR: ", "WARNING: "})
    if (message.starts_with(kind)) place.begin = kind.size();
  const std::size_t separator = message.find_first_not_of("0123456789", place.begin);
  if (separator == place.begin || separator == std::string::npos || !std::isdigit(message[separator + 1]))
    return std::nullopt;
  // "0:12(5): error" is Mesa's form, "0(12) : error" NVIDIA's, "ERROR: 0:12:" that of most others.
  for (const char* form : {"%9zu:%9d(%*9d)%n", "%9zu:%9d%n", "%9zu(%9d) %n"}) {
    int length = 0;
    if (std::sscanf(message.c_str() + place.begin, form, &place.file, &place.line, &length) != 2) continue;
    place.end = place.begin + static_cast<std::size_t>(length);
    if (length > 0 && message[place.end] == ':') return place;
  }
  return std::nullopt;
}

}  // namespace

std::string namedLog(std::string_view log, std::span<const std::string> files) {
  std::string named;
  while (!log.empty()) {
    const std::size_t end = std::min(log.find('\n'), log.size());
    std::string line(log.substr(0, end));
    log.remove_prefix(std::min(end + 1, log.size()));
    if (const auto place = placeIn(line); place && place->file < files.size())
      line.replace(place->begin, place->end - place->begin, files[place->file] + ':' + std::to_string(place->line));
    if (line.find_first_not_of(" \t\r") != std::string::npos) {
      if (!named.empty()) named += '\n';
      named += line;
    }
  }
  return named;
}

}  // namespace mirrorball::gl
