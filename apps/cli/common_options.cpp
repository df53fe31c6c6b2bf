#include "cli/common_options.h"

#include <array>
#include <cstdlib>
#include <string>

#include "cli/terminal.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball::cli {
namespace {

const auto kCommonOptions = std::to_array<Option<CommonOptions>>({
    {{.name = "quiet", .help = "print no progress and no remarks; errors are still printed"}, &CommonOptions::quiet},
    {{.name = "threads",
      .value = "N",
      .minimum = 0,
      .maximum = 1024,
      .help = "number of threads; 0: one for each core. The result is the same for any number"},
     &CommonOptions::threads},
});

}  // namespace

std::span<const Option<CommonOptions>> commonOptions() { return kCommonOptions; }

void use(const CommonOptions& options) {
  if (options.quiet) beQuiet();
  if (options.threads == 0) return;
  setThreadLimit(options.threads);
  // Mesa's software driver has threads of its own, and goes by this variable.
  constexpr int kKeepWhatIsSet = 0;
  ::setenv("LP_NUM_THREADS", std::to_string(options.threads).c_str(), kKeepWhatIsSet);
}

}  // namespace mirrorball::cli
