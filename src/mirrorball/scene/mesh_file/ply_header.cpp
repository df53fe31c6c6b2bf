#include "mirrorball/scene/mesh_file/ply_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

std::optional<PlyType> plyTypeNamed(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kNames = {{
      {"char", "int8"},
      {"uchar", "uint8"},
      {"short", "int16"},
      {"ushort", "uint16"},
      {"int", "int32"},
      {"uint", "uint32"},
      {"float", "float32"},
      {"double", "float64"},
  }};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i].first || name == kNames[i].second) return static_cast<PlyType>(i);
  return {};
}

/// The lines of a header, each without its end.
class HeaderLines {
 public:
  explicit HeaderLines(std::string_view text) : text_(text), at_(text.size() - withoutByteOrderMark(text).size()) {
    // Files of old Macintoshes end lines with CR alone; elsewhere one is a part of "\r\n" only.
    const std::size_t end = text.find_first_of("\r\n");
    ends_with_ =
        end != std::string_view::npos && text[end] == '\r' && !text.substr(end).starts_with("\r\n") ? '\r' : '\n';
  }

  std::string_view next() {
    const std::size_t end = std::min(text_.find(ends_with_, at_), text_.size());
    const std::string_view line = trimmed(text_.substr(at_, end - at_));
    is_cut_ = end == text_.size();
    at_ = std::min(end + 1, text_.size());
    ++line_;
    return line;
  }

  /// Whether the last one had no end.
  bool isCut() const { return is_cut_; }
  bool atEnd() const { return at_ >= text_.size(); }
  std::size_t position() const { return at_; }
  std::size_t line() const { return line_; }  // of the last one, from 1

 private:
  std::string_view text_;
  std::size_t at_;
  std::size_t line_ = 0;
  char ends_with_;
  bool is_cut_ = false;
};

std::optional<PlyProperty> parseProperty(std::string_view words) {
  PlyProperty property;
  std::string_view word = takeWord(words);
  if (word == "list") {
    property.count_type = plyTypeNamed(takeWord(words));
    if (!property.count_type || isFloat(*property.count_type)) return {};
    word = takeWord(words);
  }
  const std::optional<PlyType> type = plyTypeNamed(word);
  property.name = takeWord(words);
  if (!type || property.name.empty()) return {};
  property.type = *type;
  return property;
}

std::optional<PlyEncoding> plyEncodingNamed(std::string_view name) {
  if (name == "ascii") return PlyEncoding::ascii;
  if (name == "binary_little_endian") return PlyEncoding::little_endian;
  if (name == "binary_big_endian") return PlyEncoding::big_endian;
  return {};
}

/// Takes a line of the header but its first and last; returns what is wrong with it, or nothing.
std::string takeHeaderLine(std::string_view line, PlyHeader& header, bool& has_format) {
  const std::string_view key = takeWord(line);
  if (key == "format") {
    const std::string_view name = takeWord(line);
    const auto encoding = plyEncodingNamed(name);
    if (!encoding) return "unknown format '" + excerpt(name) + "'";
    header.encoding = *encoding;
    has_format = true;
  } else if (key == "element") {
    PlyElement& element = header.elements.emplace_back();
    element.name = takeWord(line);
    const std::optional<double> count = parseNumber(takeWord(line));
    if (!count || *count < 0.0 || *count > 4294967295.0 || *count != std::floor(*count))
      return "the element has no valid count";
    element.count = static_cast<std::size_t>(*count);
  } else if (key == "property") {
    std::optional<PlyProperty> property = parseProperty(line);
    if (!property || header.elements.empty()) return "not a valid property";
    header.elements.back().properties.push_back(std::move(*property));
  } else if (key == "comment") {
    if (lowerCase(takeWord(line)) == "texturefile" && !line.empty()) header.pictures.emplace_back(line);
  } else if (key != "obj_info" && !key.empty()) {
    return "unknown key '" + excerpt(key) + "'";
  }
  return {};
}

}  // namespace

std::size_t byteSize(PlyType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

double fullScale(PlyType type) {
  constexpr double kFull[] = {127, 255, 32767, 65535, 2147483647, 4294967295, 1, 1};
  return kFull[static_cast<std::size_t>(type)];
}

bool isFloat(PlyType type) { return type == PlyType::float32 || type == PlyType::float64; }

bool PlyElement::has(std::string_view property) const {
  return std::any_of(properties.begin(), properties.end(),
                     [&](const PlyProperty& each) { return each.name == property; });
}

Result<PlyHeader> parsePlyHeader(std::string_view text) {
  HeaderLines lines(text);
  if (lines.next() != "ply") return fail(ErrorCode::bad_file, "is not a PLY file: its first line is not 'ply'");
  PlyHeader header;
  bool has_format = false;
  for (std::string_view line = lines.next(); line != "end_header"; line = lines.next()) {
    const std::string wrong = lines.isCut() ? "" : takeHeaderLine(line, header, has_format);
    if (wrong.empty() && lines.atEnd())
      return fail(ErrorCode::bad_file, "the header does not end; the file is truncated");
    if (!wrong.empty()) return fail(ErrorCode::bad_file, "line " + std::to_string(lines.line()) + ": " + wrong);
  }
  if (!has_format) return fail(ErrorCode::bad_file, "the header names no format");
  header.size = lines.position();
  return header;
}

}  // namespace mirrorball
