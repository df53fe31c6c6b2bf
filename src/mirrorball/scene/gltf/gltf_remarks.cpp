#include "mirrorball/scene/gltf/gltf_remarks.h"

#include <utility>

namespace mirrorball::gltf {

void Remarks::tell(std::string line) { lines_.push_back({std::move(line)}); }

void Remarks::leaveOut(const Error& damage, const char* what) {
  suspect(damage);
  leaveOut(damage.message, what);
}

void Remarks::leaveOut(std::string found, const char* what) {
  const auto [line, is_new] = line_of_.try_emplace(what, lines_.size());
  if (is_new)
    lines_.push_back({std::move(found), what});
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
    if (line.what != nullptr) text += "; the " + std::string(line.what) + " is left out";
    if (line.count == 2) text += ", and so is another";
    if (line.count > 2) text += ", and so are " + std::to_string(line.count - 1) + " more";
    lines.push_back(std::move(text));
  }
  return lines;
}

}  // namespace mirrorball::gltf
