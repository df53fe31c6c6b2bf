#pragma once

#include <utility>

namespace mirrorball::gl {

/// Whether this thread deletes no object now, since the context that holds them is not current (Deletion).
inline thread_local bool leaves_names = false;

/// Owns the name of one OpenGL object and deletes it with `destroy`. Movable, not copyable. It must be destroyed while
/// the context that made the object (or one sharing with it) is current, or under a Deletion (context.h).
template <void (*destroy)(unsigned name)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(unsigned name) : name_(name) {}
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Handle() {
    if (name_ != 0 && !leaves_names) destroy(name_);
  }

  unsigned name() const { return name_; }

 private:
  unsigned name_ = 0;
};

}  // namespace mirrorball::gl
