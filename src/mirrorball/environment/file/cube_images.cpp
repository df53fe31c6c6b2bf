#include "mirrorball/environment/file/cube_images.h"

#include <utility>

#include "mirrorball/environment/cube/cube_arrangement.h"
#include "mirrorball/environment/cube/face_reading.h"

namespace mirrorball {
namespace {

/// Takes six images that do not say how they lie as their edges tell.
///
/// arrangements  that are possible: first that of `recognition`
FormDoubt settleFaces(const EnvironmentMap& images, std::span<const CubeArrangement> arrangements,
                      Recognition& recognition) {
  const FaceReading reading = readByEdges(images, arrangements);
  if (reading.arrangement != recognition.form.arrangement) {
    recognition.form.arrangement = reading.arrangement;
    recognition.told_by += ", and how its edges meet";
  } else if (reading.fit.jumps()) {
    return makeCubeDoubt(recognition, kFacesJump);
  }
  return {};
}

}  // namespace

Result<NonFinite> checkNonFinite(const Image& image, const EnvironmentLoadOptions& options) {
  const NonFinite bad = findNonFinite(image);
  if (bad.count == 0 || options.keep_bad || options.repair) return bad;
  return fail(ErrorCode::non_finite, textOf(bad), FixHint::repair);
}

Result<void> repairImages(ImageSet& images) {
  for (int face = 0; face < images.faces(); ++face) MIRRORBALL_TRY_VOID(repairNonFinite(images.at(0, face)));
  return {};
}

void add(const NonFinite& more, NonFinite& total) {
  if (total.count == 0) total.first = more.first;
  total.count += more.count;
}

FormDoubt makeCubeDoubt(const Recognition& recognition, std::string_view reason) {
  FormDoubt doubt{"taken as " + textOf(recognition.form) + " (" + recognition.told_by + "), but " +
                  std::string(reason) + ": a photograph is no map"};
  if (recognition.form.layout == CubeLayout::hcross) doubt.other_forms.emplace_back("lecture");
  if (recognition.form.layout == CubeLayout::vcross) doubt.other_forms.emplace_back("vcross:turn=-z");
  doubt.other_forms.emplace_back("cube:as-seen");
  return doubt;
}

Result<LoadedEnvironment> cubeFromImages(ImageSet images, std::string format, std::string color, Metadata metadata,
                                         Recognition recognition, const NonFinite& bad,
                                         const EnvironmentLoadOptions& options, bool is_numbered) {
  const Projection projection = recognition.form.projection;
  if (faceCount(projection) != 6)
    return fail(
        ErrorCode::bad_shape,
        "has the six faces of a cube, and a map of projection " + std::string(nameOf(projection)) + " is one picture",
        FixHint::name_form_of_cube);
  const glm::ivec2 size(images.at(0, 0).width());
  if (options.repair) MIRRORBALL_TRY_VOID(repairImages(images));
  FormDoubt doubt;
  if (recognition.is_guess) {
    EnvironmentMap by_slots(projection, std::move(images));
    doubt = settleFaces(by_slots, possibleArrangements(recognition.form.arrangement, is_numbered), recognition);
    images = std::move(by_slots).takeImages();
  }
  EnvironmentMap map = mapOfImages(std::move(images), recognition.form);
  return LoadedEnvironment{.environment = Environment(std::move(map)),
                           .format = std::move(format),
                           .color = std::move(color),
                           .recognition = std::move(recognition),
                           .file_size = size,
                           .bad_texels = bad,
                           .metadata = std::move(metadata),
                           .doubt = std::move(doubt)};
}

}  // namespace mirrorball
