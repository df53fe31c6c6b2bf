#include "mirrorball/contact/contact.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <utility>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/contact/cell_label.h"
#include "mirrorball/contact/cell_picture.h"
#include "mirrorball/contact/contact_sheet.h"
#include "mirrorball/contact/model_cell_pictures.h"
#include "mirrorball/metric/picture/plain_letters.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

glm::ivec2 pictureSize(std::span<const ContactInput> inputs, int width_px) {
  const bool has_models =
      std::any_of(inputs.begin(), inputs.end(), [](const ContactInput& each) { return each.is_model; });
  return {width_px, has_models ? 3 * width_px / 4 : width_px / 2};
}

/// Moves all of a list to the end of another.
void append(std::vector<std::string> more, std::vector<std::string>& list) {
  std::move(more.begin(), more.end(), std::back_inserter(list));
}

/// The names below the cells. One that the letters of a sheet cannot write is found by its number.
std::vector<std::string> namesBelow(std::span<const ContactInput> inputs, std::vector<std::string>& notes) {
  std::vector<std::string> names;
  for (const ContactInput& each : inputs) names.push_back(each.name);
  std::vector<std::string> labels = cellLabels(names);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels[i] = printable(labels[i]);
    if (hasPlainLetters(labels[i])) continue;
    const std::string number = std::to_string(i + 1);
    notes.push_back(names[i] + ": is number " + number + " on the sheet, which has Latin letters only");
    labels[i] = number + ": " + labels[i];
  }
  return labels;
}

glm::vec<3, std::uint8_t> codes(glm::vec3 light) {
  return {srgb8FromLinear(light.x), srgb8FromLinear(light.y), srgb8FromLinear(light.z)};
}

}  // namespace

bool isModelInput(const std::string& input) {
  if (contains(builtinModelNames(), input) || modelFormatOf(input)) return true;
  return contains(split(modelExtensions(), ' '), std::filesystem::path(input).extension().string());
}

Result<ContactSheet> makeContactSheet(std::span<const ContactInput> inputs, const ContactSettings& settings,
                                      const std::optional<CacheFolder>& cache, const Observer& observer,
                                      const std::function<void(const Error&)>& failed) {
  ContactSheet sheet;
  const glm::ivec2 size_px = pictureSize(inputs, settings.width_px);
  MIRRORBALL_TRY(layout, contactLayout(inputs.size(), size_px, settings.columns));
  const std::vector<std::string> names = namesBelow(inputs, sheet.notes);
  const ProgressFunction progress = observer.progressOf("contact");
  std::optional<ModelCellPictures> models;
  std::vector<ContactCell> cells(inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::string& input = inputs[i].input;
    cells[i].name = names[i];
    const ProgressFunction unlessStopped = [&](std::size_t, std::size_t) {
      return !progress || progress(i, inputs.size());
    };
    const bool is_model = inputs[i].is_model;
    if (is_model && !models) {
      MIRRORBALL_TRY(made, ModelCellPictures::make(settings, size_px, cache, observer, sheet.notes));
      append(made.files(), sheet.files);
      models.emplace(std::move(made));
    }
    auto made = is_model ? models->picture(input, unlessStopped)
                         : mapCellPicture(input, size_px.x, settings, observer, unlessStopped);
    if (!made && made.error().code == ErrorCode::interrupted) return fail(std::move(made));
    if (made) {
      cells[i].picture = std::move(made->picture);
      cells[i].facts = std::move(made->facts);
      append(std::move(made->files), sheet.files);
      append(std::move(made->notes), sheet.notes);
    } else {
      failed(made.error());
    }
    if (progress && !progress(i + 1, inputs.size()))
      return fail(ErrorCode::interrupted, "interrupted; nothing was written");
  }
  sheet.picture = drawContactSheet(cells, layout, codes(settings.background));
  return sheet;
}

}  // namespace mirrorball
