#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/contact/cell_picture.h"
#include "mirrorball/render/frame/render_inputs.h"

namespace mirrorball {

/// Pictures of models, one after the other, in one environment and by one driver.
class ModelCellPictures {
 public:
  /// Loads and prepares the environment, and starts the driver.
  ///
  /// size_px  of the pictures
  /// notes    gets lines about the environment
  /// errors   as loadEnvironment's and prepareEnvironment's; no_gl
  static Result<ModelCellPictures> make(const ContactSettings& settings, glm::ivec2 size_px,
                                        const std::optional<CacheFolder>& cache, const Observer& observer,
                                        std::vector<std::string>& notes);

  /// The picture that `render` makes of a model with the settings' quality, before the sheet's colour.
  ///
  /// facts    "12,345 triangles"
  /// errors   as loadScene's, chooseTechniques', checkFrame's and View::draw's
  /// cost     loading and preparing the model, and of a software driver compiling what shaders it needs first
  Result<CellPicture> picture(const std::string& model, const ProgressFunction& progress);

  /// That were read for the environment.
  const std::vector<std::string>& files() const { return files_; }

 private:
  ModelCellPictures(Renderer renderer, RenderInputNames names, TechniqueWishes choice, int largest_texture,
                    std::vector<std::string> files)
      : renderer_(std::move(renderer)),
        names_(std::move(names)),
        choice_(std::move(choice)),
        largest_texture_(largest_texture),
        files_(std::move(files)) {}

  Renderer renderer_;
  RenderInputNames names_;
  TechniqueWishes choice_;
  int largest_texture_;
  std::vector<std::string> files_;
};

}  // namespace mirrorball
