#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// What a file is wanted as, or is.
enum class FileUse {
  picture,
  model,
  any,  ///< a file of that kind stands for the one that is meant, whatever that is: an archive, a page of a server
};

/// As many first bytes as tell all kinds.
inline constexpr std::size_t kForeignFileBytes = 1024;

/// The error for a file of another kind than those that are read, with what helps: "is a Git LFS pointer, which is not
/// read; fetch …". Nothing where its kind is not known.
///
/// wanted     a picture or a model; any: only what stands for another file is named
/// begin      its first kForeignFileBytes, or all there are
/// extension  "fbx", of kinds without first bytes of their own; empty: the bytes alone tell
std::optional<Error> foreignFileError(FileUse wanted, std::span<const std::uint8_t> begin,
                                      std::string_view extension = {});

}  // namespace mirrorball
