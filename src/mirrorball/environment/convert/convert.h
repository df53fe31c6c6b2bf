#pragma once

#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// How light is looked up between texels, and how directions are turned.
struct Resampling {
  /// Interpolation between the source's texels, where the target is not much coarser.
  Interpolation interpolation = Interpolation::bicubic;
  /// Turns directions of the target into the source's: a rotation.
  glm::mat3 source_from_target{1.0f};
};

/// The rotation that moves +Z to a direction (unit) and keeps +Y as upright as possible; for straight up or down, +X
/// stays on the right. As `source_from_target` it puts that direction at a map's centre.
glm::mat3 centredOn(glm::vec3 direction);

/// A map turned by Euler angles: about +Z (+X towards +Y), then about +X (+Y towards +Z),
/// then about +Y (+Z towards +X).
///
/// returns  target_from_source; its transpose is a `source_from_target`
glm::mat3 turnedBy(float yaw_rad, float pitch_rad, float roll_rad);

/// The rotation that turns the light of a map as turnedBy does, as a `source_from_target`.
///
/// angles_deg  yaw, pitch, roll; those that are missing are 0
glm::mat3 sourceFromRotated(std::vector<float> angles_deg);

/// Converts an environment to another projection.
///
/// size     a face's side, a disc's diameter, a panorama's height; at least 1
/// returns  radiance at texel centres where a texel spans at most √2 texels of the source; else the mean over the
///          texel's area, taken at points no farther apart than the source's texels, with bilinear interpolation, so
///          that no light is lost or counted twice. Three channels; a disc has a fourth, alpha: 0 (and black) in texels
///          whose centre is outside it, else 1
/// errors   interrupted (when `progress` says so); too_large
/// cost     the texels of the target or of the source, whichever are more: about 15 ns each on one core;
///          bit-identical for any number of threads
Result<EnvironmentMap> convert(const Environment& source, Projection to, int size, const Resampling& resampling = {},
                               const ProgressFunction& progress = {});

/// Receives a rectangle of a converted map's texels: in image `face`, from texel `begin` on. Called from several
/// threads at a time, in any order; each texel of the map comes once.
using TakeTexels = std::function<Result<void>(int face, glm::ivec2 begin, const Image& texels)>;

/// The same without ever holding the whole map: texels are handed on while they are in a core's cache.
///
/// errors   interrupted; too_large; what `take` returns
Result<void> convertByStrips(const Environment& source, Projection to, int size, const Resampling& resampling,
                             const TakeTexels& take, const ProgressFunction& progress = {});

/// The channels of a converted map's texels: 4 where there is a disc, with alpha, else 3.
int convertedChannels(Projection projection);

/// Images for a map of that projection and size, whose texels have no values yet.
///
/// errors   too_large
Result<ImageSet> imagesFor(Projection projection, int size);

/// A function that copies texels into images, which must outlive it.
TakeTexels copyInto(ImageSet& images);

}  // namespace mirrorball
