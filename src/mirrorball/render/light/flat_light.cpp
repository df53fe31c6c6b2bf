#include "mirrorball/render/light/flat_light.h"

#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/texture_target.h"

namespace mirrorball {

Result<gl::Texture> flattened(const gl::Texture& cube) {
  MIRRORBALL_TRY(flat, gl::Texture::make2d(cube.format(), 3 * cube.width(), 2 * cube.width(), cube.levels()));
  flat.setSampling({.filter = gl::Sampling::Filter::nearest});  // it is read by texels alone
  const gl::TextureTarget face_of_cube;
  flat.bind(0);
  for (int level = 0; level < cube.levels(); ++level) {
    const int side = levelSide(cube.width(), level);
    for (int face = 0; face < 6; ++face) {
      face_of_cube.bind(cube, level, face);
      glCopyTexSubImage2D(GL_TEXTURE_2D, level, face % 3 * side, face / 3 * side, 0, 0, side, side);
    }
  }
  return Result<gl::Texture>(std::move(flat));
}

Result<FlatLight> FlatLight::make(const EnvironmentLight& light, const gl::Texture& prefiltered) {
  MIRRORBALL_TRY(environment, flattened(light.cube()));
  MIRRORBALL_TRY(blurred, flattened(prefiltered));
  MIRRORBALL_TRY(irradiance, flattened(light.irradiance()));
  return FlatLight{std::move(environment), std::move(blurred), std::move(irradiance)};
}

}  // namespace mirrorball
