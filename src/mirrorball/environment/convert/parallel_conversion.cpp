#include "mirrorball/environment/convert/parallel_conversion.h"

#include <atomic>
#include <mutex>
#include <optional>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

/// So many strips share one buffer, and are one step of progress.
constexpr std::size_t kStripsPerTask = 4;

/// The failure of the first strip, whichever thread comes first.
class FirstFailure {
 public:
  void add(std::size_t index, const Error& error) {
    const std::lock_guard lock(mutex_);
    if (error_ && index_ < index) return;
    index_ = index;
    error_ = error;
  }
  std::optional<Error>& error() { return error_; }

 private:
  std::mutex mutex_;
  std::size_t index_ = 0;
  std::optional<Error> error_;
};

}  // namespace

Result<void> ParallelConversion::run(const Environment& source, std::span<const Strip> strips) {
  std::atomic<bool> failed = false;
  FirstFailure failure;
  parallelFor(strips.size(), kStripsPerTask, [&](std::size_t begin, std::size_t end) {
    Image texels;
    for (std::size_t index = begin; index < end && !failed && !steps_.stopped(); ++index) {
      const Strip& strip = strips[index];
      const glm::ivec2 size = strip.size();
      if (texels.width() != size.x || texels.height() != size.y)
        texels = Image::withoutValues(size.x, size.y, conversion_.channels());
      conversion_.fill(source, strip, texels);
      if (const auto taken = take_(strip.face, strip.begin, texels); !taken) {
        failure.add(index, taken.error());
        failed = true;
      }
    }
    steps_.advance(end - begin);
  });
  if (failure.error()) return tl::unexpected<Error>(std::move(*failure.error()));
  return steps_.result();
}

}  // namespace mirrorball
