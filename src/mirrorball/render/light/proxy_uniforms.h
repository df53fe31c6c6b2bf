#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/gl/uniform_block.h"
#include "mirrorball/render/light/ground_shadow.h"
#include "mirrorball/scene/proxy/proxy.h"

namespace mirrorball {

/// The sampler by which shaders read a proxy of that kind; empty: they need none.
std::string_view samplerOfProxy(ProxyKind kind);

/// Says where programs read a proxy; the same for all proxies of a device.
class ProxyConnection {
 public:
  static constexpr unsigned kPoint = 4;  ///< of the block, beside those of SurfacePrograms

  /// Of a program that has this kind's part.
  ///
  /// unit   of what it reads of a proxy's textures
  void connect(gl::Program& program, ProxyKind kind, int unit);
  /// Of the block alone, for a program that reads no textures of a proxy.
  void connectBlock(gl::Program& program);
  /// How the block lies in memory; null: no program that was connected has it.
  const std::shared_ptr<const gl::BlockLayout>& layout() const { return layout_; }

 private:
  std::shared_ptr<const gl::BlockLayout> layout_;
};

/// A proxy as the parts "proxy" of shaders read it (shaders/surface/proxy_block.glsl).
class ProxyUniforms {
 public:
  explicit ProxyUniforms(std::shared_ptr<ProxyConnection> connection = std::make_shared<ProxyConnection>())
      : connection_(std::move(connection)) {}

  /// Puts a proxy into a scene, unless it is there already.
  ///
  /// errors   as placedProxy's; too_large (its triangles for this driver)
  Result<void> place(const ProxyOptions& options, const Scene& scene);
  bool isOther(const ProxyOptions& options) const { return options_ != options; }
  /// Must be called when the scene is another one, whose shadow is, too.
  void forgetScene() {
    options_.reset();
    forgetShadow();
  }
  /// Must be called when the shadow is no more.
  void forgetShadow() {
    shadow_ = nullptr;
    block_.reset();
  }

  const Proxy& proxy() const { return proxy_; }

  /// The shadow that falls on the ground.
  ///
  /// irradiance   GroundLights::irradiance, in the unit of the environment's maps
  void setShadow(const GroundShadow& shadow, const glm::vec3& irradiance);

  ProxyConnection& connection() { return *connection_; }
  /// Makes it what programs read.
  ///
  /// unit   of its texture; below 0: the program reads none
  void bind(int unit);

 private:
  std::shared_ptr<ProxyConnection> connection_;
  std::optional<ProxyOptions> options_;  ///< that `proxy_` was made from
  Proxy proxy_;
  std::optional<gl::Texture> mesh_;
  std::optional<gl::UniformBlock> block_;
  const GroundShadow* shadow_ = nullptr;
  glm::vec3 ground_irradiance_{0.0f};
};

}  // namespace mirrorball
