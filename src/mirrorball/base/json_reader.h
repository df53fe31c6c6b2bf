#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "mirrorball/base/text.h"

namespace mirrorball {

/// What went wrong first while a JSON was read.
struct JsonProblem {
  std::string message;
  bool any() const { return !message.empty(); }
};

/// A value of a JSON with the key that leads to it, or the absence of one. What has another type than asked for is
/// noted in the shared problem, with its key, and answered by the default; so a whole file is read without a check at
/// every step, and refused once at the end.
class JsonReader {
 public:
  JsonReader(const nlohmann::json* value, std::string key, JsonProblem& problem)
      : value_(value), key_(std::move(key)), problem_(&problem) {}

  bool exists() const { return value_ != nullptr; }
  bool isArray() const { return value_ != nullptr && value_->is_array(); }
  const std::string& key() const { return key_; }

  /// The member of an object; absent where the object is.
  JsonReader operator[](const char* name) const {
    if (value_ != nullptr && !value_->is_object()) refuse("is no object");
    const nlohmann::json* member = nullptr;
    if (value_ != nullptr && value_->is_object()) {
      const auto found = value_->find(name);
      if (found != value_->end()) member = &*found;
    }
    return JsonReader(member, key_.empty() ? name : key_ + "." + name, *problem_);
  }

  /// The member that "a.b.c" leads to.
  JsonReader at(std::string_view path) const {
    JsonReader member = *this;
    while (!path.empty()) {
      const std::size_t end = std::min(path.find('.'), path.size());
      member = member[std::string(path.substr(0, end)).c_str()];
      path.remove_prefix(std::min(end + 1, path.size()));
    }
    return member;
  }

  /// The elements of an array; none where it is absent.
  std::vector<JsonReader> elements() const {
    std::vector<JsonReader> elements;
    if (value_ == nullptr) return elements;
    if (!value_->is_array())
      refuse("is no array");
    else
      for (const nlohmann::json& element : *value_)
        elements.emplace_back(&element, key_ + "[" + std::to_string(elements.size()) + "]", *problem_);
    return elements;
  }

  /// The members of an object with their names.
  std::vector<std::pair<std::string, JsonReader>> members() const {
    std::vector<std::pair<std::string, JsonReader>> members;
    if (value_ == nullptr) return members;
    if (!value_->is_object())
      refuse("is no object");
    else
      for (const auto& [name, member] : value_->items())
        members.emplace_back(name, JsonReader(&member, key_ + "." + excerpt(name), *problem_));
    return members;
  }

  /// A number, cut to ±1e30 so that it fits a float.
  double number(double otherwise) const {
    if (value_ == nullptr) return otherwise;
    if (!value_->is_number()) return refuse("is no number"), otherwise;
    const double number = value_->get<double>();
    return std::isnan(number) ? otherwise : std::fmin(std::fmax(number, -1e30), 1e30);
  }

  /// All numbers of an array of exactly `otherwise.size()`.
  std::vector<double> numbers(std::vector<double> otherwise) const {
    if (value_ == nullptr) return otherwise;
    const std::vector<JsonReader> given = elements();
    if (given.size() != otherwise.size())
      refuse("has not " + std::to_string(otherwise.size()) + " numbers");
    else
      for (std::size_t i = 0; i < given.size(); ++i) otherwise[i] = given[i].number(otherwise[i]);
    return otherwise;
  }

  /// A whole number from 0.
  std::size_t size(std::size_t otherwise) const {
    if (value_ == nullptr) return otherwise;
    // "4.0" is as good as "4": JSON does not tell them apart.
    if (value_->is_number_unsigned()) return value_->get<std::size_t>();
    const double number = value_->is_number() ? value_->get<double>() : -1.0;
    constexpr double kLargestExact = 9007199254740992.0;  // 2⁵³
    if (!(number >= 0.0) || number > kLargestExact || number != std::floor(number))
      return refuse("is no whole number from 0"), otherwise;
    return static_cast<std::size_t>(number);
  }

  /// An index; −1 where it is absent.
  int index() const {
    if (value_ == nullptr) return -1;
    const std::size_t value = size(0);
    if (value > std::size_t(std::numeric_limits<int>::max())) return refuse("is too large for an index"), -1;
    return static_cast<int>(value);
  }

  bool flag(bool otherwise) const {
    if (value_ == nullptr) return otherwise;
    if (!value_->is_boolean()) return refuse("is neither true nor false"), otherwise;
    return value_->get<bool>();
  }

  std::string text(std::string otherwise) const {
    if (value_ == nullptr) return otherwise;
    if (!value_->is_string()) return refuse("is no text"), otherwise;
    return value_->get<std::string>();
  }

  /// The same value, whose absence is a problem.
  const JsonReader& required() const {
    if (value_ == nullptr) refuse("is missing");
    return *this;
  }

  /// Notes that the value is wrong.
  void refuse(const std::string& what) const {
    if (!problem_->any()) problem_->message = (key_.empty() ? "the JSON" : key_) + " " + what;
  }

 private:
  const nlohmann::json* value_;
  std::string key_;
  JsonProblem* problem_;
};

}  // namespace mirrorball
