#include "mirrorball/base/json_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <nlohmann/json.hpp>

#include "mirrorball/base/text.h"

namespace mirrorball {

bool JsonReader::isArray() const { return value_ != nullptr && value_->is_array(); }

bool JsonReader::isNumber() const { return value_ != nullptr && value_->is_number(); }

bool JsonReader::isNull() const { return value_ != nullptr && value_->is_null(); }

JsonReader JsonReader::operator[](const char* name) const {
  if (value_ != nullptr && !value_->is_object()) refuse("is no object");
  const nlohmann::json* member = nullptr;
  if (value_ != nullptr && value_->is_object()) {
    const auto found = value_->find(name);
    if (found != value_->end() && !found->is_null()) member = &*found;
  }
  return JsonReader(member, key_.empty() ? name : key_ + "." + name, *problem_);
}

JsonReader JsonReader::at(std::string_view path) const {
  JsonReader member = *this;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('.'), path.size());
    member = member[std::string(path.substr(0, end)).c_str()];
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return member;
}

JsonReader::Elements JsonReader::elements() const {
  if (value_ != nullptr && !value_->is_array()) refuse("is no array");
  return {*this, isArray() ? value_->size() : 0};
}

JsonReader JsonReader::Elements::operator[](std::size_t index) const {
  return {&(*array_.value_)[index], array_.key_ + "[" + std::to_string(index) + "]", *array_.problem_};
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
  std::vector<std::pair<std::string, JsonReader>> members;
  if (value_ == nullptr) return members;
  if (!value_->is_object())
    refuse("is no object");
  else
    for (const auto& [name, member] : value_->items())
      members.emplace_back(name, JsonReader(&member, key_ + "." + excerpt(name), *problem_));
  return members;
}

double JsonReader::number(double otherwise) const {
  if (value_ == nullptr) return otherwise;
  if (!value_->is_number()) return refuse("is no number"), otherwise;
  const double number = value_->get<double>();
  return std::isnan(number) ? otherwise : std::fmin(std::fmax(number, -1e30), 1e30);
}

std::vector<double> JsonReader::numbers(std::vector<double> otherwise) const {
  if (value_ == nullptr) return otherwise;
  const Elements given = elements();
  if (given.size() != otherwise.size())
    refuse("has not " + std::to_string(otherwise.size()) + " numbers");
  else
    for (std::size_t i = 0; i < given.size(); ++i) otherwise[i] = given[i].number(otherwise[i]);
  return otherwise;
}

std::size_t JsonReader::size(std::size_t otherwise) const {
  if (value_ == nullptr) return otherwise;
  // "4.0" is as good as "4": JSON does not tell them apart.
  if (value_->is_number_unsigned()) return value_->get<std::size_t>();
  const double number = value_->is_number() ? value_->get<double>() : -1.0;
  constexpr double kLargestExact = 9007199254740992.0;  // 2⁵³
  if (!(number >= 0.0) || number > kLargestExact || number != std::floor(number))
    return refuse("is no whole number from 0"), otherwise;
  return static_cast<std::size_t>(number);
}

int JsonReader::index() const {
  if (value_ == nullptr) return -1;
  const std::size_t value = size(0);
  if (value > std::size_t(std::numeric_limits<int>::max())) return refuse("is too large for an index"), -1;
  return static_cast<int>(value);
}

bool JsonReader::flag(bool otherwise) const {
  if (value_ == nullptr) return otherwise;
  if (!value_->is_boolean()) return refuse("is neither true nor false"), otherwise;
  return value_->get<bool>();
}

std::string JsonReader::text(std::string otherwise) const {
  if (value_ == nullptr) return otherwise;
  if (!value_->is_string()) return refuse("is no text"), otherwise;
  return value_->get<std::string>();
}

const JsonReader& JsonReader::required() const {
  if (value_ == nullptr) refuse("is missing");
  return *this;
}

void JsonReader::refuse(const std::string& what) const {
  if (!problem_->any()) problem_->message = (key_.empty() ? "the JSON" : key_) + " " + what;
}

}  // namespace mirrorball
