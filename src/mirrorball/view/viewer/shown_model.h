#pragma once

#include <optional>
#include <string>
#include <utility>

#include "mirrorball/render/settings/quality.h"
#include "mirrorball/view/viewer/file_watch.h"
#include "mirrorball/view/viewer/loading.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// The model of a workspace, which stands as that says and has the materials that it asks for. Loaded beside its owner;
/// until another is there, the one before is shown.
class ShownModel {
 public:
  /// Begins to load what the workspace asks for, takes what was loaded, and changes it.
  ///
  /// returns   whether it is another model than before
  bool follow(const Workspace& workspace, bool inside_only);

  /// Loads it again if a file of it has changed, when it is next asked for.
  void askDisk() {
    if (watch_.hasChanged()) loading_.forget();
  }

  bool isThere() const { return version_ > 0; }
  /// Whether it is all that the workspace asks for, or problem() says why not.
  bool isUpToDate(const Workspace& workspace) const;
  /// Counts its changes.
  int version() const { return version_; }
  const Scene& scene() const { return changed_; }
  /// The model as its file has it, with its animations.
  const Scene& rest() const { return loaded_; }
  /// The levels of its textures, once: who shows it first need not make them.
  LevelsOfMaps takeLevels() { return std::exchange(levels_, {}); }
  SceneTraits traits() const;
  /// The scene as Workspace::materials says, without Workspace::parameters.
  const Scene& withoutParameters() const { return optioned_; }

  const LoadingByName<LoadedModel>& loading() const { return loading_; }
  /// Why it is not what was asked for; empty: it is.
  const std::string& problem() const { return loading_.problem().empty() ? problem_ : loading_.problem(); }

 private:
  bool take();
  bool isAs(const Workspace& workspace) const;
  Result<void> changeTo(const Workspace& workspace);

  LoadingByName<LoadedModel> loading_;
  Scene loaded_;    // as the file has it
  Scene standing_;  // that, as Workspace::stance says
  Scene optioned_;  // and that, as Workspace::materials says
  Scene changed_;   // and that, as Workspace::parameters says
  LevelsOfMaps levels_;
  bool hides_itself_ = false;
  GivenTexts standing_for_;
  GivenTexts optioned_for_;
  std::optional<Workspace> changed_for_;  // nothing: the materials are the file's
  std::string problem_;
  FileWatch watch_;
  int version_ = 0;
};

}  // namespace mirrorball
