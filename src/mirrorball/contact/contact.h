#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/observer.h"
#include "mirrorball/contact/contact_settings.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// One of the inputs of a sheet.
struct ContactInput {
  std::string input;  ///< a map (loadEnvironment) or a model (loadModel), by a file's or a built-in's name
  std::string name;   ///< that is shown of it; its last part is, as far as that tells it from others
  bool is_model;      ///< isModelInput
};

/// A sheet, and what there is to know about it.
struct ContactSheet {
  Image8 picture;                  ///< 3 channels, encoded
  std::vector<std::string> files;  ///< that were read
  std::vector<std::string> notes;  ///< what is unusual about inputs, a line each
};

/// Whether an input is shown as a model: a built-in shape, a file that loadModel takes, or a name that ends as if it
/// were one.
///
/// cost     reading the begin of a file
bool isModelInput(const std::string& input);

/// A contact sheet: a cell for each input in their order, with its picture, its name and a line of facts. Maps are
/// panoramas of 2:1; where a model is among the inputs, cells are 4:3, and panoramas lie in their middle.
///
/// inputs    at least one
/// cache     where prefiltered environments and occlusion are kept; optional
/// observer  gets remarks about maps, and how many inputs are done ("contact")
/// failed    is called for each input that cannot be shown, whose cell says so, as soon as that is known
/// errors    usage; too_large (the sheet); interrupted; where models are to be shown, as their environment's and no_gl
/// cost      one input after the other, each on all cores
Result<ContactSheet> makeContactSheet(std::span<const ContactInput> inputs, const ContactSettings& settings,
                                      const std::optional<CacheFolder>& cache, const Observer& observer,
                                      const std::function<void(const Error&)>& failed);

}  // namespace mirrorball
