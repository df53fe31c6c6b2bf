#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "mirrorball/base/option.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/codec/row_reader.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/environment/file/face_files.h"
#include "mirrorball/environment/file/light_limits.h"
#include "mirrorball/environment/file/recognize.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// --env, of what shows models in an environment.
OptionText environmentText(std::string_view help);

/// --from, of what reads maps: the text is for formHintNamed.
OptionText formText(std::string_view help, std::string_view group = {});

/// How to read an environment.
struct EnvironmentLoadOptions {
  FormHint from = {};      ///< overrides what is recognised
  bool repair = false;     ///< replace NaN and infinite texels by their neighbours' mean
  bool keep_bad = false;   ///< leave them as they are: for `info`, which only counts them
  LightLimits light = {};  ///< of the file's own texels, or of a built-in's light
};

/// An environment and what is known about where it came from.
struct LoadedEnvironment {
  Environment environment;
  std::string name = {};                        ///< the path, or the built-in's name
  std::string format = {};                      ///< the file's; "built in"
  std::string color = {};                       ///< the file's, and what was done about it: DecodedImage::color
  std::optional<Recognition> recognition = {};  ///< of a file
  glm::ivec2 file_size{0};                      ///< of the picture in the file (of one face where each has its own)
  NonFinite bad_texels = {};                    ///< as found, before any repair
  std::vector<std::string> files = {};          ///< that were read
  LostLight lost = {};                          ///< by the limit of the light
  Metadata metadata = {};                       ///< what the file says of itself; of six files the first
  FormDoubt doubt = {};                         ///< of the form that was recognised
  bool lacks_gain_map = false;                  ///< that its file says it has (GainMapUse::lost)
  std::optional<PictureWindow> window = {};     ///< the part of the map that the file holds, if not all of it
  bool window_goes_round = false;               ///< beyond the map's right edge it goes on at the left one
  bool is_levelled = false;                     ///< a panorama taken with the camera tilted: its up is ours now
  std::vector<PictureLayer> layers = {};        ///< DecodedImage's, and the two that follow
  std::string layer = {};
  std::string layer_guess = {};
  std::vector<std::string> oddities = {};  ///< DecodedImage::oddities
  int levels = 1;                          ///< mip levels that its file holds, the map itself included

  /// Can be used wherever an environment is wanted: by reference, or, when it is not needed any more, by moving its
  /// images.
  operator const Environment&() const& { return environment; }
  operator Environment() && { return std::move(environment); }
};

/// Loads a built-in by its name (builtin.h), else a file of any format that is read (codec/image_format.h): of a
/// texture its largest level, of an array its first element. The name of one of a cube's six files (face_files.h), if
/// most of them are there, and that of the folder that holds them stand for all six. If only a picture's shape or the
/// names show that it is a cube, its edges decide the arrangement of its faces, if they meet in one way only
/// (cube_edges.h).
///
/// progress called while an OpenEXR or TIFF picture is decoded
/// errors   not_found (lists the built-ins); bad_shape; non_finite (count and first texel);
///          interrupted; whatever the codec finds
Result<LoadedEnvironment> loadEnvironment(const std::string& name_or_path, const EnvironmentLoadOptions& options = {},
                                          const ProgressFunction& progress = {});

/// Remarks what is unusual in its file, what speaks against the form in which a map was taken, that its file lost a
/// gain map, and how much light its limit took.
void tellAbout(const LoadedEnvironment& loaded, const Observer& observer);

/// The six files of a cube that the name of one of them stands for, if most of them exist.
///
/// returns  nothing if the name stands for one file only
std::optional<FaceFiles> cubeFilesOf(const std::string& path, const FormHint& from);

/// The mip levels that a texture holds, three channels; level 0 is the map that was loaded. The smaller ones may have
/// any content, for example the reflections in rougher and rougher surfaces.
///
/// loaded     by loadEnvironment with the same options; its file is read once more
/// form       how they are wanted; of the map's projection, without OpenEXR's registration
/// returns    nothing if the file holds one level, or its map in a form whose levels are not maps: a cube's layout in
///            one picture, discs, OpenEXR's registration
/// errors     as loadEnvironment's
Result<std::optional<ImageSet>> loadLevels(const LoadedEnvironment& loaded, const MapForm& form,
                                           const EnvironmentLoadOptions& options = {});

/// A panorama that is read by rows while it is converted (convert_rows.h).
struct PanoramaRows {
  std::unique_ptr<RowReader> rows;
  /// Turns our directions into the picture's own: it may have another than +Z at its centre.
  glm::mat3 picture_from_world{1.0f};
  std::vector<std::string> oddities = {};  ///< what was decided of its form, beside those of its file
  Recognition recognition = {};
  FormDoubt doubt = {};  ///< of its form, where its light was looked at (openLargePanorama)
};

/// Opens a panorama to be read by rows. Neither its light nor whether rows are missing is looked at.
///
/// returns  nothing if it must be loaded as a whole: built-ins, cubes and other projections, formats that cannot be
///          read by rows (openRows), and maps that are repaired, limited, resampled or completed when they are loaded
/// errors   as loadEnvironment's
Result<std::optional<PanoramaRows>> openPanorama(const std::string& name_or_path,
                                                 const EnvironmentLoadOptions& options = {});

/// Remarks what is unusual in its file.
void tellAbout(const PanoramaRows& panorama, const std::string& name, const Observer& observer);

}  // namespace mirrorball
