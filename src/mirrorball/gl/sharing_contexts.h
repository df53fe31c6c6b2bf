#pragma once

#include <functional>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/context.h"

namespace mirrorball::gl {

/// Calls `work` in the calling thread and at the same time in other threads, each with a context that shares its
/// objects with the calling thread's (Context::share). There are fewer threads where the driver makes no such context
/// or the system starts none. Ends when all calls have ended.
///
/// context   current in the calling thread
/// threads   at least 1, the calling one among them
/// work      leaves none of its context's own objects behind; what it draws with a shared object, it finishes
/// errors    the first that a call returns, the calling thread's before others'
Result<void> inSharingContexts(const Context& context, int threads, const std::function<Result<void>()>& work);

}  // namespace mirrorball::gl
