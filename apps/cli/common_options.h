#pragma once

#include <span>

#include "mirrorball/base/option.h"

namespace mirrorball::cli {

/// What every subcommand is told.
struct CommonOptions {
  bool quiet = false;
  int threads = 0;
};

std::span<const Option<CommonOptions>> commonOptions();

/// Puts them into force, before anything is computed.
void use(const CommonOptions& options);

}  // namespace mirrorball::cli
