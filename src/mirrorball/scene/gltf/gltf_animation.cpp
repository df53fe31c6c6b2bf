#include "mirrorball/scene/gltf/gltf_animation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_nodes.h"

// glTF 2.0, section 3.11.

namespace mirrorball::gltf {
namespace {

constexpr std::array<std::string_view, 3> kInterpolations{"STEP", "LINEAR", "CUBICSPLINE"};  // by KeyInterpolation

class AnimationReader {
 public:
  AnimationReader(const File& file, const SceneOfFile& all) : file_(file), all_(all) {}

  Result<void> read() {
    const std::vector<FileAnimation>& animations = file_.document.animations;
    for (std::size_t i = 0; i < animations.size(); ++i) {
      MIRRORBALL_TRY(animation, readAnimation(animations[i], quoted("animations", i)));
      animation.name = names_.unlike(animation.name.empty() ? "animation" : animation.name);
      all_.scene.rig.animations.push_back(std::move(animation));
    }
    if (!unread_.empty())
      warn("what its animations change by " + join(std::span<const std::string>(unread_), ", ", " and ") +
           " is left out");
    if (is_doubled_) warn("where channels of an animation change the same, all but the first are left out");
    if (moves_matrix_) warn("nodes that have a matrix stand still in its animations");
    return {};
  }

 private:
  using Floats = std::shared_ptr<const std::vector<float>>;

  void warn(const std::string& what) { file_.remarks.tell(what); }

  /// Reads an animation, and leaves out the channels that are damaged.
  ///
  /// errors   too_large
  Result<Animation> readAnimation(const FileAnimation& source, const std::string& key) {
    Animation animation;
    animation.name = source.name;
    std::set<std::string> moved;
    for (std::size_t i = 0; i < source.channels.size(); ++i) {
      const Result<void> read = addChannel(source, i, key, moved, animation);
      if (read) continue;
      if (!isDamage(read.error())) return tl::unexpected<Error>(read.error());
      file_.remarks.leaveOut(read.error(), "animation's channel");
    }
    return animation;
  }

  /// moved    what other channels of the animation move
  Result<void> addChannel(const FileAnimation& source, std::size_t index, const std::string& key,
                          std::set<std::string>& moved, Animation& animation) {
    const FileChannel& channel = source.channels[index];
    const std::string channel_key = key + "." + quoted("channels", index);
    MIRRORBALL_TRY_VOID(checkIndex(channel.sampler, source.samplers.size(), channel_key + ".sampler", "sampler"));
    if (channel.pointer.empty()) return {};
    MIRRORBALL_TRY(pointed, pointedAt(all_, channel.pointer, channel.key));
    if (!pointed.is_read) noteUnread(channel.pointer);
    dropFixedNodes(pointed.targets);
    if (pointed.targets.empty()) return {};
    if (!moved.insert(channel.pointer).second) {
      is_doubled_ = true;
      return {};
    }
    const std::string sampler_key = key + "." + quoted("samplers", std::size_t(channel.sampler));
    MIRRORBALL_TRY(sampler,
                   readSampler(source.samplers[std::size_t(channel.sampler)], pointed.components, sampler_key));
    animation.length_s = std::max(animation.length_s, sampler.times->back());
    MIRRORBALL_TRY_VOID(withName(key, file_.files.budget().take(pointed.targets.size() * sizeof(AnimationChannel))));
    for (const AnimationTarget& target : pointed.targets) animation.channels.push_back({target, sampler});
    return {};
  }

  /// A node with a matrix has no translation, rotation and scale that could be moved (section 3.5.3).
  void dropFixedNodes(std::vector<AnimationTarget>& targets) {
    const auto isFixed = [&](const AnimationTarget& target) {
      const auto* node = std::get_if<NodeTarget>(&target);
      return node != nullptr && node->of != NodeTarget::Of::weights &&
             all_.scene.rig.nodes[std::size_t(node->node)].place.matrix != glm::dmat4(1.0);
    };
    if (std::erase_if(targets, isFixed) > 0) moves_matrix_ = true;
  }

  void noteUnread(const std::string& pointer) {
    constexpr std::size_t kMostNamed = 8;
    if (unread_.size() > kMostNamed) return;
    const std::string kind = kindOfPointer(pointer);
    if (std::find(unread_.begin(), unread_.end(), kind) != unread_.end()) return;
    unread_.push_back(unread_.size() < kMostNamed ? kind : "…");
  }

  /// components   how many numbers the value has that it moves
  Result<AnimationSampler> readSampler(const FileSampler& source, std::size_t components, const std::string& key) {
    const auto way = std::find(kInterpolations.begin(), kInterpolations.end(), source.interpolation);
    if (way == kInterpolations.end())
      return fail(ErrorCode::bad_file, key + ".interpolation is '" + excerpt(source.interpolation) + "', and none of " +
                                           join(kInterpolations, ", ", " and "));
    AnimationSampler sampler{
        .times = {}, .values = {}, .interpolation = KeyInterpolation(way - kInterpolations.begin())};
    MIRRORBALL_TRY(times, floatsOf(source.input, key + ".input"));
    MIRRORBALL_TRY(kept, growingKeys(source.input, key + ".input"));
    MIRRORBALL_TRY(values, floatsOf(source.output, key + ".output"));
    const bool is_cubic = sampler.interpolation == KeyInterpolation::cubic_spline;
    const std::size_t of_each = components * (is_cubic ? 3 : 1), wanted = times->size() * of_each;
    if (values->size() != wanted)
      return fail(ErrorCode::bad_file, key + ".output has " + counted(values->size(), "number") + ", but " +
                                           counted(times->size(), "time") + " of " + counted(components, "component") +
                                           (is_cubic ? " and their slopes" : "") + " take " + std::to_string(wanted));
    if (kept) {
      MIRRORBALL_TRY_VOID(withName(key, file_.files.budget().take(kept->size() * (of_each + 1) * sizeof(float))));
      times = chosen(*times, *kept, 1);
      values = chosen(*values, *kept, of_each);
    }
    sampler.times = std::move(times);
    sampler.values = std::move(values);
    return sampler;
  }

  /// Of a list of times, the elements that count: each after the one before it. Programs that join animations write a
  /// time twice where they meet. None: all of them.
  using Keys = std::shared_ptr<const std::vector<std::uint32_t>>;

  /// An accessor is checked once, however many samplers name it.
  Result<Keys> growingKeys(int accessor, const std::string& key) {
    if (const auto known = keys_.find(accessor); known != keys_.end()) return known->second;
    if (file_.document.accessors[std::size_t(accessor)].components != 1)
      return fail(ErrorCode::bad_file, key + " is no list of times");
    const std::vector<float>& times = *floats_[accessor];
    if (times.empty()) return fail(ErrorCode::bad_file, key + " has no times");
    std::vector<std::uint32_t> keys;
    float last = -1.0f;
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] >= 0.0f && times[i] > last) {
        keys.push_back(static_cast<std::uint32_t>(i));
        last = times[i];
        continue;
      }
      file_.remarks.leaveOut(
          {ErrorCode::bad_file, key + " has the time " + formatNumber(double(times[i])) + " in element " +
                                    std::to_string(i) +
                                    (i > 0 ? ", which is not after the one before it" : ", before the start")},
          "key");
    }
    if (keys.empty()) return fail(ErrorCode::bad_file, key + " has no times after the start");
    if (keys.size() == times.size()) return keys_[accessor] = nullptr;
    MIRRORBALL_TRY_VOID(withName(key, file_.files.budget().take(keys.size() * sizeof(std::uint32_t))));
    return keys_[accessor] = std::make_shared<const std::vector<std::uint32_t>>(std::move(keys));
  }

  /// The numbers of some keys.
  static Floats chosen(const std::vector<float>& numbers, const std::vector<std::uint32_t>& keys, std::size_t of_each) {
    std::vector<float> kept;
    kept.reserve(keys.size() * of_each);
    for (const std::uint32_t key : keys) {
      const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(key * of_each);
      kept.insert(kept.end(), first, first + static_cast<std::ptrdiff_t>(of_each));
    }
    return std::make_shared<const std::vector<float>>(std::move(kept));
  }

  Result<Floats> floatsOf(int accessor, const std::string& key) {
    if (const auto known = floats_.find(accessor); known != floats_.end()) return known->second;
    MIRRORBALL_TRY_VOID(checkIndex(accessor, file_.document.accessors.size(), key, "accessor"));
    const Accessor& declared = file_.document.accessors[std::size_t(accessor)];
    if (declared.components > 4) return fail(ErrorCode::bad_file, key + " has a type that samplers cannot have");
    MIRRORBALL_TRY(numbers, readFiniteNumbers(file_, accessor, key));
    MIRRORBALL_TRY_VOID(withName(key, file_.files.budget().take(numbers.values.size() * sizeof(float))));
    return floats_[accessor] = std::make_shared<const std::vector<float>>(std::move(numbers.values));
  }

  const File& file_;
  const SceneOfFile& all_;
  Names names_;
  std::map<int, Floats> floats_;  // by accessor
  std::map<int, Keys> keys_;      // likewise
  std::vector<std::string> unread_;
  bool is_doubled_ = false;
  bool moves_matrix_ = false;
};

}  // namespace

std::vector<bool> nodesWithAnimatedWeights(const Document& document) {
  std::vector<bool> nodes(document.nodes.size(), false);
  for (const FileAnimation& animation : document.animations)
    for (const FileChannel& channel : animation.channels)
      if (const auto step = stepInto("/nodes/", channel.pointer); step && step->rest == "weights")
        if (std::size_t(step->index) < nodes.size()) nodes[std::size_t(step->index)] = true;
  return nodes;
}

Result<void> readAnimations(const File& file, const SceneOfFile& all) { return AnimationReader(file, all).read(); }

}  // namespace mirrorball::gltf
