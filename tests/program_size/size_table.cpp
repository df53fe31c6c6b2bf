#include "program_size/size_table.h"

#include <array>
#include <cstddef>
#include <optional>
#include <sstream>
#include <vector>

#include "mirrorball/base/text.h"

namespace mirrorball::testing {
namespace {

constexpr const char* kTools = "tools";

/// In the order of the columns.
constexpr std::array kColumns{&ProgramSize::instructions,   &ProgramSize::inlined,    &ProgramSize::samplings,
                              &ProgramSize::arriving_light, &ProgramSize::sight_from, &ProgramSize::ray_walks};

std::optional<ProgramSize> parseSize(const std::vector<std::string>& cells) {
  if (cells.size() != 1 + kColumns.size()) return std::nullopt;
  ProgramSize size;
  for (std::size_t column = 0; column < kColumns.size(); ++column) {
    const std::optional<double> number = parseNumber(cells[1 + column]);
    if (!number) return std::nullopt;
    size.*kColumns[column] = static_cast<int>(*number);
  }
  return size;
}

}  // namespace

Result<SizeTable> parseSizeTable(const std::string& text) {
  SizeTable table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> cells = split(line, '\t');
    if (cells.size() == 2 && cells[0] == kTools) {
      table.tools = cells[1];
    } else if (const auto size = parseSize(cells)) {
      table.programs[cells[0]] = *size;
    } else {
      return fail(ErrorCode::bad_file, "'" + line + "' is neither a comment nor tools nor a program's size");
    }
  }
  return table;
}

std::string withSizes(const std::string& text, const SizeTable& sizes) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.empty() || line.front() == '#') result += line + "\n";
  result += std::string(kTools) + "\t" + sizes.tools + "\n";
  for (const auto& [name, size] : sizes.programs) {
    result += name;
    for (const auto column : kColumns) result += "\t" + std::to_string(size.*column);
    result += "\n";
  }
  return result;
}

}  // namespace mirrorball::testing
