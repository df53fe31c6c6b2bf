#include "mirrorball/render/light/proxy_uniforms.h"

#include <utility>

namespace mirrorball {

std::string_view samplerOfProxy(ProxyKind kind) {
  if (kind == ProxyKind::mesh) return "proxy_mesh";
  return kind == ProxyKind::ground ? "ground_shadow" : std::string_view();
}

void ProxyConnection::connect(gl::Program& program, ProxyKind kind, int unit) {
  if (kind == ProxyKind::none) return;
  connectBlock(program);
  if (const std::string_view sampler = samplerOfProxy(kind); !sampler.empty()) program.set(sampler, unit);
}

void ProxyConnection::connectBlock(gl::Program& program) {
  const auto layout = program.connect("ProxyBlock", kPoint);
  if (layout && !layout_) layout_ = std::make_shared<gl::BlockLayout>(*layout);
}

Result<void> ProxyUniforms::place(const ProxyOptions& options, const Scene& scene) {
  if (options_ == options) return {};
  options_.reset();
  block_.reset();
  MIRRORBALL_TRY(placed, placedProxy(options, scene));
  mesh_.reset();
  if (placed.mesh) {
    MIRRORBALL_TRY(words, withName(options.file, gl::Texture::fromWords(placed.mesh->words)));
    mesh_ = std::move(words);
  }
  proxy_ = std::move(placed);
  options_ = options;
  return {};
}

void ProxyUniforms::setShadow(const GroundShadow& shadow, const glm::vec3& irradiance) {
  shadow_ = &shadow;
  ground_irradiance_ = irradiance;
  block_.reset();
}

void ProxyUniforms::bind(int unit) {
  if (proxy_.kind == ProxyKind::none || !connection_->layout()) return;
  if (!block_) {
    block_.emplace(connection_->layout());
    block_->set("captured_at", proxy_.captured_at);
    block_->set("proxy_ground", proxy_.ground);
    block_->set("proxy_center", proxy_.center);
    block_->set("proxy_radius", proxy_.radius);
    block_->set("proxy_low", proxy_.low);
    block_->set("proxy_high", proxy_.high);
    block_->set("ground_irradiance", ground_irradiance_);
    block_->set("shadow_area", shadow_ ? shadow_->area() : glm::vec3(0.0f, 0.0f, 1.0f));
  }
  block_->bind(ProxyConnection::kPoint);
  if (unit < 0) return;
  if (mesh_) mesh_->bind(unit);
  if (proxy_.kind == ProxyKind::ground && shadow_) shadow_->picture().bind(unit);
}

}  // namespace mirrorball
