#include "mirrorball/render/frame/cube_capture.h"

#include <algorithm>
#include <utility>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {
namespace {

/// The picture of a cubeFaceCamera as the image of its face: without alpha, and with t = 0 in the first row.
void copyFace(const Image& picture, Image& face) {
  for (int y = 0; y < face.height(); ++y)
    for (int x = 0; x < face.width(); ++x) std::copy_n(picture.texel(x, face.height() - 1 - y), 3, face.texel(x, y));
}

}  // namespace

Result<EnvironmentMap> captureEnvironment(Renderer& renderer, const CaptureSettings& settings,
                                          const ProgressFunction& progress) {
  MIRRORBALL_TRY(faces, imagesFor(Projection::cube, settings.size));
  const DepthRange depths = depthsAround(settings.position, renderer.bounds(), settings.nearest);
  FrameSettings frame = settings.frame;
  frame.size = glm::ivec2(settings.size);
  frame.resolve = Resolve::radiance;
  if (frame.behind == BehindKind::screen) frame.behind = BehindKind::probes;  // a face does not show what is beside it
  for (int face = 0; face < faces.faces(); ++face) {
    const auto ofAllFaces = [&](std::size_t done, std::size_t of_face) {
      return progress(static_cast<std::size_t>(face) * of_face + done, 6 * of_face);
    };
    MIRRORBALL_TRY_VOID(renderer.draw(cubeFaceCamera(face, settings.position, depths), frame,
                                      progress ? ProgressFunction(ofAllFaces) : ProgressFunction()));
    MIRRORBALL_TRY(radiance, renderer.radiance());
    copyFace(radiance, faces.at(0, face));
  }
  return EnvironmentMap(Projection::cube, std::move(faces));
}

}  // namespace mirrorball
