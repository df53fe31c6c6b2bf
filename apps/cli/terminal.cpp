#include "cli/terminal.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <mutex>

#include <unistd.h>

namespace mirrorball::cli {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t interrupt_seen = 0;
std::atomic<bool> bar_shown = false;

void onInterrupt(int) {
  interrupt_seen = 1;
  std::signal(SIGINT, SIG_DFL);
}

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

/// When a bar was started and last drawn.
struct BarState {
  std::mutex mutex;
  Clock::time_point start = Clock::now();
  Clock::time_point drawn = start;
};

void drawBar(const std::string& what, std::size_t done, std::size_t total, double elapsed) {
  constexpr std::size_t kWidth = 30;
  const std::size_t filled = kWidth * done / total;
  const double left = elapsed * static_cast<double>(total - done) / static_cast<double>(done);
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %zu/%zu, %.0f s left \033[K", what.c_str(), bar.c_str(), done, total, left);
  std::fflush(stderr);
  bar_shown = true;
}

}  // namespace

void catchSignals() {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return interrupt_seen != 0; }

ProgressFunction progressBar(const std::string& what) {
  const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
  auto state = std::make_shared<BarState>();
  return [=](std::size_t done, std::size_t total) {
    if (!on_terminal || done == 0 || total == 0) return !interrupted();
    const std::lock_guard lock(state->mutex);
    const Clock::time_point now = Clock::now();
    // Work that ends within half a second shows no bar at all.
    if (seconds(now - state->start) > 0.5 && seconds(now - state->drawn) > 0.1) {
      state->drawn = now;
      drawBar(what, done, total, seconds(now - state->start));
    }
    return !interrupted();
  };
}

void announce(const std::string& path) {
  clearProgress();
  if (::isatty(STDERR_FILENO) == 1) std::fprintf(stderr, "wrote %s\n", path.c_str());
}

void remark(const std::string& text) {
  clearProgress();
  std::fprintf(stderr, "mirrorball: %s\n", text.c_str());
}

void clearProgress() {
  if (bar_shown.exchange(false)) std::fputs("\r\033[K", stderr);
}

}  // namespace mirrorball::cli
