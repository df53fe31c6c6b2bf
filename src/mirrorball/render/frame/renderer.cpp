#include "mirrorball/render/frame/renderer.h"

#include <utility>

namespace mirrorball {

Result<Renderer> Renderer::headless() {
  MIRRORBALL_TRY(context, gl::Context::createHeadless());
  return on(std::move(context));
}

Result<Renderer> Renderer::on(gl::Context context) {
  MIRRORBALL_TRY(device, Device::on(std::move(context)));
  return Renderer(Stage(device));
}

}  // namespace mirrorball
