#include "mirrorball/environment/environment.h"

#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {

glm::vec3 Environment::radiance(glm::vec3 direction) const {
  if (const EnvironmentMap* images = map()) return images->radiance(direction);
  return std::get<RadianceFunction>(light_)(direction);
}

std::uint64_t Environment::bytes() const {
  const EnvironmentMap* images = map();
  if (!images) return 0;
  const Image& face = images->face(0);
  return std::uint64_t(images->faces()) * face.samples().size_bytes();
}

int Environment::naturalSize(Projection projection) const {
  if (const EnvironmentMap* images = map()) return equivalentSize(images->projection(), images->size(), projection);
  return equivalentSize(Projection::equirect, panorama_height_, projection);
}

float Environment::texelDensity() const {
  if (const EnvironmentMap* images = map()) return mirrorball::texelDensity(images->projection(), images->size());
  return mirrorball::texelDensity(Projection::equirect, panorama_height_);
}

}  // namespace mirrorball
