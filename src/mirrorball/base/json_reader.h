#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

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
  bool isArray() const;
  bool isNumber() const;
  bool isNull() const;  ///< an element; a member that is null counts as absent
  const std::string& key() const { return key_; }

  /// The member of an object; absent where the object is, and where it is null, as programs write who have no value.
  JsonReader operator[](const char* name) const;

  /// The member that "a.b.c" leads to.
  JsonReader at(std::string_view path) const;

  /// The elements of an array, made as they are asked for; none where it is absent.
  class Elements;
  Elements elements() const;

  /// The members of an object with their names.
  std::vector<std::pair<std::string, JsonReader>> members() const;

  /// A number, cut to ±1e30 so that it fits a float.
  double number(double otherwise) const;

  /// All numbers of an array of exactly `otherwise.size()`.
  std::vector<double> numbers(std::vector<double> otherwise) const;

  /// A whole number from 0.
  std::size_t size(std::size_t otherwise) const;

  /// An index; −1 where it is absent.
  int index() const;

  bool flag(bool otherwise) const;

  std::string text(std::string otherwise) const;

  /// The same value, whose absence is a problem.
  const JsonReader& required() const;

  /// Notes that the value is wrong.
  void refuse(const std::string& what) const;

 private:
  const nlohmann::json* value_;
  std::string key_;
  JsonProblem* problem_;
};

class JsonReader::Elements {
 public:
  class Iterator {
   public:
    Iterator(const Elements& elements, std::size_t index) : elements_(&elements), index_(index) {}
    JsonReader operator*() const { return (*elements_)[index_]; }
    Iterator& operator++() { return ++index_, *this; }
    bool operator!=(const Iterator& other) const { return index_ != other.index_; }

   private:
    const Elements* elements_;
    std::size_t index_;
  };

  Elements(JsonReader array, std::size_t size) : array_(std::move(array)), size_(size) {}

  std::size_t size() const { return size_; }
  JsonReader operator[](std::size_t index) const;
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

 private:
  JsonReader array_;
  std::size_t size_;  // 0 of what is not an array
};

}  // namespace mirrorball
