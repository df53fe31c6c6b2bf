#include "cli/rays.h"

#include <utility>

#include "cli/terminal.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/transfer/normal_space.h"

namespace mirrorball::cli {

Result<MadeMap> normalsOfModel(Image normals, const std::string& input, const SurfaceOptions& options) {
  const bool to_object = options.to == SurfaceMap::object_normal;
  MIRRORBALL_TRY(model, loadModel(options.model, {.inside_only = options.inside_only}));
  for (const std::string& warning : model.warnings) remark(warning);
  // What is wrong with the model is said under its name, before the map is looked at.
  MIRRORBALL_TRY(surface, withName(options.model, MappedSurface::make(model)));
  MIRRORBALL_TRY_VOID(withName(options.model, TexelCover::make(surface.uvTriangles(), {1, 1}, 1)));
  if (options.directx && to_object) flipGreen(normals);
  const NormalSpace space = to_object ? NormalSpace::object : NormalSpace::tangent;
  MIRRORBALL_TRY(turned, withName(input, normalsInSpace(normals, model, space, progressBar("normals"))));
  if (options.directx && !to_object) flipGreen(turned);
  return MadeMap{ImageSet(std::move(turned)), true};
}

}  // namespace mirrorball::cli
