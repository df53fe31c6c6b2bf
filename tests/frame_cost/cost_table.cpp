#include "frame_cost/cost_table.h"

#include <cstdio>
#include <sstream>
#include <vector>

#include "mirrorball/base/text.h"

namespace mirrorball::testing {
namespace {

constexpr const char* kDriver = "driver";
constexpr const char* kUnknown = "-";

std::string written(const std::optional<double>& cost, const char* format) {
  if (!cost) return kUnknown;
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, format, *cost);
  return buffer;
}

std::optional<double> costOf(const std::string& word) {
  if (word == kUnknown) return std::nullopt;
  return std::stod(word);
}

}  // namespace

Result<CostTable> parseCostTable(const std::string& text) {
  CostTable table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> cells = split(line, '\t');
    if (cells.size() == 2 && cells[0] == kDriver) {
      table.driver = cells[1];
    } else if (cells.size() == 3) {
      table.frames[cells[0]] = {costOf(cells[1]), costOf(cells[2])};
    } else {
      return fail(ErrorCode::bad_file, "'" + line + "' is no comment, no driver and no frame's costs");
    }
  }
  return table;
}

std::string withCosts(const std::string& text, const CostTable& costs) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.empty() || line.front() == '#') result += line + "\n";
  result += std::string(kDriver) + "\t" + costs.driver + "\n";
  for (const auto& [name, cost] : costs.frames)
    result += name + "\t" + written(cost.instructions, "%.0f") + "\t" + written(cost.yardsticks, "%.2f") + "\n";
  return result;
}

}  // namespace mirrorball::testing
