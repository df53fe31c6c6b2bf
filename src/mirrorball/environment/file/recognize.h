#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/cube/preset.h"
#include "mirrorball/environment/file/dual_fisheye.h"
#include "mirrorball/environment/file/map_form.h"
#include "mirrorball/environment/file/panorama_part.h"
#include "mirrorball/environment/file/picture_half.h"

namespace mirrorball {

/// What becomes of the directions that a picture of a part of a panorama does not show.
enum class PanoramaRest {
  black,   ///< no light
  smooth,  ///< the picture's light, continued from its edge (fillAround)
};

/// What the caller says of a map's form.
struct FormHint {
  std::optional<Projection> projection = {};
  std::optional<CubeLayout> layout = {};
  CubeArrangement arrangement = {};  ///< the rest as in MapForm
  SignedAxis centre = SignedAxis::plus_z;
  bool has_texels_on_edges = false;
  std::string layer = {};           ///< of a file of several pictures, the one that holds the map
  bool swaps_red_and_blue = false;  ///< the file's red is blue, and its blue red
  // Of a panorama, the rest too.
  std::optional<PanoramaPart> part = {};  ///< that the picture shows; nothing: what its file says
  bool is_whole = false;                  ///< the picture shows all, whatever its file says
  std::optional<PanoramaRest> rest = {};  ///< what becomes of the directions that it does not show; nothing: black
  bool stays_tilted = false;              ///< it is not levelled where its file says how the camera was tilted
  std::optional<PictureHalf> eye = {};    ///< of a stereo picture, the half that is read
  /// The picture is two circles, of which an equirect is stitched; nothing of what stands above of a panorama counts.
  std::optional<DualFisheye> fisheye = {};

  /// Whether it says of which form a map is, and not only which layer holds it.
  bool namesForm() const { return projection || layout; }
  /// Whether it leaves it open that a map is a cube.
  bool allowsCube() const { return !projection || faceCount(*projection) == 6; }
};

/// The names that a hint begins with, but for cube layouts: the projections, and forms that are read alone.
std::span<const std::string_view> readFormNames();

/// "": no hint. A projection ("cube", "eac": the layout by the picture's shape; "ball:distance=12") or a cube layout
/// ("hcross", "faces"). After a colon, with commas between, its arrangement in the file if that is not ours:
///   for=PROGRAM          as a preset has it (preset.h): "cube:for=unity", "equirect:for=blender"
///   layout=LAYOUT        of cube and eac: "eac:layout=vcross"
///   as-seen, flip=…, turn=…, order=…, axes=…   of a cube (cube_arrangement.h), each applied to what stands before it
///   centre=AXIS          of an equirect, and so are the next: our direction in its middle, "+x", "-x", "+z" or "-z"
///   crop=X,Y,W,H/FULLWxFULLH   the part of it that the picture shows, in texels; "crop=none": all, against its file
///   fov=HxV              the same in degrees around its middle: "fov=360x90"
///   fill=smooth, fill=black   what becomes of the rest
///   level=no             it is not levelled where its file says how the camera was tilted
///   eye=HALF             of a stereo picture of two panoramas, the one at the "top", "bottom", "left" or "right"
///   fov=D, turn=L,R      of "dual-fisheye" (applyDualFisheyeWord)
///   layer=NAME           of any form, or without one ("layer=rgba"): which picture of a file of several;
///                        layer="NAME" with commas in it
///   swap=rb              likewise of any form or alone: red and blue are exchanged in the file
///
/// errors   usage: lists the names
Result<FormHint> formHintNamed(std::string_view name);

/// A form, and how it was recognised.
struct Recognition {
  MapForm form;
  std::string told_by;       ///< "the file's metadata", "its shape, 2:1"; empty: the hint
  bool is_guess = false;     ///< of a cube: known by shape or names alone, and another form may be right
  bool is_by_shape = false;  ///< known by the picture's shape alone
};

/// Doubts about the form that was recognised.
struct FormDoubt {
  std::string message = {};                   ///< empty: no doubt
  std::vector<std::string> other_forms = {};  ///< for `formHintNamed`: other possible forms
};

/// What a file says of its form, for `recognize` to read back: "mirrorball:projection", a cube's "mirrorball:layout", a
/// ball's "mirrorball:ball_distance" and, where they are not our own, a cube's "mirrorball:arrangement", a panorama's
/// "mirrorball:centre" and "mirrorball:texels". A whole map in OpenEXR's registration has OpenEXR's
/// own "envmap" instead.
Metadata metadataOf(const MapForm& form);

/// The metadata of a sheet of mip levels (image/level_sheet.h), so that it is not read as a map of its shape.
Metadata metadataOfLevelSheet();

/// The same for a BRDF table, which is square like a sphere map.
Metadata metadataOfBrdfTable();
bool isBrdfTable(const Metadata& metadata);

/// The same for a table of lobe rows (bake/lobe_row/lobe_row_table.h).
Metadata metadataOfLobeRows();
bool isLobeRows(const Metadata& metadata);

/// What the metadata of either begins with.
inline constexpr const char* kTableKey = "mirrorball:table";

/// Whether a texture without metadata is recognised as a map of that form: by its six faces and how their edges meet,
/// or by its shape.
bool isRecognizedUnsaid(const MapForm& form);

/// Determines the form of six files with an image each: by the hint, or else by the metadata of the first one.
///
/// told_by  how it was recognised that they are six faces, if neither says more
Recognition recognizeFaces(const Metadata& metadata, const FormHint& hint, const std::string& told_by);

/// Whether a file's metadata says what map it holds, if not rightly.
bool statesForm(const Metadata& metadata);

/// Determines a picture's form: by the hint, else by the file's own metadata, else by its shape (2:1 equirect, 1:1
/// sphere map, 4:3 horizontal cross, 3:4 vertical cross, 6:1 and 1:6 strips, 3:2 tiles; nearly 2:1 equirect, see
/// isNearlyWholePanorama). Its content may say more (picture_content.h). All other forms have to be named. The picture
/// of a panorama may have another shape than 2:1: where the hint says that it is a part, or where it is nearly 2:1.
///
/// errors   bad_shape: the shape fits no form, or not the named one; or, without a hint, the metadata says that it is
///          not a map
Result<Recognition> recognize(int width, int height, const Metadata& metadata, const FormHint& hint = {});

}  // namespace mirrorball
