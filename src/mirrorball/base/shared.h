#pragma once

#include <atomic>
#include <memory>
#include <utility>

namespace mirrorball {

/// A value that is shared by its copies, so that what holds large ones is copied at once. Any thread may read it.
template <typename Value>
class Shared {
 public:
  Shared() : Shared(Value()) {}
  Shared(Value value) : value_(std::make_shared<Value>(std::move(value))) {}

  // Without moving, after which there would be no value.
  Shared(const Shared&) = default;
  Shared& operator=(const Shared&) = default;

  operator const Value&() const { return *value_; }
  const Value& operator*() const { return *value_; }
  const Value* operator->() const { return value_.get(); }

  /// To be changed, which other copies are not.
  Value& edit() {
    if (value_.use_count() > 1) value_ = std::make_shared<Value>(*value_);
    // What another thread has read before it gave up its copy is read before this one writes.
    std::atomic_thread_fence(std::memory_order_acquire);
    return *value_;
  }

  /// Whether they are copies of each other that have not been changed since.
  bool isSameAs(const Shared& other) const { return value_ == other.value_; }

 private:
  std::shared_ptr<Value> value_;
};

}  // namespace mirrorball
