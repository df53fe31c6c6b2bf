#include "mirrorball/gl/sharing_contexts.h"

#include <future>
#include <system_error>
#include <utility>
#include <vector>

namespace mirrorball::gl {

Result<void> inSharingContexts(const Context& context, int threads, const std::function<Result<void>()>& work) {
  std::vector<std::future<Result<void>>> others;
  const auto in_own_context = [&]() -> Result<void> {
    const auto own = context.share();
    return own ? work() : Result<void>();
  };
  try {
    for (int i = 1; i < threads && context.isOurs(); ++i)
      others.push_back(std::async(std::launch::async, in_own_context));
  } catch (const std::system_error&) {
    // The system starts no more threads.
  }
  Result<void> result = work();
  for (auto& other : others) {
    Result<void> of_other = other.get();
    if (result) result = std::move(of_other);
  }
  return result;
}

}  // namespace mirrorball::gl
