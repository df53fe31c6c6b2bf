#include "mirrorball/codec/image_format.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"

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
std::string extensionsOf(const Admit& admit, std::string_view before_last) {
  std::vector<std::string> extensions;
  for (const ImageFormat& format : kImageFormats)
    if (admit(format)) extensions.push_back("." + std::string(usualExtension(format)));
  return join(extensions, before_last == " " ? " " : ", ", before_last);
}

std::string namesOf(const Admit& admit) {
  std::vector<std::string_view> names;
  for (const ImageFormat& format : kImageFormats)
    if (admit(format)) names.push_back(format.name);
  return join(names, ", ", " or ");
}

/// ".hdr or .exr for linear light, .png or .jpg for pictures"
std::string adviceFor(std::initializer_list<Holds> wanted) {
  std::vector<std::string> kinds;
  for (const Holds what : wanted) {
    const char* purpose = what == Holds::light     ? " for linear light"
                          : what == Holds::texture ? " for textures"
                                                   : " for pictures";
    kinds.push_back(writtenExtensions(what, " or ") + (wanted.size() > 1 ? purpose : ""));
  }
  return join(kinds, ", ", ", ");
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

std::string_view readExtensions() {
  static const std::string all = extensionsOf([](const ImageFormat&) { return true; }, " ");
  return all;
}

std::string readExtensions(Holds what) {
  return extensionsOf([what](const ImageFormat& format) { return mayHold(format, what); }, " ");
}

std::string writtenExtensions(std::string_view before_last) {
  return extensionsOf([](const ImageFormat& format) { return format.is_written; }, before_last);
}

std::string writtenExtensions(Holds what, std::string_view before_last) {
  return extensionsOf([what](const ImageFormat& format) { return format.is_written && mayHold(format, what); },
                      before_last);
}

std::vector<std::string_view> writtenExtensionNames() {
  std::vector<std::string_view> names;
  for (const ImageFormat& format : kImageFormats)
    if (format.is_written) names.push_back(usualExtension(format));
  return names;
}

std::vector<std::string_view> writtenExtensionNames(Holds what) {
  std::vector<std::string_view> names;
  for (const ImageFormat& format : kImageFormats)
    if (format.is_written && mayHold(format, what)) names.push_back(usualExtension(format));
  return names;
}

std::string readFormatNames() {
  return namesOf([](const ImageFormat&) { return true; });
}

std::string readFormatNames(Holds what) {
  return namesOf([what](const ImageFormat& format) { return mayHold(format, what); });
}

Result<ImageFormatId> formatToWrite(const std::filesystem::path& path, std::initializer_list<Holds> wanted) {
  const std::string extension = extensionOf(path);
  const auto* const format = std::find_if(kImageFormats.begin(), kImageFormats.end(), [&](const ImageFormat& known) {
    const std::vector<std::string> extensions = split(known.extensions, ' ');
    return contains(extensions, extension);
  });
  const bool is_written = format != kImageFormats.end() && format->is_written;
  if (is_written && contains(wanted, format->holds)) return format->id;
  const std::string what = extension.empty() ? "has no extension to tell its format by"
                           : is_written      ? "would hold " + std::string(textOf(format->holds))
                                             : "is not a format that Mirrorball writes";
  return fail(ErrorCode::usage, path.string() + ": " + what + "; use " + adviceFor(wanted));
}

}  // namespace mirrorball
