// Turns a built-in environment into a cube map in one picture, and asks two formulas a question.

#include <cstdio>
#include <filesystem>

#include "formula/formula.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/cube/cube_layout.h"

namespace {

mirrorball::Result<void> writeCross(const std::filesystem::path& path) {
  MIRRORBALL_TRY(environment, mirrorball::builtinEnvironment("white"));
  MIRRORBALL_TRY(cube, mirrorball::convert(environment, mirrorball::Projection::cube, 32));
  const mirrorball::Image cross = composeLayout(cube.images(), mirrorball::CubeLayout::hcross);
  MIRRORBALL_TRY_VOID(mirrorball::writeImage(path, cross));

  MIRRORBALL_TRY(decoded, mirrorball::readImage(path));
  const glm::vec3 front = mirrorball::rgbAt(decoded.image, 32 + 16, 32 + 16);
  std::printf("cross: %d x %d, front %g %g %g\n", decoded.image.width(), decoded.image.height(), front.r, front.g,
              front.b);
  return {};
}

}  // namespace

int main(int count, char** words) {
  const auto written = writeCross(count > 1 ? words[1] : "cross.exr");
  if (!written) {
    std::fprintf(stderr, "%s\n", written.error().message.c_str());
    return 1;
  }
  const glm::vec3 right(1.0f, 0.0f, 0.0f);
  std::printf("+X lies on face %d\n", mirrorball::formula::cubeFace(right));
  std::printf("glass reflects %.4f head on\n", mirrorball::formula::fresnelDielectric(1.0f, 1.0f / 1.5f));
  return 0;
}
