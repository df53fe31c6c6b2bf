#include "mirrorball/codec/image_format.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/left_out.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/format_registry.h"

namespace mirrorball {
namespace {

using Admit = std::function<bool(const ImageFormat&)>;

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kImageFormats.size(); ++i)
    if (static_cast<std::size_t>(kImageFormats[i].id) != i) return false;
  return true;
}
static_assert(isInOrder());

/// The usual extensions, with their dots.
std::string extensionsOf(const FormatRegistry& formats, const Admit& admit, std::string_view before_last) {
  std::vector<std::string> extensions;
  for (const ImageFormat& format : kImageFormats)
    if (formats.has(format.id) && admit(format)) extensions.push_back("." + std::string(usualExtension(format)));
  return join(extensions, before_last == " " ? " " : ", ", before_last);
}

std::string namesOf(const Admit& admit) {
  std::vector<std::string_view> names;
  for (const ImageFormat& format : kImageFormats)
    if (isInThisBuild(format) && admit(format)) names.push_back(format.name);
  return join(names, ", ", " or ");
}

Admit isWrittenAs(Holds what) {
  return [what](const ImageFormat& format) { return format.is_written && mayHold(format, what); };
}

bool states(const ImageFormat& format, OutputPrimaries primaries) {
  if (primaries == OutputPrimaries::acescg) return format.states == StatedPrimaries::all;
  return primaries == OutputPrimaries::rec709 || format.states != StatedPrimaries::none;
}

/// The usual extensions of the formats that are written, can state primaries and hold one of these:
/// ".hdr, .exr and .ktx2".
std::string extensionsStating(OutputPrimaries primaries, std::initializer_list<Holds> wanted,
                              std::string_view before_last) {
  const auto admit = [&](const ImageFormat& format) {
    return format.is_written && contains(wanted, format.holds) && states(format, primaries);
  };
  return extensionsOf(FormatRegistry::ofThisBuild(), admit, before_last);
}

/// "; use .hdr or .exr for linear light, .png or .jpg for pictures": nothing of what no format of the build holds.
std::string adviceFor(const FormatRegistry& formats, std::initializer_list<Holds> wanted) {
  std::vector<std::string> kinds;
  for (const Holds what : wanted) {
    const char* purpose = what == Holds::light     ? " for linear light"
                          : what == Holds::texture ? " for textures"
                                                   : " for pictures";
    const std::string extensions = extensionsOf(formats, isWrittenAs(what), " or ");
    if (!extensions.empty()) kinds.push_back(extensions + (wanted.size() > 1 ? purpose : ""));
  }
  return kinds.empty() ? "" : "; use " + join(kinds, ", ", ", ");
}

std::string_view textOf(Holds what) {
  switch (what) {
    case Holds::light:
      return "linear light";
    case Holds::texture:
      return "textures";
    default:
      return "pictures";
  }
}

}  // namespace

bool isInThisBuild(const ImageFormat& format) { return FormatRegistry::ofThisBuild().has(format.id); }

std::string_view readExtensions() {
  static const std::string all = extensionsOf(
      FormatRegistry::ofThisBuild(), [](const ImageFormat&) { return true; }, " ");
  return all;
}

std::string readExtensions(Holds what) {
  return extensionsOf(
      FormatRegistry::ofThisBuild(), [what](const ImageFormat& format) { return mayHold(format, what); }, " ");
}

std::string writtenExtensions(std::string_view before_last) {
  return extensionsOf(
      FormatRegistry::ofThisBuild(), [](const ImageFormat& format) { return format.is_written; }, before_last);
}

std::string writtenExtensions(Holds what, std::string_view before_last) {
  return extensionsOf(FormatRegistry::ofThisBuild(), isWrittenAs(what), before_last);
}

std::vector<std::string_view> writtenExtensionNames() {
  std::vector<std::string_view> names;
  for (const ImageFormat& format : kImageFormats)
    if (isInThisBuild(format) && format.is_written) names.push_back(usualExtension(format));
  return names;
}

std::vector<std::string_view> writtenExtensionNames(Holds what) {
  std::vector<std::string_view> names;
  for (const ImageFormat& format : kImageFormats)
    if (isInThisBuild(format) && isWrittenAs(what)(format)) names.push_back(usualExtension(format));
  return names;
}

std::string readFormatNames() {
  return namesOf([](const ImageFormat&) { return true; });
}

std::string readFormatNames(Holds what) {
  return namesOf([what](const ImageFormat& format) { return mayHold(format, what); });
}

std::string primariesHelp(std::initializer_list<Holds> written) {
  return "primaries of the colours in the file, which states them: p3 (Display P3) and rec2020 in " +
         extensionsStating(OutputPrimaries::rec2020, written, " and ") +
         "; acescg, linear light under ACES' white, in " + extensionsStating(OutputPrimaries::acescg, written, " and ");
}

OptionText primariesText(std::string_view help) {
  return {.name = "primaries", .choices = "rec709|p3|rec2020|acescg", .help = help, .group = "Output"};
}

Result<void> checkStatesPrimaries(const std::filesystem::path& path, OutputPrimaries primaries,
                                  std::initializer_list<Holds> wanted) {
  if (primaries == OutputPrimaries::rec709) return {};
  MIRRORBALL_TRY(id, formatToWrite(path, wanted));
  const ImageFormat& format = formatOf(id);
  if (states(format, primaries)) return {};
  const std::string why = format.states == StatedPrimaries::none
                              ? ": cannot state other primaries than Rec.709's; write "
                              : ": holds what a display shows, and ACEScg is linear light; write ";
  return fail(ErrorCode::usage, path.string() + why + extensionsStating(primaries, wanted, " or ") +
                                    ", or leave the primaries as they are");
}

Result<ImageFormatId> formatToWrite(const std::filesystem::path& path, std::initializer_list<Holds> wanted) {
  return formatToWrite(path, wanted, FormatRegistry::ofThisBuild());
}

Result<ImageFormatId> formatToWrite(const std::filesystem::path& path, std::initializer_list<Holds> wanted,
                                    const FormatRegistry& formats) {
  const std::string extension = extensionOf(path);
  const auto* const format = std::find_if(kImageFormats.begin(), kImageFormats.end(), [&](const ImageFormat& known) {
    const std::vector<std::string> extensions = split(known.extensions, ' ');
    return contains(extensions, extension);
  });
  const bool is_written = format != kImageFormats.end() && format->is_written;
  if (is_written && contains(wanted, format->holds)) {
    if (formats.has(format->id)) return format->id;
    return withName(path.string(),
                    Result<ImageFormatId>(leftOut("writes no " + std::string(format->name), format->build_option)));
  }
  const std::string what = extension.empty() ? "has no extension to tell its format by"
                           : is_written      ? "would hold " + std::string(textOf(format->holds))
                                             : "is not a format that Mirrorball writes";
  return fail(ErrorCode::usage, path.string() + ": " + what + adviceFor(formats, wanted));
}

}  // namespace mirrorball
