#include "mirrorball/render/surface/texture_coordinates.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "formula/surface.h"

namespace mirrorball {
namespace {

bool hasPictures(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return m.base_color_map.texture >= 0; });
}

Generated generatedBy(Texgen texgen) {
  switch (texgen) {
    case Texgen::object_linear:
      return Generated::object;
    case Texgen::eye_linear:
    case Texgen::light:
      return Generated::place;
    case Texgen::sphere:
      return Generated::sphere;
    case Texgen::normal:
      return Generated::normal;
    case Texgen::none:
    case Texgen::reflection:
      break;
  }
  return Generated::reflection;
}

/// A projector at the first light, that looks at the middle of the scene and just covers it; upright.
glm::mat4 projectorOf(const PointLight& light, const BoundingSphere& bounds) {
  const glm::vec3 position = bounds.inScene(light.position);
  const glm::vec3 away = bounds.center - position;
  const float distance = glm::length(away);
  const glm::vec3 forward = distance > 0.0f ? away / distance : glm::vec3(0.0f, 0.0f, -1.0f);
  const bool is_upright = std::abs(forward.y) < 0.9999f;
  const glm::vec3 above = is_upright ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, -1.0f);
  const glm::vec3 up = glm::normalize(above - forward * glm::dot(above, forward));
  // The tangent of the angle at which the sphere is seen; within it, a quarter of a turn.
  const float beyond = distance * distance - bounds.radius * bounds.radius;
  const float widening = beyond > bounds.radius * bounds.radius ? bounds.radius / std::sqrt(beyond) : 1.0f;
  return formula::projectorMatrix(position, forward, up, widening);
}

/// What is linear in a mode for a picture: from what its formula gives to OpenGL's coordinates.
glm::mat4 pictureFrame(const BoundingSphere& bounds, const Camera& camera, const FrameSettings& settings) {
  switch (settings.texgen) {
    case Texgen::eye_linear:
      return camera.view_from_world;
    case Texgen::reflection:
    case Texgen::normal:
      return glm::mat4(glm::mat3(camera.view_from_world));
    case Texgen::light:
      return projectorOf(settings.lights.front(), bounds);
    case Texgen::none:
    case Texgen::object_linear:
    case Texgen::sphere:
      break;
  }
  return glm::mat4(1.0f);
}

/// The same for the environment: to one of its directions.
glm::mat4 environmentFrame(const BoundingSphere& bounds, const Camera& camera, const FrameSettings& settings) {
  const glm::mat4 environment_from_world(settings.environmentFromWorld());
  switch (settings.texgen) {
    case Texgen::object_linear:
      return glm::mat4(1.0f);
    case Texgen::eye_linear:
      return camera.view_from_world;
    case Texgen::light:
      return environment_from_world *
             glm::translate(glm::mat4(1.0f), -bounds.inScene(settings.lights.front().position));
    default:
      return environment_from_world;
  }
}

/// From the formula's coordinates of reflected light.
///
/// texture_matrix   that wraps the environment
glm::mat4 lookUpMatrix(const CoordinateChoice& choice, const BoundingSphere& bounds, const Camera& camera,
                       const FrameSettings& settings, const glm::mat4& texture_matrix) {
  if (choice.is_sphere_map) {
    const bool is_of_normals = choice.look_up == Generated::normal;
    return is_of_normals ? texture_matrix * formula::sphereMapTextureMatrix(glm::mat3(camera.view_from_world))
                         : texture_matrix;
  }
  // Most often nothing is to be done; to multiply by a matrix and its inverse would round.
  const bool is_of_world = choice.look_up == Generated::reflection || choice.look_up == Generated::normal;
  if (is_of_world && texture_matrix == glm::mat4(1.0f)) return glm::mat4(1.0f);
  const glm::mat4 world_from_environment(glm::transpose(settings.environmentFromWorld()));
  return world_from_environment * texture_matrix * environmentFrame(bounds, camera, settings);
}

}  // namespace

std::string_view formulaOf(Generated generated) {
  constexpr std::string_view kFormulas[] = {"reflectionCoordinates", "normalCoordinates", "sphereCoordinates",
                                            "objectCoordinates", "placeCoordinates"};
  return kFormulas[static_cast<std::size_t>(generated)];
}

namespace {

/// A sphere map is addressed by a normal.
Generated lookedUpBy(Mapping mapping) {
  switch (mapping) {
    case Mapping::reflection:
      return Generated::reflection;
    case Mapping::normal:
    case Mapping::sphere:
      break;
  }
  return Generated::normal;
}

}  // namespace

CoordinateChoice coordinateChoice(const Scene& scene, const FrameSettings& settings) {
  const bool has_pictures = hasPictures(scene);
  const bool is_generated = settings.texgen != Texgen::none;
  CoordinateChoice choice;
  if (is_generated && !has_pictures) {
    choice.look_up = generatedBy(settings.texgen);
    choice.is_sphere_map = settings.texgen == Texgen::sphere;
  } else {
    choice.look_up = lookedUpBy(settings.mapping);
    choice.is_sphere_map = settings.mapping == Mapping::sphere;
  }
  if (!has_pictures) return choice;
  if (is_generated) {
    choice.picture = generatedBy(settings.texgen);
    choice.picture_from = settings.texgen == Texgen::light ? PictureFrom::projector : PictureFrom::generated;
  } else if (settings.texture_matrix != glm::mat4(1.0f)) {
    choice.picture_from = PictureFrom::transformed_mesh;
  }
  return choice;
}

Result<CoordinateMatrices> coordinateMatrices(const Scene& scene, const BoundingSphere& bounds, const Camera& camera,
                                              const FrameSettings& settings) {
  if (settings.texgen == Texgen::light && settings.lights.empty())
    return fail(ErrorCode::usage, "texture coordinates from a light's place need a light");
  const CoordinateChoice choice = coordinateChoice(scene, settings);
  const bool has_pictures = hasPictures(scene);
  const glm::mat4 rows = glm::transpose(settings.texture_matrix);
  if (rows[3] == glm::vec4(0.0f))
    return fail(ErrorCode::usage, "the texture matrix makes q 0 everywhere; its last row is most often 0,0,0,1");
  if (!has_pictures && glm::mat4x3(settings.texture_matrix) == glm::mat4x3(0.0f))
    return fail(ErrorCode::usage, "the texture matrix leaves no direction: its first three rows are 0");
  FrameSettings of_mapping = settings;
  if (has_pictures) of_mapping.texgen = Texgen::none;
  return CoordinateMatrices{
      lookUpMatrix(choice, bounds, camera, of_mapping, has_pictures ? glm::mat4(1.0f) : settings.texture_matrix),
      has_pictures ? settings.texture_matrix * pictureFrame(bounds, camera, settings) : glm::mat4(1.0f)};
}

}  // namespace mirrorball
