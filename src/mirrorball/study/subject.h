#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/settings/quality.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/trace/path_tracer.h"

namespace mirrorball {

/// One way to make a picture. What it sets is written as a user writes options, without dashes: "mapping=sphere".
struct Technique {
  enum class Maker { renderer, path_tracer };

  std::string_view name;             ///< "sphere map"
  std::string_view settings = {};    ///< of frameOptions(), or of traceOptions() where paths are traced
  std::string_view parameters = {};  ///< of all materials (materialParameters())
  Maker maker = Maker::renderer;
  Quality quality = Quality::draft;  ///< fills in what `settings` do not say
};

/// One number that changes from picture to picture of a subject.
struct Series {
  std::string_view axis;  ///< "perceptual roughness"
  std::span<const double> values;
  void (*change)(double value, Scene& scene, FrameSettings& frame);
  bool is_of_any_scene;         ///< else of the built-in one alone
  bool changes_shapes = false;  ///< the meshes or where they are, not only materials and the camera
};

/// A question that is put to a scene: each technique's picture against the right one.
struct Subject {
  std::string_view id;                       ///< "look-up"
  std::string_view title;                    ///< a few words
  std::string_view teaches;                  ///< a plain sentence or two
  std::span<const std::string_view> models;  ///< built-in ones that show it
  std::string_view material = {};            ///< of materialNames(), for those; empty: their own
  std::string_view view = {};                ///< of those, of frameOptions()
  std::string_view parameters = {};          ///< of those, of all materials (materialParameters() and materialMaps())
  std::string_view shows = {};      ///< what it is compared with, of frameOptions(), of any scene: "relief=exact"
  std::string_view reference = {};  ///< what it is compared with, of traceOptions(); empty: all bounces
  std::string_view compared_with;   ///< that in words: "all bounces"
  std::span<const Technique> techniques;
  std::optional<Series> series = {};
  bool by_angle = false;                ///< the error is also shown over n·v; the series changes materials alone
  bool (*applies)(const Scene& scene);  ///< to a scene that is not built for it
};

/// All subjects, in the order in which a page has them.
std::span<const Subject> subjects();

/// Sets options of a table from words "name=value" with spaces between.
///
/// errors   usage (no such name or value)
Result<void> applySettings(std::string_view settings, FrameSettings& frame);
Result<void> applySettings(std::string_view settings, TraceSettings& trace);
/// The names of the options that such a text sets.
std::set<std::string_view> namesOfSettings(std::string_view settings);
/// Sets parameters of all of a scene's materials likewise.
Result<void> applyParameters(std::string_view parameters, Scene& scene);

}  // namespace mirrorball
