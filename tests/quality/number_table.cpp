#include "quality/number_table.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <sstream>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"

namespace mirrorball::quality {
namespace {

bool isComment(const std::string& line) { return line.empty() || line.front() == '#'; }

/// The numbers behind the name of a row; nothing: one of them is not a number.
std::optional<std::vector<double>> parseRow(const std::vector<std::string>& cells) {
  std::vector<double> numbers;
  for (const std::string& cell : std::span(cells).subspan(1)) {
    const std::optional<double> number = parseNumber(cell);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

Result<std::string> readText(const std::filesystem::path& file) {
  MIRRORBALL_TRY(bytes, readFile(file));
  return std::string(bytes.begin(), bytes.end());
}

Result<void> writeText(const std::filesystem::path& file, const std::string& text) {
  return writeFile(file, std::vector<std::uint8_t>(text.begin(), text.end()));
}

Result<NumberTable> readNumberTable(const std::filesystem::path& file, std::size_t columns) {
  MIRRORBALL_TRY(text, readText(file));
  NumberTable table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (isComment(line)) continue;
    const std::vector<std::string> cells = split(line, '\t');
    const auto numbers = parseRow(cells);
    if (!numbers || numbers->size() != columns)
      return fail(ErrorCode::bad_file, file.string() + ": '" + line + "' is neither a comment nor a name and " +
                                           std::to_string(columns) + " numbers");
    table[cells.front()] = *numbers;
  }
  return table;
}

Result<void> writeNumberTable(const std::filesystem::path& file, const NumberTable& table) {
  MIRRORBALL_TRY(before, readText(file));
  std::string text;
  std::istringstream lines(before);
  for (std::string line; std::getline(lines, line);)
    if (isComment(line)) text += line + "\n";
  for (const auto& [name, numbers] : table) {
    text += name;
    for (const double number : numbers) {
      std::array<char, 32> written{};
      std::snprintf(written.data(), written.size(), "\t%.4f", number);
      text += written.data();
    }
    text += "\n";
  }
  return writeText(file, text);
}

}  // namespace mirrorball::quality
