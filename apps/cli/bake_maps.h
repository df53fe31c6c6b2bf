#pragma once

#include "cli/baked_set.h"
#include "cli/stage_clock.h"

namespace mirrorball::cli {

/// A specular chain, and what its file says of the environment beside it.
struct BakedChain {
  ImageSet levels;
  Metadata facts;
};

/// Loads the environment and makes its specular chain.
///
/// output   that the chain is for: may not be the input itself, and what writing it takes is counted
/// errors   as loadEnvironment's; usage (the output is the input); too_large; interrupted
Result<BakedChain> bakeChain(const BakeRequest& request, const MapFile& output, StageClock& clock);

/// The same for all that a folder has.
Result<BakedSet> bakeSet(const BakeRequest& request, const BakedFiles& files, StageClock& clock);

}  // namespace mirrorball::cli
