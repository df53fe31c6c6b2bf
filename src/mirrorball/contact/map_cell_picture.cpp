#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/codec/color/automatic_exposure.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/contact/cell_picture.h"
#include "mirrorball/environment/convert/convert_rows.h"
#include "mirrorball/environment/file/large_panorama.h"

namespace mirrorball {
namespace {

/// A panorama of a map, and what its file holds.
struct SmallPanorama {
  Image light;
  std::string facts = {};
  std::vector<std::string> files = {};
};

Result<SmallPanorama> convertedByRows(const PanoramaRows& panorama, int height, const ProgressFunction& progress) {
  const RowReader::Description& picture = panorama.rows->description();
  MIRRORBALL_TRY(images, imagesFor(Projection::equirect, height));
  MIRRORBALL_TRY_VOID(convertRows(*panorama.rows, memoryLimit(), Projection::equirect, height,
                                  {.source_from_target = panorama.picture_from_world}, copyInto(images), progress));
  return SmallPanorama{
      std::move(images.at(0, 0)), sizeText({picture.width, picture.height}) + " equirect", {picture.name}};
}

Result<SmallPanorama> convertedWhole(const std::string& input, int height, const EnvironmentLoadOptions& options,
                                     std::vector<std::string>& notes, const Observer& observer,
                                     const ProgressFunction& progress) {
  MIRRORBALL_TRY(loaded, loadRepaired(input, options, notes, progress));
  tellAbout(loaded, observer);
  MIRRORBALL_TRY(map, convert(loaded.environment, Projection::equirect, height, {}, progress));
  const auto& form = loaded.recognition;
  return SmallPanorama{std::move(map.face(0)),
                       form ? sizeText(loaded.file_size) + " " + textOf(form->form.projection) : loaded.format,
                       std::move(loaded.files)};
}

/// "+1.3 EV"
std::string exposureWords(float exposure_ev) {
  char text[32];
  // Without the sign of what is rounded to 0.
  std::snprintf(text, sizeof(text), "%+.1f EV", double(std::round(exposure_ev * 10.0f) / 10.0f + 0.0f));
  return text;
}

}  // namespace

Result<LoadedEnvironment> loadRepaired(const std::string& input, const EnvironmentLoadOptions& options,
                                       std::vector<std::string>& notes, const ProgressFunction& progress) {
  EnvironmentLoadOptions repairing = options;
  repairing.repair = true;
  MIRRORBALL_TRY(loaded, loadEnvironment(input, repairing, progress));
  if (loaded.bad_texels.count > 0)
    notes.push_back(input + ": " + textOf(loaded.bad_texels) + "; shown is the mean of their neighbours");
  return loaded;
}

Result<CellPicture> mapCellPicture(const std::string& input, int width_px, const ContactSettings& settings,
                                   const Observer& observer, const ProgressFunction& progress) {
  MIRRORBALL_TRY(hint, formHintNamed(settings.from));
  const EnvironmentLoadOptions options{.from = hint};
  const int height = width_px / 2;
  CellPicture cell;
  std::optional<SmallPanorama> small;
  MIRRORBALL_TRY(panorama, openLargePanorama(input, options));
  if (panorama) {
    auto by_rows = convertedByRows(*panorama, height, progress);
    if (!by_rows && by_rows.error().code != ErrorCode::non_finite) return fail(std::move(by_rows));
    if (by_rows) {
      tellAbout(*panorama, input, observer);
      small = std::move(*by_rows);
    }
  }
  if (!small) {
    MIRRORBALL_TRY(whole, convertedWhole(input, height, options, cell.notes, observer, progress));
    small = std::move(whole);
  }
  Display display = settings.frame.display;
  display.exposure_ev = settings.exposure_ev.value_or(automaticExposure(small->light));
  showOn(display, small->light);
  cell.picture = pictureFromLinear(small->light, 3);
  cell.facts = small->facts + ", " + exposureWords(display.exposure_ev);
  cell.files = std::move(small->files);
  return cell;
}

}  // namespace mirrorball
