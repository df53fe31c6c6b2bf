#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "mirrorball/scene/animation/rig.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Gives what animations move the values of a time.
class TargetValues {
 public:
  /// nodes   as they are at rest
  TargetValues(Scene& scene, std::vector<RigNode>& nodes) : scene_(scene), nodes_(nodes) {}

  /// Sets what a channel's target is, from as many numbers as it has. What the scene has not stays unset.
  void set(const AnimationTarget& target, std::span<const double> value);

  /// After all channels: colours times their strengths.
  void finish();

 private:
  void set(const NodeTarget& target, std::span<const double> value);
  void set(const ParameterTarget& target, std::span<const double> value);
  void set(const TextureTarget& target, std::span<const double> value);
  void set(const LightTarget& target, std::span<const double> value);
  void set(const LampTarget& target, std::span<const double> value);
  void set(const LensTarget& target, std::span<const double> value);

  struct Light {
    glm::vec3 color;
    float strength;
  };

  Scene& scene_;
  std::vector<RigNode>& nodes_;
  std::map<std::pair<LightTarget::Of, int>, Light> lights_;
};

}  // namespace mirrorball
