#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// The parts of what is shown that change by themselves: bits of a set.
struct StagePart {
  static constexpr unsigned meshes = 1u << 0;      ///< and which of them there are, and with which material
  static constexpr unsigned transforms = 1u << 1;  ///< where they are
  static constexpr unsigned occlusion = 1u << 2;   ///< Instance::occlusion, vertex_materials and holes
  static constexpr unsigned materials = 1u << 3;   ///< anything of them
  static constexpr unsigned shapes = 1u << 4;  ///< what of materials is more than light on a surface: changesShape()
  static constexpr unsigned lights = 1u << 5;  ///< the scene's own
  static constexpr unsigned environment = 1u << 6;
  static constexpr unsigned scene = meshes | transforms | occlusion | materials | shapes | lights;
  static constexpr std::size_t count = 7;
};

/// When each part last changed. No two changes in a process have the same number, be they of one stage or of two.
class StageVersions {
 public:
  /// parts   of StagePart: they are others now
  void change(unsigned parts) {
    static std::atomic<std::uint64_t> last = 0;
    const std::uint64_t now = ++last;
    for (std::size_t part = 0; part < StagePart::count; ++part)
      if ((parts >> part & 1u) != 0) versions_[part] = now;
  }
  /// Another number than before if one of these parts has changed.
  std::uint64_t of(unsigned parts) const {
    std::uint64_t last = 0;
    for (std::size_t part = 0; part < StagePart::count; ++part)
      if ((parts >> part & 1u) != 0) last = std::max(last, versions_[part]);
    return last;
  }

 private:
  std::array<std::uint64_t, StagePart::count> versions_{};
};

/// A value that is computed from parts of a stage: made when it is first asked for, and again once one of those parts
/// has changed.
template <typename Value>
class Derived {
 public:
  /// from   the parts that it depends on
  explicit Derived(unsigned from) : from_(from) {}

  /// make   () → Value
  template <typename Make>
  Value& get(const StageVersions& versions, const Make& make) {
    if (!has(versions)) keep(versions, make());
    return *value_;
  }

  /// make   () → Result<Value>
  /// errors make's; then there is none
  template <typename Make>
  Result<Value*> tryGet(const StageVersions& versions, const Make& make) {
    if (!has(versions)) {
      value_.reset();  // first, since two may not have room
      auto made = make();
      if (!made) return fail(std::move(made));
      keep(versions, std::move(*made));
    }
    return &*value_;
  }

  /// Whether there is one of the parts as they are now.
  bool has(const StageVersions& versions) const { return value_ && version_ == versions.of(from_); }

  /// Keeps a value that was made elsewhere of the parts as they are now.
  void offer(const StageVersions& versions, Value value) { keep(versions, std::move(value)); }

  /// Gives the value away, if there is one of the parts as they are now.
  std::optional<Value> take(const StageVersions& versions) {
    return has(versions) ? std::exchange(value_, std::nullopt) : std::nullopt;
  }

 private:
  void keep(const StageVersions& versions, Value value) {
    value_.emplace(std::move(value));
    version_ = versions.of(from_);
  }

  unsigned from_;
  std::uint64_t version_ = 0;
  std::optional<Value> value_;
};

}  // namespace mirrorball
