#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "formula/material.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/render/frame/picking.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/view/inspect/fresnel_curve.h"
#include "mirrorball/view/inspect/light_around.h"
#include "mirrorball/view/inspect/ray_path.h"

namespace mirrorball {

/// The surface under a pointer.
struct InspectedSurface {
  Picked picked;                          ///< its radiance is left to who has drawn the picture
  glm::vec3 geometric_normal{0.0f};       ///< world, unit, on the counter-clockwise side of the triangle
  std::string material_name;              ///< as the scene has it; empty: it has none
  formula::Material material;             ///< its numbers there: times what its textures hold
  bool is_inside = false;                 ///< the eye sees it from within a body
  float cosine = 0.0f;                    ///< of the angle between its normal on that side and the eye, 0 … 1
  FresnelCurve fresnel;                   ///< of the material, towards what is on its other side
  std::optional<RayPath> reflected = {};  ///< nothing: it reflects nothing
  std::optional<RayPath> refracted = {};  ///< nothing: it lets no light through, or reflects all
};

/// A fact as a face shows it, without knowing what it is about.
struct InspectionRow {
  std::string name;
  std::string value;
  std::string unit = {};
};

/// What is known of a place of a picture.
struct Inspection {
  std::optional<InspectedSurface> surface = {};  ///< nothing: the eye sees the environment
  std::optional<RayPath> behind = {};            ///< then that; a path without segments
  std::vector<InspectionRow> rows;
};

struct InspectorOptions {
  ReliefKind relief = ReliefKind::bump;  ///< FrameSettings::relief
  int most_segments = 16;                ///< of a path, 1 … 1024, or the nearest of these
};

/// Tells what a picture of a scene shows at its places, and where that light comes from. It needs no OpenGL: it may be
/// made, and asked, in any thread.
class Inspector {
 public:
  /// scene      prepared for that relief (prepareRelief), as frames show it
  /// progress   asked whether to go on, before and after
  /// errors     as Geometry::make's; interrupted
  /// cost       Geometry::make, which is not interrupted
  static Result<Inspector> make(std::shared_ptr<const Scene> scene, const InspectorOptions& options = {},
                                const ProgressFunction& progress = {});
  Inspector(Inspector&&) noexcept;
  Inspector& operator=(Inspector&&) noexcept;
  ~Inspector();

  const Scene& scene() const;

  /// The first surface that is seen there, as the path tracer finds it: of what lets a part of light through by its
  /// opacity all that is not wholly clear.
  ///
  /// camera     that the picture was drawn with (View::camera)
  /// size       of the picture [pixels]
  /// pixel      from its top left corner
  /// returns    nothing: the place is outside of the picture, or no number
  /// cost       0.13 ms on one core in a development build, and 1 µs for a further segment of a path; measured
  std::optional<Inspection> inspectedAt(const Camera& camera, glm::ivec2 size, glm::vec2 pixel,
                                        const LightAround& around) const;

 private:
  struct State;
  explicit Inspector(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace mirrorball
