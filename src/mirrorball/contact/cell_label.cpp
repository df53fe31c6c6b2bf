#include "mirrorball/contact/cell_label.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "mirrorball/environment/builtin/builtin.h"

namespace mirrorball {
namespace {

/// The names that a path goes through, from its end: "attic.hdr", "maps"; a built-in has one.
std::vector<std::string> partsFromEnd(const std::string& name) {
  if (isBuiltinEnvironment(name)) return {name};
  std::vector<std::string> parts;
  for (const std::filesystem::path& part : std::filesystem::path(name).lexically_normal())
    if (!part.empty() && part != "/") parts.push_back(part.string());
  std::reverse(parts.begin(), parts.end());
  if (parts.empty()) parts.push_back(name);
  return parts;
}

std::string lastParts(const std::vector<std::string>& parts, std::size_t count) {
  std::string label = parts[0];
  for (std::size_t i = 1; i < count; ++i) label = parts[i] + "/" + label;
  return label;
}

}  // namespace

std::vector<std::string> cellLabels(std::span<const std::string> names) {
  std::vector<std::vector<std::string>> parts;
  for (const std::string& name : names) parts.push_back(partsFromEnd(name));
  std::vector<std::size_t> counts(names.size(), 1);
  std::vector<std::string> labels(names.size());
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    std::map<std::string, std::set<std::vector<std::string>>> inputs_with;
    for (std::size_t i = 0; i < names.size(); ++i) {
      labels[i] = lastParts(parts[i], counts[i]);
      inputs_with[labels[i]].insert(parts[i]);
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (inputs_with[labels[i]].size() == 1 || counts[i] == parts[i].size()) continue;
      ++counts[i];
      has_grown = true;
    }
  }
  return labels;
}

std::string shortenedInTheMiddle(const std::string& letters, std::size_t longest) {
  constexpr std::size_t kDots = 3;
  if (letters.size() <= longest) return letters;
  if (longest <= 2 * kDots) return letters.substr(0, longest);
  const std::size_t kept = longest - kDots;
  const std::size_t head = kept / 2;
  return letters.substr(0, head) + "..." + letters.substr(letters.size() - (kept - head));
}

}  // namespace mirrorball
