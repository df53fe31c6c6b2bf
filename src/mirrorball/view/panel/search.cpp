#include <algorithm>
#include <cctype>
#include <string>
#include <tuple>

#include "mirrorball/view/panel/panel.h"

namespace mirrorball {
namespace {

std::string lowered(std::string_view text) {
  std::string low(text);
  for (char& letter : low) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return low;
}

/// Whether letters stand in a text in their order, be it with others between.
bool hasInOrder(std::string_view text, std::string_view letters) {
  for (const char letter : letters) {
    const std::size_t place = text.find(letter);
    if (place == std::string_view::npos) return false;
    text.remove_prefix(place + 1);
  }
  return true;
}

/// How far a row is from what was meant: less is nearer.
enum Distance { is_name, begins_name, begins_word, within_name, in_choices, in_help, scattered, not_meant };

Distance distanceOf(const PanelRow& row, std::string_view letters) {
  const std::string name = lowered(row.name);
  if (name == letters) return is_name;
  const std::size_t place = name.find(letters);
  if (place == 0) return begins_name;
  if (place != std::string::npos) return name[place - 1] == '-' || name[place - 1] == '_' ? begins_word : within_name;
  for (const auto* words : {&row.choices, &row.names})
    for (const std::string_view word : *words)
      if (lowered(word).starts_with(letters)) return in_choices;
  if (lowered(row.help).find(letters) != std::string::npos) return in_help;
  return hasInOrder(name, letters) ? scattered : not_meant;
}

}  // namespace

std::vector<FoundRow> searchRows(const std::vector<PanelGroup>& groups, std::string_view letters) {
  const std::string wanted = lowered(letters);
  std::vector<std::tuple<Distance, bool, std::size_t, std::size_t>> found;
  for (std::size_t group = 0; group < groups.size(); ++group)
    for (std::size_t row = 0; row < groups[group].rows.size(); ++row) {
      const PanelRow& each = groups[group].rows[row];
      const Distance distance = wanted.empty() ? is_name : distanceOf(each, wanted);
      if (distance != not_meant) found.emplace_back(distance, !each.is_daily, group, row);
    }
  std::sort(found.begin(), found.end());
  std::vector<FoundRow> rows;
  for (const auto& [distance, is_rare, group, row] : found) rows.push_back({group, row});
  return rows;
}

}  // namespace mirrorball
