#include "mirrorball/render/frame/cube_capture.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "mirrorball/base/progress.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {
namespace {

/// The picture of a cubeFaceCamera as the image of its face: without alpha, and with t = 0 in the first row.
void copyFace(const Image& picture, Image& face) {
  for (int y = 0; y < face.height(); ++y)
    for (int x = 0; x < face.width(); ++x) std::copy_n(picture.texel(x, face.height() - 1 - y), 3, face.texel(x, y));
}

/// Draws the faces.
Result<EnvironmentMap> captureCube(Renderer& renderer, const CaptureSettings& settings, int side,
                                   const ProgressFunction& progress) {
  MIRRORBALL_TRY(faces, imagesFor(Projection::cube, side));
  const DepthRange depths = depthsAround(settings.position, renderer.bounds(), settings.nearest);
  FrameSettings frame = settings.frame;
  frame.size = glm::ivec2(side);
  frame.resolve = Resolve::radiance;
  // A face does not show what is beside it. No frame is drawn whose programs could draw the faces, too, as they do
  // those of probes (SampleUniforms::has_empty_screen); programs without a screen are smaller.
  if (frame.behind == BehindKind::screen) frame.behind = BehindKind::probes;
  const auto samples = static_cast<std::size_t>(frame.samples);
  for (int face = 0; face < faces.faces(); ++face) {
    MIRRORBALL_TRY_VOID(renderer.draw(cubeFaceCamera(face, settings.position, depths), frame,
                                      partOf(progress, std::size_t(face) * samples, samples, 6 * samples)));
    MIRRORBALL_TRY(radiance, renderer.radiance());
    copyFace(radiance, faces.at(0, face));
  }
  return EnvironmentMap(Projection::cube, std::move(faces));
}

/// "0,1.25,-3": with as many digits as one would type.
std::string shortText(glm::vec3 place) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.3g,%.3g,%.3g", double(place.x), double(place.y), double(place.z));
  return text.data();
}

}  // namespace

Result<EnvironmentMap> captureEnvironment(Renderer& renderer, const CaptureSettings& settings,
                                          const ProgressFunction& progress) {
  if (settings.to == Projection::cube) return captureCube(renderer, settings, settings.size, progress);
  const auto samples = static_cast<std::size_t>(settings.frame.samples);
  const int side = cubeSideFor(texelDensity(settings.to, settings.size));
  MIRRORBALL_TRY(cube, captureCube(renderer, settings, side, partOf(progress, 0, 6 * samples, 7 * samples)));
  return convert(Environment(std::move(cube)), settings.to, settings.size, {},
                 partOf(progress, 6 * samples, samples, 7 * samples));
}

std::optional<std::string> doubtOfPlace(glm::vec3 position, const BoundingSphere& scene) {
  constexpr float kFar = 10.0f;  // from there it fills less than 0.3 % of all directions
  if (glm::length(position - scene.center) <= kFar * scene.radius) return std::nullopt;
  std::array<char, 32> radius;
  std::snprintf(radius.data(), radius.size(), "%.3g", double(scene.radius));
  return shortText(position) + " is far outside of the scene, which lies within " + radius.data() + " units of " +
         shortText(scene.center) + "; the map hardly shows it";
}

}  // namespace mirrorball
