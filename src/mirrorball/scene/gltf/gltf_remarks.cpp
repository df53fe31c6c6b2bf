#include "mirrorball/scene/gltf/gltf_remarks.h"

#include <utility>

namespace mirrorball::gltf {

void Remarks::tell(std::string line) { lines_.push_back({std::move(line)}); }

void Remarks::leaveOut(const Error& damage, const char* what) {
  suspect(damage);
  leaveOut(damage.message, what);
}

void Remarks::leaveOut(std::string found, const char* what) {
  const std::string consequence = "; the " + std::string(what) + " is left out";
  add(consequence, std::move(found) + consequence);
}

void Remarks::tellOnce(const std::string& part, const std::string& oddity) { add(oddity, part + ": " + oddity); }

void Remarks::add(const std::string& kind, std::string text) {
  const auto [line, is_new] = line_of_.try_emplace(kind, lines_.size());
  if (is_new)
    lines_.push_back({std::move(text)});
  else
    ++lines_[line->second].count;
}

void Remarks::suspect(const Error& damage) {
  if (!first_damage_) first_damage_ = damage;
}

std::vector<std::string> Remarks::lines() const {
  std::vector<std::string> lines;
  for (const Line& line : lines_) {
    std::string text = line.text;
    if (line.count == 2) text += ", and so is another";
    if (line.count > 2) text += ", and so are " + std::to_string(line.count - 1) + " more";
    lines.push_back(std::move(text));
  }
  return lines;
}

}  // namespace mirrorball::gltf
