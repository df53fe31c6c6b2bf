#include "mirrorball/base/unnamed_output.h"

#include <functional>
#include <map>
#include <utility>

namespace mirrorball {
namespace {

std::map<std::string, UnnamedOutput*, std::less<>>& outputs() {
  static std::map<std::string, UnnamedOutput*, std::less<>> by_name;
  return by_name;
}

}  // namespace

UnnamedOutput::UnnamedOutput(std::string name) : name_(std::move(name)) { outputs()[name_] = this; }

UnnamedOutput::~UnnamedOutput() { outputs().erase(name_); }

UnnamedOutput* UnnamedOutput::find(std::string_view name) {
  const auto found = outputs().find(name);
  return found == outputs().end() ? nullptr : found->second;
}

}  // namespace mirrorball
