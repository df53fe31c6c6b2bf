#include "cli/render_reference.h"
#include "cli/surface_ladder.h"

namespace mirrorball::cli {
namespace {

const Option<ReferenceOptions> kReference{
    {.name = "reference",
     .help = "path-trace the picture instead of drawing it: slow, and right where objects block light and send it to "
             "each other; it needs no graphics driver",
     .group = "Reference",
     .is_daily = true},
    &ReferenceOptions::is_wanted};

const Option<LadderOptions> kLadder{
    {.name = "ladder",
     .help = "instead of a map, a picture (.png, .jpg): the surface by all kinds of --relief of `render`, 60, 30 and "
             "10 degrees above the plane, beside the path-traced one; below each its PSNR to that, the time of a "
             "sample, and that as a multiple of bump's",
     .group = "Ladder"},
    &LadderOptions::is_wanted};

}  // namespace

std::span<const Option<ReferenceOptions>> referenceOption() { return {&kReference, 1}; }

std::span<const Option<LadderOptions>> ladderOption() { return {&kLadder, 1}; }

}  // namespace mirrorball::cli
