#include "mirrorball/environment/file/picture_meaning.h"

#include <utility>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

/// Whether a Photo Sphere may tell more than the caller and the file's own metadata did.
bool isOpenToPhotoSphere(const FormHint& hint, const Metadata& metadata) {
  if (hint.projection) return hint.projection == Projection::equirect && !hint.has_texels_on_edges;
  return !hint.layout && !statesForm(metadata);
}

/// The part of the panorama that the picture shows, where its size agrees with what the Photo Sphere says. A picture
/// that was scaled after its fields were written has another size, and the part's proportion; one that was put into its
/// place on black, with the fields kept, has the whole panorama's size.
std::optional<PanoramaPart> partByPhotoSphere(const PanoramaArea& area, glm::ivec2 size,
                                              std::vector<std::string>& oddities) {
  const Result<PanoramaPart> part = panoramaPart(area);
  if (!part || part->isWhole()) return std::nullopt;
  const std::string claim =
      "its GPano says that it is " + sizeText(area.size) + " of a panorama of " + sizeText(area.whole) + ", and it ";
  const std::string by_hand = "; {option:from} equirect:crop=X,Y,W,H/FULLWxFULLH says it by hand";
  if (size == area.whole) {
    oddities.push_back(claim + "has the size of the whole: taken as the whole" + by_hand);
    return std::nullopt;
  }
  if (heightOfWhole(size, *part)) return *part;
  oddities.push_back(claim + "has not that part's proportion, as " + sizeText(size) + ": that crop is ignored" +
                     by_hand);
  return std::nullopt;
}

/// What a picture of nearly 2:1 is taken as.
std::string nearlyWholeText(glm::ivec2 size) {
  const int height = heightOfWhole(size, PanoramaPart{}).value_or(size.y);
  return "is nearly 2:1, " + sizeText(size) + ": taken as a whole panorama, resampled to " +
         sizeText({2 * height, height});
}

std::string emptyRestText(const PanoramaPart& part, bool is_by_photo_sphere) {
  const std::string rest = "holds " + textOf(part) + " of a panorama" +
                           (is_by_photo_sphere ? ", as its GPano says" : "") +
                           ": the rest of the sphere is black, and lights nothing; ";
  if (!is_by_photo_sphere) return rest + "the word fill=smooth behind its crop or fov continues the picture into it";
  return rest +
         "{option:from} equirect:fill=smooth continues the picture into it, {option:from} equirect:crop=none "
         "takes the picture as the whole";
}

std::string tiltText(const CameraTilt& tilt) {
  return "was taken with the camera tilted, as its GPano says (pitch " + formatNumber(tilt.pitch_deg) + ", roll " +
         formatNumber(tilt.roll_deg) + " degrees): levelled; {option:from} equirect:level=no leaves it as it is";
}

}  // namespace

Result<PictureMeaning> readMeaning(glm::ivec2 size, const Metadata& metadata, const std::optional<PhotoSphere>& sphere,
                                   const FormHint& hint) {
  PictureMeaning meaning;
  FormHint settled = hint;
  const bool tells = sphere && isOpenToPhotoSphere(hint, metadata);
  if (tells) {
    if (!hint.projection && !sphere->projection.empty() && !sphere->isEquirectangular())
      return fail(ErrorCode::bad_shape,
                  "is a panorama in the projection '" + excerpt(sphere->projection, 20) +
                      "', as its GPano says, and only equirectangular ones are read; convert it",
                  FixHint::name_form);
    meaning.oddities = sphere->mistakes;
    if (!hint.part && !hint.is_whole && sphere->area)
      settled.part = partByPhotoSphere(*sphere->area, size, meaning.oddities);
    if (sphere->isEquirectangular() || settled.part) settled.projection = Projection::equirect;
  }
  MIRRORBALL_TRY(recognition, recognize(size.x, size.y, metadata, settled));
  meaning.recognition = std::move(recognition);
  const MapForm& form = meaning.recognition.form;
  if (form.projection != Projection::equirect || form.has_texels_on_edges) return meaning;
  if (tells && !hint.projection && settled.projection) meaning.recognition.told_by = "its GPano";

  meaning.part = settled.part;
  if (meaning.part && !meaning.part->isWhole() && !hint.rest)
    meaning.oddities.push_back(emptyRestText(*meaning.part, !hint.part));
  if (!meaning.part && size.x != 2 * size.y) {
    meaning.part = PanoramaPart{};
    meaning.oddities.push_back(nearlyWholeText(size));
  }
  if (tells && sphere->isTilted() && !hint.stays_tilted) {
    meaning.tilt = {sphere->pitch_deg, sphere->roll_deg};
    meaning.oddities.push_back(tiltText(*meaning.tilt));
  }
  return meaning;
}

void adviseOnRest(const PictureWindow& window, std::vector<std::string>& oddities) {
  if (shareOfSphere(window) < 1.0 && !oddities.empty())
    oddities.back() += ", and lights nothing; {option:from} equirect:fill=smooth continues the picture into it";
}

Result<void> completePanorama(const PictureMeaning& meaning, const FormHint& hint, DecodedImage& decoded) {
  const MapForm& form = meaning.recognition.form;
  if (form.projection != Projection::equirect || form.has_texels_on_edges) return {};
  if (decoded.window && !hint.rest) adviseOnRest(*decoded.window, decoded.oddities);
  if (meaning.part) {
    PictureWindow window{.source = hint.part ? "the form that was named" : "its GPano"};
    MIRRORBALL_TRY(panorama, placedInPanorama(std::move(decoded.image), *meaning.part, window));
    decoded.image = std::move(panorama);
    if (!meaning.part->isWhole()) decoded.window = std::move(window);
  }
  if (decoded.window && hint.rest == PanoramaRest::smooth) return fillAround(*decoded.window, decoded.image);
  return {};
}

}  // namespace mirrorball
