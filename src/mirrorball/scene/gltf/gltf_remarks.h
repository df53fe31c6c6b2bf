#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"

namespace mirrorball::gltf {

/// What is odd about a file, as it is found: each kind of damage becomes one line, however often it is met. A file is
/// shown without what is damaged; where nothing of it is left to be shown, the first damage is why it is refused.
///
/// Not for several threads at a time: what they find is added after them, in the file's order.
class Remarks {
 public:
  /// A line of its own, the continuation of "NAME: ".
  void tell(std::string line);

  /// "images[0]: is turned upright": a line for all parts of which this is found.
  void tellOnce(const std::string& part, const std::string& oddity);

  /// Something is left out, since it is damaged or names what is not there.
  ///
  /// what     in the singular: "texture". The line is of the first damage of each, with how many more there are
  void leaveOut(const Error& damage, const char* what);

  /// Something sound is left out, since it is not read.
  void leaveOut(std::string found, const char* what);

  /// Damage that matters only if it leaves nothing to be shown.
  void suspect(const Error& damage);

  /// Why a file is refused of which nothing is left; none: nothing was damaged.
  const std::optional<Error>& firstDamage() const { return first_damage_; }

  std::vector<std::string> lines() const;

 private:
  struct Line {
    std::string text;
    std::size_t count = 1;  // of parts that are alike
  };
  void add(const std::string& kind, std::string text);

  std::vector<Line> lines_;
  std::map<std::string, std::size_t> line_of_;  // by what its parts have in common
  std::optional<Error> first_damage_;
};

}  // namespace mirrorball::gltf
