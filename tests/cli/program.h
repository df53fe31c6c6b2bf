#pragma once

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace mirrorball::testing {

/// The program's file: $MIRRORBALL_PROGRAM, else the one that was built beside the tests.
std::filesystem::path programFile();

/// How the program is started.
struct Start {
  std::vector<std::string> arguments = {};
  std::filesystem::path folder = {};                    ///< that it works in
  std::map<std::string, std::string> environment = {};  ///< variables beside this process's own
  int cores = 0;                                        ///< that it may use; 0 leaves it all
  std::uintmax_t largest_file = 0;                      ///< [bytes] that it can write before its disk is full; 0: any
  std::optional<std::vector<std::uint8_t>> input = {};  ///< what is piped into it; nothing: its input is empty
  bool output_is_full = false;                          ///< its standard output takes nothing, as a full disk
  bool on_terminal = false;                             ///< what it complains about goes to a (pseudo) terminal
};

/// What the program said, and how it ended.
struct Outcome {
  int exit_code = -1;  ///< −1 where a signal ended it
  int signal = 0;
  std::string out;
  std::string err;
  /// The most memory that it had at a time [bytes]. Linux counts what this process had when it started the program.
  std::uint64_t peak_memory = 0;
};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// The program itself, as it was built, in a process of its own; no shell between. It is ended when
/// it runs for longer than two minutes, or when its owner goes away.
class Program {
 public:
  explicit Program(const Start& start);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  /// Returns when the program would catch Ctrl-C, as Linux tells in /proc, or has ended.
  void waitUntilItCatchesInterrupts() const;

  /// Returns when its terminal shows this text, or it has ended.
  void waitUntilShown(const std::string& text);

  /// What Ctrl-C does, or another signal.
  void interrupt(int signal = SIGINT) const;

  bool running() const;

  /// Waits until it has ended.
  Outcome wait();

 private:
  static std::string contents(const File& file);
  /// Takes what its terminal shows next, for which it waits; false when it has ended.
  bool readTerminal();

  // Files without a name: unlike a pipe they never fill up.
  File out_;
  File err_;
  File terminal_;  ///< our end of it, when there is one
  std::string shown_;
  pid_t process_ = -1;
};

}  // namespace mirrorball::testing
