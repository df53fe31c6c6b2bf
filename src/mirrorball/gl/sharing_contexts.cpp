#include "mirrorball/gl/sharing_contexts.h"

#include <future>
#include <utility>
#include <vector>

namespace mirrorball::gl {

Result<void> inSharingContexts(const Context& context, int threads, const std::function<Result<void>()>& work) {
  std::vector<std::future<Result<void>>> others;
  for (int i = 1; i < threads; ++i)
    others.push_back(std::async(std::launch::async, [&]() -> Result<void> {
      const auto own = context.share();
      return own ? work() : Result<void>();
    }));
  Result<void> result = work();
  for (auto& other : others) {
    Result<void> of_other = other.get();
    if (result) result = std::move(of_other);
  }
  return result;
}

}  // namespace mirrorball::gl
