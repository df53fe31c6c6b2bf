#include "mirrorball/render/surface/depth_pass.h"

#include "mirrorball/gl/gl_api.h"

namespace mirrorball {

Result<DepthPass> DepthPass::make(gl::Api api) {
  MIRRORBALL_TRY(program, gl::Program::load(api, "back_faces.vert", "depth.frag"));
  return DepthPass(std::move(program));
}

void DepthPass::draw(const Scene& scene, int instance, const SceneBuffers& buffers, const Camera& camera,
                     Offset offset) {
  const Instance& drawn = scene.instances[std::size_t(instance)];
  program_.set("clip_from_world", camera.clip_from_view * camera.view_from_world);
  program_.set("world_from_object", drawn.world_from_object);
  program_.use();
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  const float sign = offset == Offset::farther ? 1.0f : -1.0f;
  glPolygonOffset(sign, 4.0f * sign);
  buffers.drawMesh(drawn.mesh);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace mirrorball
