#include "mirrorball/contact/model_cell_pictures.h"

#include <algorithm>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/light_edit/sun_split.h"
#include "mirrorball/render/settings/frame_checks.h"
#include "mirrorball/scene/model_facts.h"

namespace mirrorball {
namespace {

/// What of an opaque picture is colour.
Image8 withoutAlpha(const Image8& picture) {
  Image8 opaque = Image8::withoutValues(picture.width(), picture.height(), 3);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) std::copy_n(picture.texel(x, y), 3, opaque.texel(x, y));
  return opaque;
}

FrameSettings frameFor(const ContactSettings& settings, glm::ivec2 size_px) {
  FrameSettings frame = settings.frame;
  frame.size = size_px;
  frame.display.exposure_ev = settings.exposure_ev.value_or(0.0f);
  frame.background = BackgroundKind::display_color;
  frame.background_color = settings.background;
  return frame;
}

}  // namespace

Result<ModelCellPictures> ModelCellPictures::make(const ContactSettings& settings, glm::ivec2 size_px,
                                                  const std::optional<CacheFolder>& cache, const Observer& observer,
                                                  std::vector<std::string>& notes) {
  const ProgressFunction progress = observer.progressOf("prefilter");
  MIRRORBALL_TRY(hint, formHintNamed(settings.from));
  MIRRORBALL_TRY(loaded, loadRepaired(settings.environment, {.from = hint}, notes, progress));
  tellAbout(loaded, observer);
  if (EnvironmentMap* map = loaded.environment.map())
    MIRRORBALL_TRY_VOID(withName(loaded.name, checkLight(*map, observer.named(loaded.name))));
  MIRRORBALL_TRY(has_strong_sun, hasStrongSun(loaded.environment));
  MIRRORBALL_TRY(prepared, prepareEnvironment(loaded.environment, cache, progress));
  MIRRORBALL_TRY(context, gl::Context::createHeadless());
  const int largest_texture = context.largestTexture();
  MIRRORBALL_TRY(renderer, Renderer::on(std::move(context)));
  MIRRORBALL_TRY_VOID(renderer.setEnvironment(std::move(loaded.environment), prepared));
  RenderInputNames names{.load_model = {.inside_only = settings.inside_only, .animation = settings.stance.animation},
                         .up = settings.stance.up,
                         .frame = frameFor(settings, size_px),
                         .cache = cache};
  TechniqueWishes choice{settings.quality.quality, settings.stated};
  choice.has_strong_sun = has_strong_sun;
  return ModelCellPictures(std::move(renderer), std::move(names), std::move(choice), largest_texture,
                           std::move(loaded.files));
}

Result<CellPicture> ModelCellPictures::picture(const std::string& model, const ProgressFunction& progress) {
  RenderInputNames names = names_;
  names.model = model;
  names.load_model.progress = progress;
  MIRRORBALL_TRY(scene, loadScene(names, [this] { return largest_texture_; }));
  CellPicture cell{.facts = counted(triangleCount(scene), "triangle"), .files = scene.files, .notes = scene.warnings};
  cell.files.push_back(model);
  FrameSettings frame = names.frame;
  const Observer observer{.progress = [&progress](std::string_view) { return progress; }};
  MIRRORBALL_TRY_VOID(chooseTechniques(scene, choice_, frame, names.cache, observer));
  MIRRORBALL_TRY(doubts, withName(model, checkFrame(frame, scene)));
  for (const std::string& line : doubts) cell.notes.push_back(model + ": " + line);
  MIRRORBALL_TRY_VOID(renderer_.setScene(std::move(scene)));
  MIRRORBALL_TRY_VOID(renderer_.stage().prepare(frame));
  MIRRORBALL_TRY_VOID(renderer_.draw(frame, progress));
  MIRRORBALL_TRY(picture, renderer_.picture());
  cell.picture = withoutAlpha(picture);
  return cell;
}

}  // namespace mirrorball
