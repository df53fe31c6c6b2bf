#pragma once

#include <future>
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

/// How a task is started that others need not wait for: on a thread of its own; where only one thread may compute, when
/// somebody waits for it.
std::launch besideOthers();

}  // namespace mirrorball::cli
