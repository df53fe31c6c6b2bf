#include "in_child.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <string>

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirrorball::bench {
namespace {

void writeAll(int file, const std::vector<double>& values) {
  const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
  const std::size_t size = values.size() * sizeof(double);
  for (std::size_t done = 0; done < size;) {
    const ssize_t written = write(file, bytes + done, size - done);
    if (written <= 0) return;
    done += static_cast<std::size_t>(written);
  }
}

std::vector<double> readAll(int file) {
  std::vector<std::byte> bytes;
  std::array<std::byte, 65536> piece;
  for (ssize_t got = 0; (got = read(file, piece.data(), piece.size())) > 0;)
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + got);
  std::vector<double> values(bytes.size() / sizeof(double));
  std::copy_n(bytes.begin(), values.size() * sizeof(double), reinterpret_cast<std::byte*>(values.data()));
  return values;
}

/// A line of /proc/self/status [kB].
double statusOf(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == key + ":") {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes;
    }
  return 0.0;
}

}  // namespace

std::vector<double> inChild(const std::function<std::vector<double>()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    writeAll(ends[1], work());
    _exit(0);
  }
  close(ends[1]);
  std::vector<double> values = readAll(ends[0]);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return values;
}

double memoryTakenBy(const std::function<void()>& work) {
  // What was freed goes back, or `work` would find memory that counts as taken already.
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // the peak becomes what is resident now
  const double before = statusOf("VmRSS");
  work();
  return (statusOf("VmHWM") - before) / 1024.0;
}

}  // namespace mirrorball::bench
