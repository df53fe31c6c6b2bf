#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace mirrorball::testing {

/// Sets an environment variable, or none, for as long as it lives.
class VariableForTest {
 public:
  VariableForTest(std::string name, const std::optional<std::string>& value) : name_(std::move(name)) {
    if (const char* before = std::getenv(name_.c_str())) before_ = before;
    set(value);
  }
  ~VariableForTest() { set(before_); }
  VariableForTest(const VariableForTest&) = delete;
  VariableForTest& operator=(const VariableForTest&) = delete;

 private:
  void set(const std::optional<std::string>& value) const {
    if (value)
      ::setenv(name_.c_str(), value->c_str(), 1);
    else
      ::unsetenv(name_.c_str());
  }

  std::string name_;
  std::optional<std::string> before_;
};

}  // namespace mirrorball::testing
