#include "mirrorball/render/frame/turntable.h"

#include <array>

#include <glm/gtc/matrix_transform.hpp>

namespace mirrorball {
namespace {

const auto kTurntableOptions = std::to_array<Option<Turntable>>({
    {{.name = "frames",
      .value = "N",
      .minimum = 0,
      .maximum = 100000,
      .help = "number of pictures in a turntable, one full turn; %04d or #### in the output's name stands for the "
              "picture's number, which otherwise comes at the end; 0: a single picture",
      .group = "Picture"},
     &Turntable::frames},
    {{.name = "turn",
      .choices = "camera|model|environment",
      .help = "what turns in a turntable, from +Z towards +X; when the model turns, the lights and the background "
              "stand still",
      .group = "Picture"},
     choiceField<&Turntable::turn>},
});

}  // namespace

std::span<const Option<Turntable>> turntableOptions() { return kTurntableOptions; }

FrameSettings turned(FrameSettings settings, Turn what, float angle_deg) {
  switch (what) {
    case Turn::camera:
      settings.camera.azimuth_deg += angle_deg;
      break;
    case Turn::environment:
      settings.env_rotation_deg.x += angle_deg;
      break;
    case Turn::model: {
      // All else turned the other way looks the same, and leaves the scene as it is.
      settings.camera.azimuth_deg -= angle_deg;
      settings.env_rotation_deg.x -= angle_deg;
      const glm::vec3 axis = settings.camera.target.value_or(glm::vec3(0.0f));
      const glm::mat4 back = glm::rotate(glm::mat4(1.0f), -glm::radians(angle_deg), glm::vec3(0, 1, 0));
      for (PointLight& light : settings.lights)
        light.position = axis + glm::vec3(back * glm::vec4(light.position - axis, 0.0f));
      break;
    }
  }
  return settings;
}

}  // namespace mirrorball
