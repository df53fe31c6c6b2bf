#pragma once

#include <map>
#include <optional>
#include <string>

#include "mirrorball/base/result.h"

namespace mirrorball::testing {

/// What a frame costs, in each unit in which it was measured.
struct FrameCost {
  std::optional<double> instructions;  ///< millions
  std::optional<double> yardsticks;    ///< processor time, as a multiple of Yardstick's
};

/// costs.txt: the driver that was measured, and the costs by the frame's name.
struct CostTable {
  std::string driver;  ///< "Mesa 22.3.6"
  std::map<std::string, FrameCost> frames;
};

/// errors   bad_file: a line that is none of its kinds
Result<CostTable> parseCostTable(const std::string& text);

/// `text` with other costs and driver; comments, among which the reasons are, stay.
std::string withCosts(const std::string& text, const CostTable& costs);

}  // namespace mirrorball::testing
