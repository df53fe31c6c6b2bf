#include "mirrorball/base/option_control.h"

#include <algorithm>

#include "mirrorball/base/text.h"

namespace mirrorball::detail {

OptionControl controlOf(const OptionText& text, ControlKind kind) {
  return {.kind = kind,
          .least_count = static_cast<std::size_t>(text.min_count),
          .count = static_cast<std::size_t>(text.max_count),
          .minimum = std::max(text.minimum, text.soft_minimum),
          .maximum = std::min(text.maximum, text.soft_maximum),
          .step = kind == ControlKind::integer ? std::max(text.step, 1.0) : text.step};
}

std::vector<float> numbersIn(const OptionText& text, const std::string& written) {
  std::vector<float> numbers;
  if (written.empty()) return numbers;
  for (const std::string_view each : split(written, text.between_numbers))
    if (const auto number = parseNumber(each)) numbers.push_back(static_cast<float>(*number));
  return numbers;
}

std::string textOf(const OptionText& text, const std::vector<float>& numbers) {
  std::string written = writeNumbers(numbers);
  std::replace(written.begin(), written.end(), ',', text.between_numbers);
  return written;
}

ControlKind kindOfText(const OptionText& text) {
  if (text.takes_path) return ControlKind::file;
  if (text.is_color) return ControlKind::color;
  if (text.max_count > 1) return ControlKind::numbers;
  return text.is_number ? ControlKind::number : ControlKind::text;
}

}  // namespace mirrorball::detail
