#include "window/display.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirrorball::testing {
namespace {

void sleepFor(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// What a command writes to its standard output.
std::string outputOf(const std::string& command) {
  std::string output;
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return output;
  std::array<char, 65536> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    output.append(buffer.data(), count);
  ::pclose(pipe);
  return output;
}

}  // namespace

Process::Process(const std::vector<std::string>& words, const std::string& log) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  id_ = ::fork();
  if (id_ != 0) return;
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(file, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

Process::~Process() {
  if (!isRunning()) return;
  ::kill(id_, SIGTERM);
  if (waitFor(5.0) || status_) return;
  ::kill(id_, SIGKILL);
  ::waitpid(id_, nullptr, 0);
}

bool Process::isRunning() {
  if (id_ <= 0 || status_) return false;
  int status = 0;
  if (::waitpid(id_, &status, WNOHANG) == 0) return true;
  status_ = status;
  return false;
}

std::optional<int> Process::waitFor(double seconds) {
  for (double waited = 0.0; isRunning(); waited += 0.02) {
    if (waited > seconds) return std::nullopt;
    sleepFor(0.02);
  }
  return status_ && WIFEXITED(*status_) ? std::optional(WEXITSTATUS(*status_)) : std::nullopt;
}

bool isInstalled(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

Display::Display(const std::string& options)
    : Display(Server{"Xvfb -displayfd 3 -nolisten tcp -screen 0 1700x800x24 " + options}) {}

Display::Display(const Server& server) {
  // The server chooses a number that is free, and tells it.
  const std::string told =
      std::filesystem::temp_directory_path() / ("mirrorball_display_" + std::to_string(::getpid()));
  server_ = std::make_unique<Process>(std::vector<std::string>{"sh", "-c", "exec " + server.command + " 3>" + told});
  for (int tries = 0; tries < 500 && name_.size() < 2; ++tries) {
    sleepFor(0.02);
    std::string number = outputOf("cat " + told + " 2>/dev/null");
    while (!number.empty() && number.back() == '\n') number.pop_back();
    name_ = ":" + number;
  }
  std::filesystem::remove(told);
  if (name_.size() < 2) return;
  ::setenv("DISPLAY", name_.c_str(), 1);
  // A window that asks to be seen while the manager begins may be forgotten.
  const std::string ready = told + "_managed";
  manager_ = std::make_unique<Process>(std::vector<std::string>{"openbox", "--startup", "touch " + ready});
  for (int tries = 0; tries < 500 && !is_there_; ++tries) {
    sleepFor(0.02);
    is_there_ = std::filesystem::exists(ready);
  }
  std::filesystem::remove(ready);
}

std::unique_ptr<Display> Display::withTwoMonitors() {
  constexpr std::string_view kConfiguration = R"(
Section "Device"
  Identifier "device"
  Driver "dummy"
  VideoRam 65536
EndSection
Section "Monitor"
  Identifier "monitor"
  HorizSync 5-1000
  VertRefresh 5-200
  Modeline "1700x800" 110 1700 1720 1740 1760 800 805 810 830
EndSection
Section "Screen"
  Identifier "screen"
  Device "device"
  Monitor "monitor"
  DefaultDepth 24
  SubSection "Display"
    Depth 24
    Modes "1700x800"
  EndSubSection
EndSection
)";
  for (const char* program : {"Xorg", "xrandr"})
    if (!isInstalled(program)) return nullptr;
  const std::string file = std::filesystem::temp_directory_path() / ("mirrorball_xorg_" + std::to_string(::getpid()));
  std::ofstream(file) << kConfiguration;
  std::unique_ptr<Display> display(new Display(Server{"Xorg -config " + file + " -logfile " + file + ".log " +
                                                      "-noreset -novtswitch -sharevts -displayfd 3 -nolisten tcp"}));
  for (const std::string& each : {file, file + ".log", file + ".log.old"}) std::filesystem::remove(each);
  if (!display->isThere()) return nullptr;
  const bool has_two = std::system(
                           "xrandr --addmode DUMMY1 1280x800 2>/dev/null && "
                           "xrandr --output DUMMY1 --mode 1280x800 --right-of DUMMY0 2>/dev/null") == 0;
  return has_two ? std::move(display) : nullptr;
}

std::string Display::hand(const std::string& words) const { return outputOf("xdotool " + words + " 2>/dev/null"); }

Image8 Display::photograph() const {
  // X's own format: a header of words, the most significant byte first, then rows of pixels, blue first.
  const std::string file = outputOf("xwd -root -silent");
  const auto word = [&](std::size_t index) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(file[4 * index + i]);
    return std::size_t(value);
  };
  if (file.size() < 100) return {};
  const std::size_t width = word(4), height = word(5), pixel_bytes = word(11) / 8, row_bytes = word(12);
  const std::size_t colors = word(19);
  const std::size_t begin = word(0) + 12 * colors;
  Image8 image(static_cast<int>(width), static_cast<int>(height), 3);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t channel = 0; channel < 3; ++channel)
        image.texel(int(x), int(y))[channel] =
            static_cast<std::uint8_t>(file[begin + y * row_bytes + pixel_bytes * x + 2 - channel]);
  return image;
}

}  // namespace mirrorball::testing
