#include "mirrorball/render/light/ground_shadow.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <utility>

#include "formula/bsdf.h"
#include "formula/grid_random.h"
#include "mirrorball/gl/gl_api.h"

namespace mirrorball {
namespace {

/// The share of light that a material lets through straight on: of thin glass, what two surfaces do not reflect.
glm::vec3 straightThrough(const Material& material) {
  if (material.transmission <= 0.0f || isBody(material)) return glm::vec3(0.0f);
  const float reflected = formula::fresnelDielectric(1.0f, material.ior);
  return material.transmission * (1.0f - reflected) * (1.0f - reflected) * material.base_color;
}

/// Whether light passes the backs of its triangles, as the eye does.
bool hasFrontsAlone(const Material& material) { return !material.double_sided && material.transmission <= 0.0f; }

/// The instances, what lets no light through straight on before what does: the first that is drawn decides.
std::vector<std::size_t> darkestFirst(const Scene& scene) {
  std::vector<std::size_t> order(scene.instances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t i) { return straightThrough(materialOf(scene, i)) == glm::vec3(0.0f); });
  return order;
}

}  // namespace

std::vector<CoarseMesh> shadowCasters(const Scene& scene) {
  constexpr std::size_t kTriangles = 1000;
  std::vector<CoarseMesh> casters;
  for (const Mesh& mesh : scene.meshes) casters.push_back(coarseMesh(mesh, kTriangles));
  return casters;
}

Result<GroundShadow> GroundShadow::make(gl::Api api, const std::vector<CoarseMesh>& casters) {
  MIRRORBALL_TRY(program, gl::Program::load(api, "ground_shadow.vert", "ground_shadow.frag"));
  constexpr std::array<std::string_view, 1> kLinear{"TONE_MAP 4"};  // sums of shares, not of a display's light
  MIRRORBALL_TRY(add, gl::Program::load(api, "screen.vert", "accumulate.frag", kLinear));
  // Of 256 equal shares half floats would lose up to 4 %; OpenGL ES blends and filters no others.
  const gl::Format format = api == gl::Api::desktop43 ? gl::Format::rgba32f : gl::Format::rgba16f;
  MIRRORBALL_TRY(framebuffer, gl::Framebuffer::make(format, kSize, kSize, gl::Depths::alone));
  if (format == gl::Format::rgba32f) framebuffer.filterSingleFloats();
  GroundShadow shadow(std::move(program), std::move(add), std::move(framebuffer));
  for (const CoarseMesh& coarse : casters) {
    constexpr gl::Attribute kPosition{0, 3, 0};
    shadow.casters_.push_back(
        {gl::VertexArray(gl::Buffer(coarse.positions), sizeof(glm::vec3), {&kPosition, 1}, gl::Buffer(coarse.indices)),
         coarse.indices.size()});
  }
  return Result<GroundShadow>(std::move(shadow));
}

glm::vec3 GroundShadow::areaAround(const BoundingSphere& bounds) {
  return {bounds.center.x, bounds.center.z, kModelRadii * bounds.radius};
}

Result<void> GroundShadow::addLight(const Image& caustics) {
  MIRRORBALL_TRY(picture, gl::Texture::fromImages(gl::Format::rgba32f, ImageSet(caustics)));
  framebuffer_.bind();
  gl::drawOverAll();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
  picture.bind(0);
  add_.set("picture", 0);
  add_.set("share", 1.0f);
  add_.set("as_displayed", 0.0f);
  add_.use();
  screen_.draw(3);
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);
  return {};
}

void GroundShadow::draw(const Scene& scene, const BoundingSphere& bounds, const Proxy& ground,
                        const GroundLights& lights) {
  area_ = areaAround(bounds);
  framebuffer_.bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glFrontFace(GL_CCW);  // of what faces the ground, as seen from below it: x to the right, z upwards
  // Each light draws nearer than those before it and all of it equally near: so it counts once, however many triangles
  // are in its way.
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  program_.set("ground", ground.ground);
  const std::vector<std::size_t> order = darkestFirst(scene);
  const auto count = static_cast<float>(lights.lights.size());
  float drawn = 0.0f;
  for (const GroundLight& light : lights.lights) {
    // The texels of each light lie elsewhere, by less than one: so the lights of a sun smooth the edge of its shadow.
    const glm::vec2 offset = glm::vec2(formula::gridRandom({int(drawn), 0, 0})) - 0.5f;
    program_.set("area", area_ + glm::vec3(offset * (2.0f * area_.z / float(kSize)), 0.0f));
    program_.set("towards_light", light.direction);
    program_.set("depth", 1.0f - 2.0f * ++drawn / (count + 1.0f));
    for (const std::size_t i : order) {
      if (hasFrontsAlone(materialOf(scene, i)))
        glEnable(GL_CULL_FACE);
      else
        glDisable(GL_CULL_FACE);
      program_.set("missing", light.share * (1.0f - straightThrough(materialOf(scene, i))));
      program_.set("world_from_object", scene.instances[i].world_from_object);
      const Caster& caster = casters_[std::size_t(scene.instances[i].mesh)];
      caster.vertices.drawIndexed(caster.index_count);
    }
  }
  glDisable(GL_BLEND);
}

}  // namespace mirrorball
