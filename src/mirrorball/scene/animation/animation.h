#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/camera/model_camera.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball {

/// How a value goes from one key of an animation to the next.
enum class KeyInterpolation { step, linear, cubic_spline };

/// A value at some times. The numbers are shared, as files let several channels share them.
struct AnimationSampler {
  std::shared_ptr<const std::vector<float>> times;  ///< seconds, growing; at least one
  /// As many numbers at each time; of cubic splines the slope that arrives there, the value, and the slope that leaves.
  std::shared_ptr<const std::vector<float>> values;
  KeyInterpolation interpolation = KeyInterpolation::linear;

  /// How many numbers a value has.
  std::size_t components() const;
};

/// A node's place in its parent, or the weights of its mesh's morph targets.
struct NodeTarget {
  enum class Of { translation, rotation, scale, weights };
  int node;  ///< index into Rig::nodes
  Of of;
};

/// A number or colour of a material.
struct ParameterTarget {
  int material;  ///< index into Scene::materials
  const MaterialParameter* parameter;
};

/// The place of a material's texture.
struct TextureTarget {
  enum class Of { offset, scale, rotation };
  int material;
  TextureSlot Material::*slot;
  Of of;
};

/// One factor of a material's emission or of a lamp's light, of which each is a colour times a strength.
struct LightTarget {
  enum class Of { emission, lamp };
  Of of;
  int index;         ///< into Scene::materials, or Scene::lights
  bool is_strength;  ///< that is animated; else the colour is
  glm::vec3 color;   ///< at rest
  float strength;    ///< at rest
};

/// How far a lamp reaches, and a spot's cone.
struct LampTarget {
  enum class Of { range, inner_angle, outer_angle };
  int light;  ///< index into Scene::lights
  Of of;
};

/// What a camera shows; widths and heights are halves, as glTF has them.
struct LensTarget {
  enum class Of { fov, aspect, half_width, half_height, nearest };
  int camera;  ///< index into Scene::cameras
  Of of;
};

/// What of a scene an animation moves.
using AnimationTarget = std::variant<NodeTarget, ParameterTarget, TextureTarget, LightTarget, LampTarget, LensTarget>;

/// One value that an animation moves.
struct AnimationChannel {
  AnimationTarget target;
  AnimationSampler sampler;
};

/// An animation of a model's file.
struct Animation {
  std::string name;                        ///< of its scene's animations no two have the same
  float length_s = 0.0f;                   ///< up to the last key; before the first one values are as they are there
  std::vector<AnimationChannel> channels;  ///< no two have the same target
};

/// What a sampler's value is at a time, before the first key as there, and behind the last as there.
///
/// sampler      with a whole number of components, at least one
/// is_rotation  its values are quaternions x, y, z, w, which turn the short way and stay of unit length
/// value        gets the components
/// from         Khronos, "glTF 2.0 Specification" (ISO/IEC 12113:2022), appendix C
void sample(const AnimationSampler& sampler, double seconds, bool is_rotation, std::vector<double>& value);

}  // namespace mirrorball
