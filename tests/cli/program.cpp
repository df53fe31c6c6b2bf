#include "cli/program.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include <fcntl.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirrorball::testing {
namespace {

constexpr unsigned kLongestRun_s = 120;

/// Pointers to the texts, ended by a null pointer, as execve takes them.
std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// A cache for this very build of the program, so that what it prefilters otherwise than before is not
/// taken from there.
std::string cacheOfThisBuild() {
  const std::filesystem::path program = programFile();
  const auto built = std::filesystem::last_write_time(program).time_since_epoch().count();
  return (program.parent_path() / ("test_cache_" + std::to_string(built))).string();
}

/// This process' variables and others. The user's own cache is left alone.
std::vector<std::string> environmentWith(std::map<std::string, std::string> added) {
  added.emplace("MIRRORBALL_CACHE", cacheOfThisBuild());
  std::vector<std::string> all;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    if (!added.contains(text.substr(0, text.find('=')))) all.push_back(text);
  }
  for (const auto& [name, value] : added) all.push_back(name + "=" + value);
  return all;
}

/// Leaves the calling process the first `count` of its cores.
void keepCores(int count) {
  cpu_set_t allowed;
  sched_getaffinity(0, sizeof allowed, &allowed);
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (!CPU_ISSET(core, &allowed)) continue;
    if (count == 0) CPU_CLR(core, &allowed);
    if (count > 0) --count;
  }
  sched_setaffinity(0, sizeof allowed, &allowed);
}

/// As ulimit -f does.
void limitFiles(std::uintmax_t largest) {
  const rlimit limit{largest, largest};
  setrlimit(RLIMIT_FSIZE, &limit);
}

/// Both ends of a new pseudo terminal, ours first.
std::pair<File, File> openTerminal() {
  const int ours = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (ours < 0 || ::grantpt(ours) != 0 || ::unlockpt(ours) != 0) throw std::runtime_error("no pseudo terminal");
  return {File(::fdopen(ours, "r")), File(std::fopen(::ptsname(ours), "w"))};
}

/// The reading end of a pipe that holds all of the bytes.
int pipeOf(const std::vector<std::uint8_t>& bytes) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  ::fcntl(ends[1], F_SETPIPE_SZ, static_cast<int>(bytes.size()) + 1);
  const bool is_whole = ::write(ends[1], bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  ::close(ends[1]);
  if (!is_whole) throw std::runtime_error("more bytes than a pipe holds");
  return ends[0];
}

bool catchesInterrupts(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("SigCgt:")) return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
  return false;
}

}  // namespace

std::filesystem::path programFile() {
  const char* other = std::getenv("MIRRORBALL_PROGRAM");
  return other != nullptr ? other : MIRRORBALL_PROGRAM;
}

Program::Program(const Start& start) : out_(std::tmpfile()), err_(std::tmpfile()) {
  if (start.on_terminal) std::tie(terminal_, err_) = openTerminal();
  // All memory is taken before the fork: a child of a process with threads may only make system calls.
  std::vector<std::string> arguments{programFile().string()};
  arguments.insert(arguments.end(), start.arguments.begin(), start.arguments.end());
  std::vector<std::string> variables = environmentWith(start.environment);
  const std::vector<char*> argument_pointers = pointersTo(arguments);
  const std::vector<char*> variable_pointers = pointersTo(variables);
  const std::string folder = start.folder.string();
  const int input = start.input ? pipeOf(*start.input) : ::open("/dev/null", O_RDONLY | O_CLOEXEC);

  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("fork failed");
  if (process_ > 0) {
    if (terminal_) err_.reset();  // the program's is the last hold on its end, so that reading ends when it does
    ::close(input);
    return;
  }
  ::dup2(input, STDIN_FILENO);
  ::dup2(start.output_is_full ? ::open("/dev/full", O_WRONLY | O_CLOEXEC) : ::fileno(out_.get()), STDOUT_FILENO);
  ::dup2(::fileno(err_.get()), STDERR_FILENO);
  if (start.cores > 0) keepCores(start.cores);
  if (start.largest_file > 0) limitFiles(start.largest_file);
  // Whoever runs the tests in the background may have them ignored, and then the program does too.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
  ::alarm(kLongestRun_s);
  if (::chdir(folder.c_str()) == 0) ::execve(argument_pointers[0], argument_pointers.data(), variable_pointers.data());
  ::_exit(127);
}

Program::~Program() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Program::waitUntilItCatchesInterrupts() const {
  while (running() && !catchesInterrupts(process_)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void Program::waitUntilShown(const std::string& text) {
  while (shown_.find(text) == std::string::npos && readTerminal()) continue;
}

void Program::interrupt(int signal) const { ::kill(process_, signal); }

bool Program::running() const {
  siginfo_t state{};
  ::waitid(P_PID, static_cast<id_t>(process_), &state, WEXITED | WNOHANG | WNOWAIT);
  return state.si_pid == 0;
}

Outcome Program::wait() {
  while (terminal_ && readTerminal()) continue;
  int status = 0;
  rusage used{};
  ::wait4(process_, &status, 0, &used);
  process_ = -1;
  Outcome outcome;
  outcome.peak_memory = std::uint64_t(used.ru_maxrss) * 1024;
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  outcome.out = contents(out_);
  outcome.err = terminal_ ? shown_ : contents(err_);
  return outcome;
}

bool Program::readTerminal() {
  char piece[4096];
  const ssize_t count = ::read(::fileno(terminal_.get()), piece, sizeof piece);
  if (count > 0) shown_.append(piece, std::size_t(count));
  return count > 0;
}

std::string Program::contents(const File& file) {
  std::rewind(file.get());
  std::string text;
  char piece[4096];
  while (const std::size_t count = std::fread(piece, 1, sizeof piece, file.get())) text.append(piece, count);
  return text;
}

}  // namespace mirrorball::testing
