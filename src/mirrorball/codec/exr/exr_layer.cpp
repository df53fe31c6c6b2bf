#include "mirrorball/codec/exr/exr_layer.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

using Spelling = std::span<const std::string_view>;

/// Red, green, blue and alpha, as the Foundry's ExrChannelNameToNuke.cpp knows them: OpenEXR's own, RenderMan's
/// "Ci.r", V-Ray's "diffuse.red".
constexpr std::array<std::array<std::string_view, 4>, 5> kColorSpellings{{{"R", "G", "B", "A"},
                                                                          {"r", "g", "b", "a"},
                                                                          {"red", "green", "blue", "alpha"},
                                                                          {"Red", "Green", "Blue", "Alpha"},
                                                                          {"RED", "GREEN", "BLUE", "ALPHA"}}};
constexpr std::array<std::string_view, 3> kChroma{"Y", "RY", "BY"};
constexpr std::array<std::string_view, 1> kLuminance{"Y"};
constexpr std::array<std::string_view, 1> kRed{"R"};
constexpr std::array<std::array<std::string_view, 3>, 4> kTriples{
    {{"X", "Y", "Z"}, {"x", "y", "z"}, {"U", "V", "W"}, {"u", "v", "w"}}};
constexpr std::array<std::array<std::string_view, 2>, 4> kPairs{{{"X", "Y"}, {"x", "y"}, {"U", "V"}, {"u", "v"}}};

/// The channels with one prefix that no layer has taken yet: their names without it, and whether they are subsampled.
class ChannelGroup {
 public:
  void add(std::string name, bool is_subsampled) { channels_.push_back({std::move(name), is_subsampled}); }
  bool has(std::string_view name) const { return find(name) != channels_.end(); }

  /// Takes all these channels, and the alpha if there is one; else none.
  std::optional<ExrLayer> take(ExrLayerKind kind, Spelling names, std::string_view alpha = {}) {
    const auto usable = [&](std::string_view name) {
      const auto found = find(name);
      return found != channels_.end() && (kind == ExrLayerKind::chroma || !found->is_subsampled);
    };
    if (!std::all_of(names.begin(), names.end(), usable)) return {};
    ExrLayer layer{.name = {}, .kind = kind};
    layer.channels.assign(names.begin(), names.end());
    layer.has_alpha = !alpha.empty() && usable(alpha);
    if (layer.has_alpha) layer.channels.emplace_back(alpha);
    for (const std::string& taken : layer.channels) channels_.erase(find(taken));
    return layer;
  }

  /// Takes what is left, each channel by itself.
  std::vector<ExrLayer> takeEach() {
    std::vector<ExrLayer> layers;
    for (Channel& channel : std::exchange(channels_, {}))
      if (!channel.is_subsampled) layers.push_back({.name = {}, .channels = {std::move(channel.name)}});
    return layers;
  }

 private:
  struct Channel {
    std::string name;
    bool is_subsampled;
  };
  std::vector<Channel>::const_iterator find(std::string_view name) const {
    return std::find_if(channels_.begin(), channels_.end(), [&](const Channel& c) { return c.name == name; });
  }

  std::vector<Channel> channels_;
};

/// The picture of a group, if it has one. OpenEXR's reader of luminance and chroma takes a file's first part only.
std::optional<ExrLayer> takePicture(ChannelGroup& group, bool may_have_chroma) {
  for (const auto& names : kColorSpellings)
    if (auto color = group.take(ExrLayerKind::color, Spelling(names).first(3), names[3])) return color;
  if (may_have_chroma)
    if (auto chroma = group.take(ExrLayerKind::chroma, kChroma, "A")) return chroma;
  // Beside an X it is the second coordinate of a vector (tinyexr#178).
  if (!group.has("X"))
    if (auto grey = group.take(ExrLayerKind::grey, kLuminance, "A")) return grey;
  // Of grey pictures some programs write the first channel alone (openexr#1946).
  if (!group.has("G") && !group.has("B")) return group.take(ExrLayerKind::grey, kRed, "A");
  return {};
}

/// All layers of a group, its picture first.
std::vector<ExrLayer> takeAll(ChannelGroup group, bool may_have_chroma) {
  std::vector<ExrLayer> layers;
  if (auto picture = takePicture(group, may_have_chroma)) layers.push_back(std::move(*picture));
  for (const auto& names : kTriples)
    if (auto triple = group.take(ExrLayerKind::numbers, names)) layers.push_back(std::move(*triple));
  for (const auto& names : kPairs)
    if (auto pair = group.take(ExrLayerKind::numbers, names)) layers.push_back(std::move(*pair));
  for (ExrLayer& single : group.takeEach()) layers.push_back(std::move(single));
  return layers;
}

/// The length of a channel's prefix with its final dot. A dot that begins or ends a name parts nothing
/// ("Reading and Writing Image Files", Layers): V-Ray's ".R" is the plain R (tev#168), with a prefix all the same.
std::size_t prefixLength(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos || dot + 1 == name.size() ? 0 : dot + 1;
}

/// Groups by their prefixes, in the order of the file.
std::vector<std::pair<std::string, ChannelGroup>> grouped(const ExrPartNames& part) {
  std::vector<std::pair<std::string, ChannelGroup>> groups;
  std::map<std::string, std::size_t> places;
  for (const ExrChannelName& channel : part.channels) {
    const std::size_t length = prefixLength(channel.name);
    const auto [place, is_new] = places.try_emplace(channel.name.substr(0, length), groups.size());
    if (is_new) groups.emplace_back(place->first, ChannelGroup());
    groups[place->second].second.add(channel.name.substr(length), channel.is_subsampled);
  }
  return groups;
}

/// "RGBA" of R G B A.
std::string joined(const ExrLayer& layer) { return join(layer.channels, ""); }

std::string withoutDots(std::string_view prefix) {
  const std::size_t begin = std::min(prefix.find_first_not_of('.'), prefix.size());
  return std::string(prefix.substr(begin, prefix.empty() ? 0 : prefix.find_last_not_of('.') + 1 - begin));
}

/// Names each layer of a group: the first by the group, the others by their channels too.
///
/// group    "ViewLayer.Combined"; empty: the plain channels of a file of one part
void nameLayers(const std::string& group, std::vector<ExrLayer>& layers) {
  const auto is_main = [&](const ExrLayer& layer) {
    return layer.kind != ExrLayerKind::numbers || layer.channels.size() > 1 || layers.size() == 1;
  };
  for (std::size_t i = 0; i < layers.size(); ++i) {
    ExrLayer& layer = layers[i];
    if (group.empty())
      layer.name = joined(layer);
    else
      layer.name = i == 0 && is_main(layer) ? group : group + "." + joined(layer);
  }
}

/// Whether a word of a layer's name is that of a view, and which one.
class Views {
 public:
  explicit Views(const ExrPartNames& part) : names_(part.views) {
    if (!part.view.empty()) names_.push_back(part.view);
    // Those that must be called so, whether a multiView attribute is there or not.
    for (const char* name : {"left", "right"})
      if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.emplace_back(name);
  }

  std::optional<int> find(const std::string& word) const {
    const auto found = std::find(names_.begin(), names_.end(), word);
    if (found == names_.end()) return {};
    return static_cast<int>(found - names_.begin());
  }

 private:
  std::vector<std::string> names_;
};

/// Ranks a layer by the words of its name.
void rankLayer(const Views& views, const std::string& group, ExrLayer& layer) {
  std::vector<std::string> words;
  for (std::string& word : split(group, '.')) {
    if (const auto view = views.find(word))
      layer.view_rank = *view;
    else if (!word.empty())
      words.push_back(std::move(word));
  }
  layer.is_plain = words.empty();
  if (layer.kind == ExrLayerKind::numbers) return;
  layer.rank = exrNameRank(words);
  if (layer.kind != ExrLayerKind::grey) return;
  ExrLayerRank& rank = layer.rank.rank;
  if (rank == ExrLayerRank::plain) rank = ExrLayerRank::plain_grey;
  if (rank == ExrLayerRank::unknown) rank = ExrLayerRank::aid;  // a mask more likely than a picture: "Object_0.Y"
}

/// What a group is called: its prefix, with the part's name where that is not in it already.
std::string groupName(const ExrPartNames& part, bool has_several_parts, const std::string& prefix) {
  std::string name = withoutDots(prefix);
  if (!has_several_parts || part.name.empty() || name == part.name || name.starts_with(part.name + ".")) return name;
  return name.empty() ? part.name : part.name + "." + name;
}

/// Adds " #2" to a name that an earlier layer has.
void makeNamesDiffer(std::vector<ExrLayer>& layers) {
  std::map<std::string, int> counts;
  for (ExrLayer& layer : layers)
    for (int count = ++counts[layer.name]; count > 1; count = ++counts[layer.name])
      layer.name += " #" + std::to_string(count);
}

/// "AO (R G B), Normal (X Y Z)", of the first ones.
std::string listed(const std::vector<const ExrLayer*>& layers, bool with_channels) {
  constexpr std::size_t kMost = 12;
  std::vector<std::string> names;
  for (const ExrLayer* layer : layers) {
    if (names.size() == kMost) break;
    const bool says_more = with_channels && layer->name != joined(*layer);
    names.push_back(excerpt(layer->name) + (says_more ? " (" + excerpt(join(layer->channels, " ")) + ")" : ""));
  }
  const std::size_t more = layers.size() - names.size();
  return join(names) + (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

Result<std::size_t> layerNamed(std::span<const ExrLayer> layers, const std::string& wanted) {
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (layers[i].name == wanted) return i;
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (lowerCase(layers[i].name) == lowerCase(wanted)) return i;
  constexpr std::size_t kMostListed = 100;
  std::vector<std::string_view> names;
  for (const ExrLayer& layer : layers.first(std::min(layers.size(), kMostListed))) names.push_back(layer.name);
  Error error = unknownName("layer", wanted, names);
  error.code = ErrorCode::not_found;
  return tl::unexpected<Error>(std::move(error));
}

/// A choice that nobody asked for, and the remark on it.
ExrLayerChoice guess(std::span<const ExrLayer> layers, std::size_t index) {
  const ExrLayer& taken = layers[index];
  std::vector<const ExrLayer*> pictures;
  for (const ExrLayer& layer : layers)
    if (layer.rank.rank < ExrLayerRank::aid) pictures.push_back(&layer);
  ExrLayerChoice choice{.index = index};
  if (pictures.size() > 1) {
    choice.is_guessed = true;
    choice.oddity = "has several pictures (" + listed(pictures, false) + "): " + excerpt(taken.name) + " was read";
  } else if (pictures.empty()) {
    choice.is_guessed = layers.size() > 1;
    choice.oddity = "has no picture by the names of its layers: " + excerpt(taken.name) + " was read";
  } else if (taken.kind == ExrLayerKind::grey && taken.channels.front() == kRed[0]) {
    choice.oddity = "has red without green and blue: read as grey";
  }
  return choice;
}

}  // namespace

std::vector<ExrLayer> exrLayers(std::span<const ExrPartNames> parts) {
  std::vector<ExrLayer> all;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].is_deep) continue;
    const Views views(parts[p]);
    for (auto& [prefix, channels] : grouped(parts[p])) {
      const std::string group = groupName(parts[p], parts.size() > 1, prefix);
      std::vector<ExrLayer> layers = takeAll(std::move(channels), p == 0 && prefix != ".");
      nameLayers(group, layers);
      for (ExrLayer& layer : layers) {
        layer.part = static_cast<int>(p);
        layer.prefix = prefix;
        rankLayer(views, group, layer);
        all.push_back(std::move(layer));
      }
    }
  }
  makeNamesDiffer(all);
  return all;
}

Result<ExrLayerChoice> chooseExrLayer(std::span<const ExrLayer> layers, const std::string& wanted) {
  if (!wanted.empty()) {
    MIRRORBALL_TRY(index, layerNamed(layers, wanted));
    return ExrLayerChoice{.index = index};
  }
  const auto order = [](const ExrLayer& layer) {
    return std::tuple(layer.rank.rank, layer.rank.order, layer.kind == ExrLayerKind::grey, layer.view_rank);
  };
  const auto best = std::min_element(layers.begin(), layers.end(),
                                     [&](const ExrLayer& a, const ExrLayer& b) { return order(a) < order(b); });
  if (layers.empty())
    return fail(ErrorCode::unsupported, "has no channels that can be read: all are deep or subsampled");
  const bool is_only = layers.size() == 1 && best->kind != ExrLayerKind::numbers;
  if (best->rank.rank == ExrLayerRank::numbers && !is_only) {
    std::vector<const ExrLayer*> all;
    for (const ExrLayer& layer : layers) all.push_back(&layer);
    return fail(ErrorCode::unsupported, "has no picture among its layers: " + listed(all, true) +
                                            "; name the layer that is to be read all the same");
  }
  return guess(layers, static_cast<std::size_t>(best - layers.begin()));
}

std::vector<PictureLayer> pictureLayers(std::span<const ExrLayer> layers) {
  std::vector<PictureLayer> named;
  for (const ExrLayer& layer : layers) named.push_back({layer.name, join(layer.channels, " ")});
  return named;
}

}  // namespace mirrorball
