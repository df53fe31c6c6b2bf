#include "mirrorball/render/surface/background.h"

#include <utility>

#include "formula/prefilter.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/surface/eye_ray.h"
#include "mirrorball/render/surface/surface_shaders.h"
#include "mirrorball/render/surface/texture_units.h"

namespace mirrorball {
namespace {

/// How rough a mirror would blur the environment as `--background blur` does.
constexpr float kBackgroundRoughness = 0.35f;

}  // namespace

glm::vec4 pageOf(const FrameSettings& settings) {
  const bool has_radiance = settings.background == BackgroundKind::radiance;
  return has_radiance ? glm::vec4(settings.background_color, 1.0f) : glm::vec4(0.0f);
}

Result<gl::ShaderSource> backgroundShader(gl::Api api, ProxyKind kind) {
  return withProxy(api, "background.frag", kind);
}

Result<void> Background::make(gl::Api api, ProxyUniforms& proxy) {
  const ProxyKind kind = proxy.proxy().kind;
  if (programs_.contains(kind)) return {};
  MIRRORBALL_TRY(vertex, gl::shaderSource(api, "screen.vert"));
  MIRRORBALL_TRY(fragment, backgroundShader(api, kind));
  MIRRORBALL_TRY(program, gl::Program::build(vertex, fragment, "screen.vert with background.frag"));
  program.set("environment", kFreeUnit);
  proxy.connection().connect(program, kind, kNextFreeUnit);
  programs_.emplace(kind, std::move(program));
  return {};
}

void Background::draw(const EnvironmentLight& light, const FrameUniforms& frame, const FrameSettings& settings) {
  gl::Program& program = programs_.find(settings.proxy.kind)->second;
  const bool blurred = settings.background == BackgroundKind::blur;
  glDisable(GL_CULL_FACE);
  // Blurred exactly it is one level of the prefiltered chain.
  const bool is_prefiltered = blurred && (settings.blur == BlurKind::exact || settings.blur == BlurKind::gpu);
  const PrefilteredChain& chain = frame.light.prefiltered;
  const gl::Texture& cube = is_prefiltered ? *chain.texture : light.cube();
  const bool reads_nearest = !is_prefiltered && settings.texture_filter == TextureFilter::nearest;
  cube.bind(kFreeUnit, reads_nearest ? &light.nearestSampler() : nullptr);
  frame.light.proxy->bind(kNextFreeUnit);
  program.set("environment_from_world", frame.light.environment_from_world);
  program.set("environment_intensity", settings.env_intensity * light.unit());
  setEyeRay(program, frame.sample.camera);
  program.set("texels_per_radian", texelDensity(Projection::cube, cube.width()));
  program.set("samples_per_pixel", static_cast<float>(settings.samples));
  program.set("texture_filter", static_cast<int>(settings.texture_filter));
  const float prefiltered_level = formula::lodOfRoughness(kBackgroundRoughness, static_cast<float>(chain.lastLevel())) -
                                  static_cast<float>(chain.first_level);
  program.set("min_level", is_prefiltered ? prefiltered_level : 0.0f);
  program.set("is_shadow_alone", static_cast<int>(!settings.showsEnvironment()));
  const SunUniforms& suns = frame.light.suns;
  program.set("sun_count", suns.are_seen ? static_cast<int>(suns.suns.size()) : 0);
  if (!suns.suns.empty()) program.set("sun_rows", std::span<const glm::vec4>(suns.rows()));
  program.set("sun_roughness", blurred ? kBackgroundRoughness : 0.0f);
  program.set("page", pageOf(settings));
  program.set("lobe_roughness", blurred && !is_prefiltered ? kBackgroundRoughness : 0.0f);
  screen_.draw(3);
}

}  // namespace mirrorball
