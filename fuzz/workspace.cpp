// A viewer's workspace, as somebody opens or drops it: what is read can be drawn, shown in panels, and written again.

#include <string_view>

#include "fuzz.h"
#include "made_input.h"
#include "mirrorball/view/panel/panel.h"
#include "mirrorball/view/workspace/workspace_file.h"

MIRRORBALL_HARNESS(workspace) {
  using namespace mirrorball;
  const auto read = readWorkspace({reinterpret_cast<const char*>(data), size});
  fuzz::checkError(read);
  if (!read) return 0;
  for (std::size_t side = 0; side < read->sides.size(); ++side)
    fuzz::check(frameOf(*read, side).has_value(), "both halves can be drawn");
  fuzz::check(panelsOf(*read).has_value(), "it can be shown in panels");
  const auto again = readWorkspace(writtenWorkspace(*read));
  fuzz::check(again && *again == *read, "what was read is written and read again");
  return 0;
}
