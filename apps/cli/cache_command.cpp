#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "cli/commands.h"
#include "cli/terminal.h"
#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"

namespace mirrorball::cli {
namespace {

constexpr std::array<std::string_view, 2> kActions{"show", "clear"};
std::span<const std::string_view> cacheActionNames() { return kActions; }

std::string contentsText(const CacheFolder::Contents& contents) {
  if (contents.files == 0) return "nothing";
  return counted(contents.files, "file") + ", " + textOfBytes(contents.bytes);
}

Result<void> showOrClear(const std::string& what) {
  const auto action = indexOfName(what, kActions);
  if (!action) return tl::unexpected<Error>(unknownName("action of cache", what, kActions));
  MIRRORBALL_TRY(cache, CacheFolder::ofUser());
  if (!cache) {
    print("there is no cache: MIRRORBALL_CACHE is empty, or there is no home folder\n");
    return {};
  }
  print("folder       " + printable(cache->folder().string()) + "\n");
  if (kActions[*action] == "clear") {
    MIRRORBALL_TRY(removed, cache->clear());
    print("removed      " + contentsText(removed) + "\n");
    return {};
  }
  if (const auto usable = cache->check(); !usable) remark(usable.error().message);
  print("holds        " + contentsText(cache->contents()) + "\n");
  print("at most      " + (cache->maxBytes() == 0 ? "nothing" : textOfBytes(cache->maxBytes())) +
        " (MIRRORBALL_CACHE_SIZE); what was not used for longest goes first\n");
  return {};
}

}  // namespace

Command cacheCommand() {
  auto what = std::make_shared<std::string>("show");
  Command command{.name = "cache",
                  .help = "Shows or clears the cache of prefiltered environments and of the occlusion of models",
                  .about = "ACTION is `show` (the default) or `clear`.",
                  .examples = {{"cache show", "where it is, and how large"}, {"cache clear", "removes all of it"}}};
  addArgument(command, {.name = "ACTION", .help = "show or clear (default show)", .names = cacheActionNames}, *what);
  command.action = [what] { return showOrClear(*what); };
  return command;
}

}  // namespace mirrorball::cli
