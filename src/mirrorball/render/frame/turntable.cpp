#include "mirrorball/render/frame/turntable.h"

#include <array>
#include <string>
#include <string_view>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/base/text.h"
#include "mirrorball/render/light/probe_places.h"

namespace mirrorball {
namespace {

constexpr std::array<std::string_view, 3> kTurns{"camera", "model", "environment"};  // by Turn

constexpr ParsedField<Turntable> kTurn{
    [](const Turntable& turntable) {
      return turntable.turn == Turn::object ? std::to_string(turntable.object)
                                            : std::string(kTurns[static_cast<std::size_t>(turntable.turn)]);
    },
    [](const OptionText& text, std::string_view written, Turntable& turntable) -> Result<void> {
      if (const auto index = indexOfName(written, kTurns)) {
        turntable.turn = static_cast<Turn>(*index);
        return {};
      }
      const auto object = parseInteger(text, written);
      if (!object) return misused(text, join(kTurns) + " or an object's number", written);
      turntable.turn = Turn::object;
      turntable.object = *object;
      return {};
    }};

const auto kTurntableOptions = std::to_array<Option<Turntable>>({
    {{.name = "frames",
      .value = "N",
      .minimum = 0,
      .maximum = 100000,
      .help = "number of pictures of one full turn of a turntable, or with {option:animation} and no time over its "
              "length, the last one step before its end so that a loop closes, while the camera stands still unless "
              "{option:turn} is used; %04d or #### in the output's name stands for the picture's number, which "
              "otherwise comes at the end; 0: a single picture",
      .group = "Picture",
      .is_daily = true},
     &Turntable::frames},
    {{.name = "turn",
      .value = "camera|model|environment|N",
      .minimum = 1,
      .maximum = 1000000,
      .help = "what turns in a turntable, from +Z towards +X; when the model turns, the lights and the background "
              "stand still; N: the model's object of that number goes round with what lies in it, and all else stands "
              "still",
      .group = "Picture"},
     kTurn},
});

}  // namespace

std::span<const Option<Turntable>> turntableOptions() { return kTurntableOptions; }

FrameSettings turned(FrameSettings settings, Turn what, float angle_deg, const BoundingSphere& bounds) {
  switch (what) {
    case Turn::camera:
      settings.camera.azimuth_deg += angle_deg;
      break;
    case Turn::object:
      break;
    case Turn::environment:
      settings.env_rotation_deg.x += angle_deg;
      break;
    case Turn::model: {
      // All else turned the other way looks the same, and leaves the scene as it is.
      settings.camera.azimuth_deg -= angle_deg;
      settings.env_rotation_deg.x -= angle_deg;
      const glm::dvec3 axis = settings.camera.target.value_or(bounds.inFile(bounds.center));
      const glm::mat4 back = glm::rotate(glm::mat4(1.0f), -glm::radians(angle_deg), glm::vec3(0, 1, 0));
      for (PointLight& light : settings.lights)
        light.position = axis + glm::dvec3(back * glm::vec4(light.position - axis, 0.0f));
      break;
    }
  }
  return settings;
}

bool turnsShadow(Turn what) { return what != Turn::camera; }

Result<FrameSettings> standingStill(FrameSettings settings, const Scene& scene, const BoundingSphere& bounds,
                                    const BoundingSphere& other_bounds) {
  const float radii = bounds.radius / other_bounds.radius;
  settings.camera.target = settings.camera.target.value_or(bounds.inFile(bounds.center));
  if (settings.camera.distance) *settings.camera.distance *= radii;
  if (settings.camera.orthographic_height) *settings.camera.orthographic_height *= radii;
  if (settings.proxy.kind == ProxyKind::ground) {
    MIRRORBALL_TRY(ground, placedProxy(settings.proxy, scene));
    settings.proxy.captured_at = bounds.inFile(ground.captured_at);
    settings.proxy.radius = ground.radius;
  }
  return settings;
}

std::vector<Instance> orbited(const Scene& scene, int instance, glm::vec3 axis, float angle_deg) {
  const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), glm::radians(angle_deg), glm::vec3(0, 1, 0));
  const glm::mat4 about_axis = glm::translate(glm::mat4(1.0f), axis) * turn * glm::translate(glm::mat4(1.0f), -axis);
  std::vector<Instance> instances = scene.instances;
  for (const int part : withParts(scene, instance)) {
    glm::mat4& world_from_object = instances[std::size_t(part)].world_from_object;
    world_from_object = about_axis * world_from_object;
  }
  return instances;
}

}  // namespace mirrorball
