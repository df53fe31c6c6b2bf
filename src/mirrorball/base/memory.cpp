#include "mirrorball/base/memory.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <utility>

#include <sys/resource.h>
#include <unistd.h>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr double kMega = 1024.0 * 1024.0;
constexpr double kGiga = 1024.0 * kMega;

std::uint64_t physicalMemory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page_size = ::sysconf(_SC_PAGE_SIZE);
  return std::uint64_t(std::max(pages, 1L)) * std::uint64_t(std::max(page_size, 1L));
}

/// What a container may use; where there is no bound the file says "max".
std::uint64_t controlGroupMemory() {
  std::ifstream file("/sys/fs/cgroup/memory.max");
  std::uint64_t bytes = 0;
  return file >> bytes ? bytes : UINT64_MAX;
}

std::atomic<std::uint64_t>& limit() {
  static std::atomic<std::uint64_t> bytes = std::min(physicalMemory(), controlGroupMemory()) / 4 * 3;
  return bytes;
}

/// The innermost one.
thread_local MemoryShare* share_of_thread = nullptr;

tl::unexpected<Error> tooMuch(std::uint64_t bytes) {
  return fail(ErrorCode::too_large,
              "needs " + textOfBytes(bytes) + " of memory, and " + textOfBytes(memoryLimit()) + " may be used",
              FixHint::raise_memory_or_shrink);
}

}  // namespace

std::uint64_t memoryLimit() { return limit(); }

std::uint64_t addressSpaceLeft() {
  rlimit bound{};
  if (::getrlimit(RLIMIT_AS, &bound) != 0 || bound.rlim_cur == RLIM_INFINITY) return UINT64_MAX;
  std::ifstream file("/proc/self/statm");
  std::uint64_t pages = 0;
  if (!(file >> pages)) return UINT64_MAX;
  const std::uint64_t taken = pages * std::uint64_t(std::max(::sysconf(_SC_PAGE_SIZE), 1L));
  return std::uint64_t(bound.rlim_cur) - std::min(taken, std::uint64_t(bound.rlim_cur));
}

void setMemoryLimit(std::uint64_t bytes) { limit() = bytes; }

Result<void> checkMemory(std::uint64_t bytes) {
  if (share_of_thread != nullptr) return share_of_thread->raiseTo(bytes);
  return bytes <= memoryLimit() ? Result<void>() : tooMuch(bytes);
}

Result<void> MemoryBudget::take(std::uint64_t bytes) {
  for (std::uint64_t before = taken_;;) {
    const std::uint64_t limit = memoryLimit();
    if (bytes > limit || before > limit - bytes) return tooMuch(bytes > UINT64_MAX - before ? bytes : before + bytes);
    if (taken_.compare_exchange_weak(before, before + bytes)) return {};
  }
}

MemoryShare::MemoryShare(MemoryBudget& budget) : budget_(budget), outer_(std::exchange(share_of_thread, this)) {}

MemoryShare::~MemoryShare() {
  share_of_thread = outer_;
  budget_.giveBack(taken_ - kept_);
}

Result<void> MemoryShare::raiseTo(std::uint64_t bytes) {
  if (bytes <= taken_) return {};
  MIRRORBALL_TRY_VOID(budget_.take(bytes - taken_));
  taken_ = bytes;
  return {};
}

Result<void> MemoryShare::keep(std::uint64_t bytes) {
  MIRRORBALL_TRY_VOID(raiseTo(bytes));
  kept_ = bytes;
  return {};
}

std::string textOfBytes(std::uint64_t bytes) {
  const auto count = static_cast<double>(bytes);
  char text[32];
  if (count >= 0.95 * kGiga)
    std::snprintf(text, sizeof(text), "%.1f GB", count / kGiga);
  else
    std::snprintf(text, sizeof(text), "%.0f MB", std::max(count / kMega, 1.0));
  return text;
}

Result<std::uint64_t> parseBytes(std::string_view written) {
  std::string_view number = written;
  if (number.ends_with('B') || number.ends_with('b')) number.remove_suffix(1);
  double unit = 1.0;
  if (!number.empty()) {
    const int letter = std::toupper(static_cast<unsigned char>(number.back()));
    if (letter == 'M' || letter == 'G') {
      unit = letter == 'M' ? kMega : kGiga;
      number.remove_suffix(1);
    }
  }
  const auto count = parseNumber(number);
  if (!count || *count <= 0.0 || *count * unit > 1e18)
    return fail(ErrorCode::usage, "'" + std::string(written) + "' is no amount of memory; write it as in 1.5G or 800M");
  return static_cast<std::uint64_t>(*count * unit);
}

}  // namespace mirrorball
