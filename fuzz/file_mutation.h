#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include "chance.h"
#include "mirrorball/base/file.h"

namespace mirrorball::fuzz {

/// How files of a format are made, and changed so that most changes get behind their container.
struct FileMutation {
  Bytes (*any)(std::uint32_t number);                         ///< a good file; equal numbers make equal ones
  Bytes (*changed)(const Bytes& file, std::mt19937& random);  ///< another file with one change
};

/// A good file with up to three changes; equal numbers make equal files.
inline Bytes mutatedFile(const FileMutation& mutation, std::uint32_t number, std::uint32_t change) {
  std::mt19937 random(change);
  Bytes file = mutation.any(number);
  for (std::size_t changes = below(4, random); changes > 0; --changes) file = mutation.changed(file, random);
  return file;
}

}  // namespace mirrorball::fuzz
