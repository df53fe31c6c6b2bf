#include "cli/interruption.h"

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <thread>

#include <semaphore.h>
#include <unistd.h>

#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/base/unfinished.h"

namespace mirrorball::cli {
namespace {

constexpr std::array<int, 3> kInterrupts{SIGINT, SIGTERM, SIGHUP};

/// How long the work may take to stop by itself.
constexpr std::chrono::milliseconds kPatience(250);

constexpr const char* kNothingWritten = "interrupted; nothing was written";

volatile std::sig_atomic_t caught_signal = 0;  // 0: none yet
sem_t signal_came;

/// Whose it is to end the program.
enum class End { nobodys, works, watchers };
std::atomic<End> end = End::nobodys;

/// What is said if the work does not tell itself.
struct LastWords {
  std::mutex guard;
  std::string message = kNothingWritten;
  bool is_told = false;  // what it is, by whenInterrupted
};
LastWords& lastWords() {
  static auto* const words = new LastWords;  // it outlives the thread that may ask for it
  return *words;
}

void onInterrupt(int signal) {
  caught_signal = signal;
  std::signal(signal, SIG_DFL);
  ::sem_post(&signal_came);
}

/// Ends the program when a signal came and the work does not stop.
void watch() {
  while (::sem_wait(&signal_came) != 0) continue;
  std::this_thread::sleep_for(kPatience);
  if (End nobodys = End::nobodys; !end.compare_exchange_strong(nobodys, End::watchers)) return;
  removeUnfinished();
  std::unique_lock lock(lastWords().guard);
  complain({ErrorCode::interrupted, lastWords().message});
  endByCaughtSignal();
}

/// A thread that is never given a signal itself: it would not end what another waits for.
void startWatching() {
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, &before);
  std::thread(watch).detach();
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace

void catchSignals() {
  ::sem_init(&signal_came, 0, 0);
  startWatching();
  for (const int signal : kInterrupts)
    if (std::signal(signal, onInterrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return caught_signal != 0; }

void whenInterrupted(const std::string& message) {
  const std::scoped_lock lock(lastWords().guard);
  lastWords().message = message;
  lastWords().is_told = true;
}

void noteWritten() {
  const std::scoped_lock lock(lastWords().guard);
  if (!lastWords().is_told) lastWords().message = "interrupted; what was finished stays";
}

std::string interruptedAfter(std::size_t whole, std::size_t all) {
  if (whole == 0) return kNothingWritten;
  return "interrupted after " + std::to_string(whole) + " of " + counted(all, "picture") + "; " +
         (whole == 1 ? "that one is whole" : "those are whole");
}

std::string interruptedAmongMany(const std::string& folder) {
  return folder.empty() ? std::string("interrupted") : "interrupted; what was finished stays in " + folder;
}

void claimEnd() {
  End before = End::nobodys;
  if (end.compare_exchange_strong(before, End::works) || before == End::works) return;
  while (true) ::pause();
}

void endByCaughtSignal() {
  if (!interrupted()) return;
  std::fflush(nullptr);
  std::signal(caught_signal, SIG_DFL);
  sigset_t only_this;
  ::sigemptyset(&only_this);
  ::sigaddset(&only_this, caught_signal);
  ::pthread_sigmask(SIG_UNBLOCK, &only_this, nullptr);
  std::raise(caught_signal);
}

}  // namespace mirrorball::cli
