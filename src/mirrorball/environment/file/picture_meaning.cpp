#include "mirrorball/environment/file/picture_meaning.h"

#include <algorithm>
#include <utility>

#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/picture_window.h"
#include "mirrorball/environment/file/picture_content.h"

namespace mirrorball {
namespace {

/// Whether a Photo Sphere may tell more than the caller and the file's own metadata did.
bool isOpenToPhotoSphere(const FormHint& hint, const Metadata& metadata) {
  if (hint.fisheye) return false;
  if (hint.projection) return hint.projection == Projection::equirect && !hint.has_texels_on_edges;
  return !hint.layout && !statesForm(metadata);
}

/// The part of the panorama that the picture shows, where its size agrees with what the Photo Sphere says. A picture
/// that was scaled after its fields were written has another size, and the part's proportion; one that was put into its
/// place on black, with the fields kept, has the whole panorama's size.
std::optional<PanoramaPart> partByPhotoSphere(const PanoramaArea& area, glm::ivec2 size,
                                              std::vector<std::string>& oddities) {
  const Result<PanoramaPart> part = panoramaPartOfStrip(area);
  if (!part || part->isWhole()) return std::nullopt;
  const std::string claim =
      "its GPano says that it is " + sizeText(area.size) + " of a panorama of " + sizeText(area.whole) + ", and it ";
  const std::string by_hand = "; {option:from} equirect:crop=X,Y,W,H/FULLWxFULLH says it by hand";
  if (size == area.whole && area.size != area.whole) {
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

/// strip    the Photo Sphere's area, if its whole is taken as a strip
std::string emptyRestText(const PanoramaPart& part, bool is_by_photo_sphere, const std::optional<PanoramaArea>& strip) {
  const std::string rest =
      "holds " + textOf(part) + " of a panorama" + (is_by_photo_sphere ? ", as its GPano says" : "") +
      (strip ? ", whose whole of " + sizeText(strip->whole) + " is taken as a strip about the horizon"
             : std::string()) +
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

/// Whether a half may be a panorama that was squeezed to half its width or height, or to the frame of a film.
bool mayBeHalf(glm::ivec2 half) {
  return half.x > 0 && half.y > 0 && 20LL * half.x >= 17LL * half.y && half.x <= 5LL * half.y;
}

/// Whether a half of a picture has to be stretched to 2:1: it has not that shape, nor that of the part of a panorama
/// that is named or stated.
///
/// stated   the half that the file's StereoMode names
bool isSqueezed(glm::ivec2 picture, PictureHalf half, std::optional<PictureHalf> stated,
                const std::optional<PhotoSphere>& sphere, const FormHint& hint) {
  const glm::ivec2 size = sizeOfHalf(picture, half);
  if (hint.part || isNearlyWholePanorama(size) || !mayBeHalf(size)) return false;
  if (sphere && sphere->area && !hint.is_whole) {
    const Result<PanoramaPart> part = panoramaPartOfStrip(*sphere->area);
    if (part && !part->isWhole() && heightOfWhole(size, *part)) return false;
  }
  return isNearlyWholePanorama(picture) || (stated && isUpperOrLower(*stated) == isUpperOrLower(half));
}

/// half     the upper or the left one
std::string readEyeText(PictureHalf half, bool is_squeezed) {
  const bool is_top = half == PictureHalf::top;
  return std::string(is_top ? "the upper one is read" : "the left one is read") +
         (is_squeezed ? ", stretched to 2:1" : "") +
         "; {option:from} equirect:eye=" + std::string(halfName(is_top ? PictureHalf::bottom : PictureHalf::right)) +
         " reads the other";
}

/// size     the picture's
std::string statedEyeText(glm::ivec2 size, PictureHalf half, bool is_squeezed) {
  std::string text = "is a stereo picture, as its StereoMode says: " + readEyeText(half, is_squeezed);
  if (!is_squeezed || !isNearlyWholePanorama(size)) return text;
  text += ", {option:from} equirect:crop=none the whole as one panorama";
  if (half == PictureHalf::left) text += ", {option:from} equirect:eye=left,fov=180x180 half a sphere";
  return text;
}

}  // namespace

bool isPlainPanorama(const MapForm& form) {
  return form.projection == Projection::equirect && !form.has_texels_on_edges;
}

bool mayBeStereo(glm::ivec2 size, const std::optional<PhotoSphere>& sphere, const FormHint& hint) {
  return hint.eye || (sphere && !sphere->stereo.empty()) || size.x == size.y || size.x == 4 * size.y;
}

glm::ivec2 stretchedSize(glm::ivec2 half) {
  const int height = std::max(half.y, (half.x + 1) / 2);
  return {2 * height, height};
}

StereoEye chooseEye(const Image& picture, const Metadata& metadata, const std::optional<PhotoSphere>& sphere,
                    const FormHint& hint) {
  const glm::ivec2 size(picture.width(), picture.height());
  const std::string mode = sphere ? sphere->stereo : std::string();
  std::optional<PictureHalf> stated;
  if (mode == "top-bottom" || mode == "left-right") stated = mode[0] == 't' ? PictureHalf::top : PictureHalf::left;
  if (hint.eye) return {hint.eye, isSqueezed(size, *hint.eye, stated, sphere, hint)};
  if (!isOpenToPhotoSphere(hint, metadata) || hint.part || hint.is_whole || !mayBeStereo(size, sphere, hint)) return {};
  if (mode == "mono") return {};
  if (stated && mayBeHalf(sizeOfHalf(size, *stated))) {
    const bool is_squeezed = isSqueezed(size, *stated, stated, sphere, hint);
    return {stated, is_squeezed, statedEyeText(size, *stated, is_squeezed)};
  }
  const std::optional<PictureHalf> half = equalHalves(picture);
  if (half) {
    std::string oddity =
        "holds two panoramas that are nearly equal, as a stereo picture's: " + readEyeText(*half, false);
    if (half == PictureHalf::top) oddity += ", {option:from} sphere the whole as one map";
    return {half, false, std::move(oddity)};
  }
  if (!stated) return {};
  return {std::nullopt, false,
          "is a stereo picture, as its StereoMode '" + mode + "' says, and " + sizeText(size) +
              " is not the shape of one: taken as one picture"};
}

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
  if (!isPlainPanorama(form)) return meaning;
  if (tells && !hint.projection && settled.projection) meaning.recognition.told_by = "its GPano";

  if (hint.fisheye) {
    meaning.fisheye = hint.fisheye;
    if (std::string assumed = assumedText(*hint.fisheye); !assumed.empty())
      meaning.oddities.push_back(std::move(assumed));
    return meaning;
  }
  meaning.part = settled.part;
  if (meaning.part && !meaning.part->showsAll() && !hint.rest) {
    const bool is_strip = !hint.part && isStrip(*sphere->area);
    meaning.oddities.push_back(emptyRestText(*meaning.part, !hint.part, is_strip ? sphere->area : std::nullopt));
  }
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
  const auto remark = std::find(oddities.begin(), oddities.end(), windowText(window));
  if (shareOfSphere(window) < 1.0 && remark != oddities.end())
    *remark += ", and lights nothing; {option:from} equirect:fill=smooth continues the picture into it";
}

Result<void> completePanorama(const PictureMeaning& meaning, const FormHint& hint, DecodedImage& decoded) {
  if (!isPlainPanorama(meaning.recognition.form)) return {};
  if (meaning.fisheye) {
    MIRRORBALL_TRY_VOID(checkImageMemory(2 * decoded.image.height(), decoded.image.height(), 3));
    decoded.image = stitched(decoded.image, *meaning.fisheye);
    decoded.window.reset();
    return {};
  }
  if (decoded.window && !hint.rest) adviseOnRest(*decoded.window, decoded.oddities);
  const bool is_continued = hint.rest == PanoramaRest::smooth;
  // Before its edge is mixed with the black around it.
  if (decoded.window && is_continued) MIRRORBALL_TRY_VOID(fillAround(*decoded.window, decoded.image));
  if (!meaning.part) return {};
  PanoramaPart part = *meaning.part;
  int columns_before = 0;
  if (const auto height = heightOfWhole({decoded.image.width(), decoded.image.height()}, part);
      height && part.crossesSeam()) {
    const int columns = 2 * *height;
    columns_before = std::min(static_cast<int>(part.begin.x * columns), columns);
    const glm::dvec2 turn(double(columns_before) / columns, 0.0);
    part = {part.begin - turn, part.end - turn};
  }
  PictureWindow placed{.source = hint.part ? "the form that was named" : "its GPano"};
  MIRRORBALL_TRY(panorama, placedInPanorama(std::move(decoded.image), part, placed));
  if (is_continued && !part.showsAll()) MIRRORBALL_TRY_VOID(fillAround(placed, panorama));
  turnColumns(panorama, columns_before);
  decoded.image = std::move(panorama);
  if (decoded.window)
    decoded.window = windowInPanorama(*decoded.window, part, placed.whole);
  else if (!part.showsAll())
    decoded.window = std::move(placed);
  if (decoded.window) decoded.window->corner.x += columns_before;
  return {};
}

}  // namespace mirrorball
