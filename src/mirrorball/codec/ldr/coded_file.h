#pragma once

#include <string>
#include <vector>

#include "mirrorball/codec/color/coded_color.h"
#include "mirrorball/codec/exif.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/coded_picture.h"

namespace mirrorball {

/// The channels that a codec is asked for.
enum class CodeForm {
  stored,  ///< those of the file
  rgba,    ///< four, where the format's library makes them as it decodes, which spares a copy; else as stored
};

/// A picture of integers as its file holds it, and all that the file says of it. A codec only fills this; what is made
/// of it, here below, does not depend on the format.
struct CodedFile {
  CodedPicture codes;
  CodedColor color = {};
  int orientation = 1;                      ///< image/upright.h; the codes are not turned yet
  std::string orientation_source = "EXIF";  ///< what in the file says so
  Exif exif = {};                           ///< of which `orientation` above is the one that counts
  Metadata metadata = {};
  std::string format = {};                 ///< DecodedImage's
  std::vector<std::string> oddities = {};  ///< DecodedImage's
};

/// The remark on an ICC profile that is not applied; empty where there is none, and for sRGB's own by its name.
std::string unreadProfileRemark(const CodedColor& color);

/// "turned upright, as its EXIF says (orientation 6)": the remark on a picture that was not stored so; empty for one
/// that was.
std::string uprightRemark(int orientation, const std::string& source);

/// Turns the codes upright, and says so.
void turnUpright(CodedFile& file);

/// Linear light with Rec.709's primaries, or numbers as fractions of the greatest code; upright.
///
/// cost     the codes and the result stand side by side
DecodedImage asImage(CodedFile file, ReadAs as = ReadAs::light);

/// A texture, upright, of 4 channels. Of colours: sRGB's codes of 8 bits and Rec.709; what has other codes is
/// converted, with a remark, to floats where some light is beyond what codes hold. Of numbers: codes of 8 bits as they
/// are, others as fractions of the greatest.
///
/// errors   too_large: colours that are converted stand beside the codes, as light and as a texture
Result<Decoded<Texels>> asTexels(CodedFile file, ReadAs as = ReadAs::light);

/// Codes of 8 bits as a camera made them, upright, and what they stand for.
PictureCodes asCodes(CodedFile file);

/// Its codes with all bits, as fractions of the greatest, upright, and what they stand for.
PictureFractions asFractions(CodedFile file);

/// With alpha, which is 1 where there was none.
Image withAlpha(Image image);

}  // namespace mirrorball
