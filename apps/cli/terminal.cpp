#include "cli/terminal.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <string_view>

#include <unistd.h>

#include "cli/command.h"
#include "cli/interruption.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball::cli {
namespace {

using Clock = std::chrono::steady_clock;

std::atomic<bool> bar_shown = false;
std::atomic<bool> is_quiet = false;
std::atomic<bool> suggests_size = true;
std::atomic<bool> output_is_taken = false;

/// What stands in messages for which path; filled before any work begins.
std::map<std::string, std::string>& shownNames() {
  static std::map<std::string, std::string> names;
  return names;
}

bool isTerminal() { return ::isatty(STDERR_FILENO) == 1 && !is_quiet; }

void say(std::FILE* stream, const std::string& line) {
  clearProgress();
  // A file's name on the command line may hold anything: a terminal is to show it, not to obey it.
  std::fprintf(stream, "%s\n", printable(shown(line)).c_str());
}

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

/// When a bar was started and last drawn.
struct BarState {
  std::mutex mutex;
  Clock::time_point start = Clock::now();
  Clock::time_point drawn = start;
};

/// Of the time that so much of the work took [s].
double secondsLeft(std::size_t done, std::size_t total, double elapsed_s) {
  return elapsed_s * static_cast<double>(total - done) / static_cast<double>(done);
}

/// Of how many how much is done, and the time that the rest takes: "80 pictures, 240 s left".
std::string totalAndTime(std::size_t done, std::size_t total, const std::string& unit, double elapsed_s) {
  return std::to_string(total) + (unit.empty() ? "" : " " + unit) + ", " +
         std::to_string(std::lround(secondsLeft(done, total, elapsed_s))) + " s left";
}

void drawBar(const std::string& what, std::size_t done, std::size_t total, const std::string& unit, double elapsed_s) {
  constexpr std::size_t kWidth = 30;
  const std::size_t filled = kWidth * done / total;
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %zu/%s \033[K", printable(what).c_str(), bar.c_str(), done,
               totalAndTime(done, total, unit, elapsed_s).c_str());
  std::fflush(stderr);
  bar_shown = true;
}

/// "study: 12 of 80 steps, 240 s left"
std::string progressLine(const std::string& what, std::size_t done, std::size_t total, const std::string& unit,
                         double elapsed_s) {
  return what + ": " + std::to_string(done) + " of " + totalAndTime(done, total, unit, elapsed_s);
}

constexpr double kBetweenLines_s = 30.0;

}  // namespace

bool showsProgress() { return isTerminal(); }

void beQuiet() { is_quiet = true; }

void suggestNoSize() { suggests_size = false; }

void showAs(const std::string& path, const std::string& name) { shownNames()[path] = name; }

std::string shown(std::string text) {
  for (const auto& [path, name] : shownNames())
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, at + name.size()))
      text.replace(at, path.size(), name);
  return text;
}

void keepStandardOutputFree() { output_is_taken = true; }

bool isStandardOutputTaken() { return output_is_taken; }

ProgressFunction progressBar(const std::string& what, const std::string& unit) {
  return progressBar([what] { return what; }, unit);
}

ProgressFunction progressBar(std::function<std::string()> what, const std::string& unit) {
  const bool on_terminal = isTerminal();
  // Work that ends within half a second shows no bar at all. A log has a line twice a minute.
  const double first_s = on_terminal ? 0.5 : kBetweenLines_s;
  const double between_s = on_terminal ? 0.1 : kBetweenLines_s;
  auto state = std::make_shared<BarState>();
  return [=](std::size_t done, std::size_t total) {
    if (is_quiet || done == 0 || total == 0) return !interrupted();
    const std::lock_guard lock(state->mutex);
    const Clock::time_point now = Clock::now();
    const double elapsed_s = seconds(now - state->start);
    if (elapsed_s > first_s && seconds(now - state->drawn) > between_s) {
      state->drawn = now;
      if (on_terminal)
        drawBar(what(), done, total, unit, elapsed_s);
      else
        say(stderr, progressLine(what(), done, total, unit, elapsed_s));
    }
    return !interrupted();
  };
}

void announce(const std::string& path) {
  noteWritten();
  if (isTerminal()) say(stderr, "wrote " + path);
}

void tellAside(const std::string& line) {
  if (!is_quiet) say(stderr, line);
}

void tell(const std::string& line) {
  if (!is_quiet) say(output_is_taken ? stderr : stdout, line);
}

void print(const std::string& text) {
  if (is_quiet && output_is_taken) return;
  std::FILE* const to = output_is_taken ? stderr : stdout;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    std::fprintf(to, "%s\n", printable(std::string_view(text).substr(begin, end - begin)).c_str());
}

Result<void> flushStandardOutput() {
  errno = 0;
  const bool is_sent = std::fflush(stdout) == 0;
  if (is_sent && std::ferror(stdout) == 0) return {};
  // What failed earlier has left no reason.
  const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  return fail(ErrorCode::io, "standard output: cannot be written" + reason);
}

void remark(const std::string& text) {
  if (!is_quiet) say(stderr, "mirrorball: note: " + inCommandWords(text));
}

namespace {

/// Which options help, as the end of a remark.
std::string adviceOn(const Remark& remark) {
  switch (remark.kind) {
    case RemarkKind::light_lost:
      return "; --scale-light or --format float32 would keep it";
    case RemarkKind::light_too_bright:
      return "; --scale-light or, of small lamps in a folder, --split would keep it";
    case RemarkKind::format_widened:
      return "; --format half is half as large, and cuts what is brighter than 65504";
    case RemarkKind::digits_lost:
      return "; --format float32 holds them all";
    case RemarkKind::form_unsaid:
      return "; to read this one, add --from " + remark.detail;
    case RemarkKind::light_limited:
      return " (--clamp-light)";
    case RemarkKind::form_doubted:
      return ", and --from " + join(split(remark.detail, '|'), " or --from ") + " names another form";
    case RemarkKind::levels_left_out:
      return "; --mips takes all";
    case RemarkKind::body_open:
      return "; --set thin_walled=yes makes it a thin sheet without an inside";
    case RemarkKind::levels_few:
      return remark.detail.empty() ? "; a larger --size mends it" : "; --levels " + remark.detail + " mends it";
    default:
      return "";
  }
}

/// Which option helps, as the end of an error.
std::string adviceOn(FixHint hint) {
  switch (hint) {
    case FixHint::none:
      return "";
    case FixHint::repair:
      return "; --repair replaces them by their neighbours";
    case FixHint::raise_memory:
      return "; raise --max-memory";
    case FixHint::raise_memory_or_shrink:
      return suggests_size ? "; --max-memory raises that, a smaller --size needs less"
                           : adviceOn(FixHint::raise_memory);
    case FixHint::store_floats:
      return ", or use --format float32";
    case FixHint::scale_light:
      return "; --scale-light 1e-6 of convert or bake makes them fit";
    case FixHint::name_projection:
      return "; say which it gets: --to " + join(projectionNames(), "|");
    case FixHint::name_form:
      return ", or name its form with --from";
    case FixHint::name_form_of_cube:
      return "; leave --from out, or name cube or eac";
    case FixHint::take_one_level:
      return ", or one level: convert --level";
    case FixHint::give_circle:
      return "; give it with --circle X,Y,R in pixels";
    case FixHint::give_exposures:
      return "; give all of them with --exposures, as in --exposures 1/60,1/15,1/4";
    case FixHint::name_response:
      return ", or give --response srgb";
    case FixHint::convert_to_panorama:
      return " (convert --to equirect)";
    case FixHint::give_angles:
      return "; give --camera AZIMUTH,ELEVATION, as in --camera 30,15";
    case FixHint::resize:
      return ", or --resize the first";
  }
  return "";
}

}  // namespace

Observer terminalObserver() {
  return {.remark = [](const Remark& told) { remark(told.message + adviceOn(told)); },
          .written = announce,
          .progress = [](std::string_view stage) { return progressBar(std::string(stage)); }};
}

std::string lineOf(const Error& error) { return inCommandWords(error.message) + adviceOn(error.fix_hint); }

void complain(const Error& error) { say(stderr, "mirrorball: " + lineOf(error)); }

Result<void> outcomeOfMany(std::size_t failed, std::size_t all, const std::string& done, const std::string& folder) {
  const std::string where = folder.empty() ? "" : "; the others are in " + folder;
  if (interrupted()) return fail(ErrorCode::interrupted, interruptedAmongMany(folder));
  if (failed == 0) return {};
  if (failed == all) return fail(ErrorCode::bad_file, "none of " + std::to_string(all) + " inputs could be " + done);
  return fail(ErrorCode::bad_file,
              std::to_string(failed) + " of " + std::to_string(all) + " inputs could not be " + done + where);
}

void clearProgress() {
  if (bar_shown.exchange(false)) std::fputs("\r\033[K", stderr);
}

}  // namespace mirrorball::cli
