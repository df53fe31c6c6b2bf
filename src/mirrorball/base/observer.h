#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mirrorball/base/progress.h"

namespace mirrorball {

/// What a remark is about, for callers that treat kinds differently.
enum class RemarkKind {
  light_lost,        ///< the requested format cannot hold light this bright
  light_too_bright,  ///< nor can the only kind of file that a program reads
  digits_lost,       ///< it holds only few digits of light this dark
  negative_raised,   ///< values below 0 became 0
  format_widened,    ///< written in 32-bit floats, since half floats do not hold the light
  alpha_lost,        ///< the format has no alpha
  file_odd,          ///< something in a file is unusual; the message says how it was read
  gain_map_lost,     ///< a file says that it has a gain map, which it lacks
  form_unsaid,       ///< the file does not say what map it holds; `detail` is the hint that does (FormHint)
  light_limited,     ///< LightLimits::max took so much of it
  form_doubted,      ///< something speaks against a map's form; `detail` has the hints for others, with '|' between
  levels_remade,     ///< a texture's mip levels are not those of the converted map
  levels_left_out,   ///< of its mip levels only the first is taken
  model_reduced,     ///< a model has what is not read, or what is not drawn
  body_open,         ///< a transmitting body has an open surface
  not_imported,      ///< the program that a map is for makes no light of such a file
  levels_few,        ///< there are not the mip levels that their reader expects; `detail`: how many, if a chain can
};

/// What a caller did not ask for but should know.
struct Remark {
  RemarkKind kind;
  std::string message;      ///< one line, which begins with the file's name where it is of one
  std::string detail = {};  ///< as its kind says
};

/// Functions by which work reports to its caller while it goes on. Each may be empty, and each may be called from
/// several threads at a time.
struct Observer {
  std::function<void(const Remark&)> remark = {};
  std::function<void(const std::string& path)> written = {};              ///< a file is finished
  std::function<ProgressFunction(std::string_view stage)> progress = {};  ///< of each stage that takes long
  std::function<std::function<void()>(std::string_view stage)> timing =
      {};  ///< a stage begins; what it returns ends it

  void tell(RemarkKind kind, std::string message, std::string detail = {}) const {
    if (remark) remark({kind, std::move(message), std::move(detail)});
  }
  void tellWritten(const std::string& path) const {
    if (written) written(path);
  }
  ProgressFunction progressOf(std::string_view stage) const { return progress ? progress(stage) : ProgressFunction(); }

  /// The same observer, whose remarks begin with a file's name.
  Observer named(const std::string& name) const {
    Observer naming = *this;
    if (remark)
      naming.remark = [name, told = remark](const Remark& about) {
        told({about.kind, name + ": " + about.message, about.detail});
      };
    return naming;
  }

  /// The same observer, whose remarks are also added to a list, which must outlive it.
  Observer keeping(std::vector<Remark>& remarks) const {
    Observer keeping = *this;
    keeping.remark = [&remarks, told = remark](const Remark& about) {
      remarks.push_back(about);
      if (told) told(about);
    };
    return keeping;
  }

  /// Does `work` as a stage of that name.
  template <typename Work>
  auto timed(std::string_view stage, const Work& work) const {
    const std::function<void()> end = timing ? timing(stage) : std::function<void()>();
    auto result = work();
    if (end) end();
    return result;
  }
};

}  // namespace mirrorball
