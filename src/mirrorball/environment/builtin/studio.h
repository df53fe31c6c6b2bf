#pragma once

#include <glm/vec3.hpp>

namespace mirrorball {

/// The radiance of the built-in environment "studio": a photographer's, dark, with a backdrop that is lit behind the
/// model, five soft boxes, and a satin floor in which they show. It is made for a camera at azimuth 30°, elevation 15°,
/// and shows something to a mirror from every side. Lamps are at most 7, a white ball shows 0.15 to 1.1, and the mean
/// over all directions is 0.5; all is grey but for a slightly warm key light and slightly cool ones at the right.
///
/// direction  unit
glm::vec3 studioRadiance(glm::vec3 direction);

}  // namespace mirrorball
