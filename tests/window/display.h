#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "mirrorball/image/image.h"

namespace mirrorball::testing {

/// A process that ends with its owner.
class Process {
 public:
  explicit Process(const std::vector<std::string>& words, const std::string& log = "/dev/null");
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  bool isRunning();
  /// Waits until it has ended by itself, so long at most.
  ///
  /// returns  its exit code; nothing: it goes on, or a signal ended it
  std::optional<int> waitFor(double seconds);

 private:
  pid_t id_ = -1;
  std::optional<int> status_;
};

/// Whether a program can be found.
bool isInstalled(const std::string& program);

/// An X display without a screen of 1700 × 800 pixels, with a window manager.
class Display {
 public:
  /// options   of the server: "-extension GLX"
  explicit Display(const std::string& options = "");

  /// One of two monitors, the second of 1280 × 800 pixels at the right of the first: Xorg's, with its dummy driver.
  ///
  /// returns  nothing: that is not installed, or may not be started by this user
  static std::unique_ptr<Display> withTwoMonitors();

  bool isThere() const { return is_there_; }
  const std::string& name() const { return name_; }

  /// Runs xdotool: "key ctrl+z", "mousemove 10 20".
  ///
  /// returns  what it printed
  std::string hand(const std::string& words) const;

  /// Stops the server under all who are connected to it.
  void stop() { server_.reset(); }

  /// All that is on it: 3 channels.
  Image8 photograph() const;

 private:
  struct Server {
    std::string command;  ///< as a shell takes it, with 3 for the number of its display
  };
  explicit Display(const Server& server);

  std::string name_;
  std::unique_ptr<Process> server_;
  std::unique_ptr<Process> manager_;
  bool is_there_ = false;
};

}  // namespace mirrorball::testing
