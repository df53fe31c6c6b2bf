#include "mirrorball/render/stage/device.h"

#include <utility>

#include "mirrorball/base/parallel.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/render/surface/brdf_texture.h"

namespace mirrorball {
namespace {

void endDevice(Device::State* state) {
  const gl::Deletion deletion(state->context);
  (void)state->context.leave();  // fails where the deletion leaves all as it is
  delete state;
}

}  // namespace

Result<void> Device::State::prepare() {
  if (depth_pass_) return {};
  if (!surfaces_) {
    if (brdf_table_.valid()) table_ = brdf_table_.get();
    if (!table_) return tl::unexpected<Error>(table_.error());
    MIRRORBALL_TRY(made, SurfacePrograms::make(context.api(), *table_));
    surfaces_ = std::move(made);
  }
  MIRRORBALL_TRY(depth_pass, DepthPass::make(context.api()));
  depth_pass_ = std::move(depth_pass);
  return {};
}

Result<Device> Device::headless() {
  MIRRORBALL_TRY(context, gl::Context::createHeadless());
  return on(std::move(context));
}

Result<Device> Device::on(gl::Context context) {
  MIRRORBALL_TRY_VOID(context.enter());
  std::future<Result<Image>> brdf_table = std::async(besideOthers(), surfaceBrdfTable);
  return Device(std::shared_ptr<State>(new State(std::move(context), std::move(brdf_table)), endDevice));
}

std::string Device::driver() const { return state_->context.renderer(); }

Result<void> Device::leave() const { return state_->context.leave(); }

}  // namespace mirrorball
