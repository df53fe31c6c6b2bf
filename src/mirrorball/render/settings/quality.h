#pragma once

#include <array>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// How much time a picture may take for what it shows.
enum class Quality { draft, good, best };

/// What somebody asks for.
struct QualityRequest {
  Quality quality = Quality::good;
};

/// The table of one row that sets it.
std::span<const Option<QualityRequest>> qualityOptions();

/// What of a scene says which techniques its picture needs.
struct SceneTraits {
  bool lets_light_through = false;
  bool is_polished = false;     ///< some surface mirrors
  bool has_objects = false;     ///< more than one
  bool hides_itself = false;    ///< some place sees less than nine tenths of the sky
  bool can_trace_rays = false;  ///< nothing moves but the whole
  bool has_strong_sun = false;  ///< hasStrongSun() of its environment
  bool is_huge = false;         ///< of more than four million triangles: nothing is looked for in it unasked
};

/// What materials and objects say of a scene; whether it hides itself is asked of rays (rays/seen_from.h).
SceneTraits traitsOf(const Scene& scene);

/// One option that a quality fills in.
struct QualityChoice {
  std::string_view option;                 ///< of frameOptions()
  std::array<std::string_view, 3> values;  ///< for each Quality as a user writes it; empty: what it is without
  bool (*suits)(const SceneTraits&);       ///< whether the scene needs it
  /// Options with which someone asks for a technique that this one would hide, or says already what this one says.
  std::span<const std::string_view> left_to = {};
  bool is_left_to_classics = false;  ///< and to a classic technique, which reflects the environment alone
};

/// All of them, in the order in which they are told.
std::span<const QualityChoice> qualityChoices();

/// Whether what is chosen depends on SceneTraits::hides_itself, which costs rays to find.
bool dependsOnHiding(Quality quality, SceneTraits traits, const std::set<std::string_view>& given,
                     const FrameSettings& settings);

/// Whether it depends on SceneTraits::has_strong_sun.
bool dependsOnSun(Quality quality, const std::set<std::string_view>& given, const FrameSettings& settings);

/// Fills in what a scene needs of what was not given, and what that implies: what is reflected by rays knows what
/// vertices know.
///
/// given     names of options that stay as they are
/// returns   what was chosen: "{option:refraction} auto {option:behind} screen"; empty: nothing
std::string fillIn(Quality quality, const SceneTraits& traits, const std::set<std::string_view>& given,
                   FrameSettings& settings);

}  // namespace mirrorball
