#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/exr/exr_layer_rank.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// A channel of an OpenEXR file: "R", "ViewLayer.Combined.R", ".R".
struct ExrChannelName {
  std::string name;
  bool is_subsampled = false;  ///< it has fewer samples than the image has texels
};

/// A part of an OpenEXR file, as its header names what is in it.
struct ExrPartNames {
  std::string name = {};                ///< empty: it has none
  std::string view = {};                ///< the one that the part shows: "left"
  std::vector<std::string> views = {};  ///< those that its channels show, the default view first (multiView)
  bool is_deep = false;
  std::vector<ExrChannelName> channels = {};
};

/// What the numbers of a layer are.
enum class ExrLayerKind {
  color,    ///< red, green and blue
  chroma,   ///< luminance and subsampled chroma
  grey,     ///< luminance
  numbers,  ///< no light: vectors, depths, indices
};

/// Channels that belong together: one of the images that a file holds.
struct ExrLayer {
  std::string name;  ///< no two of a file have the same
  ExrLayerKind kind = ExrLayerKind::numbers;
  int part = 0;
  std::string prefix = {};                 ///< of its channels, with the final dot
  std::vector<std::string> channels = {};  ///< without the prefix, in the image's order: R G B A; Y A; Y RY BY; X Y Z
  bool has_alpha = false;                  ///< the last of them is alpha
  bool is_plain = false;                   ///< neither its channels nor its part have a name before them
  ExrNameRank rank = {};                   ///< how much it is like the picture
  int view_rank = 0;                       ///< among the views of one layer
};

/// All images that a file holds, in its order. A layer is what stands before a channel's last dot, unless that is the
/// name's first or last character; within it go together R G B (A), in five spellings, else Y RY BY (A), else Y (A),
/// unless an X stands beside it; then X Y Z and X Y, U V W and U V. Any other channel is a layer by itself. Channels
/// without a layer are named after their part, if the file has several, else after themselves: "RGBA", "XYZ", "Z".
/// Deep parts and subsampled channels without luminance are left out.
///
/// from     OpenEXR, "Technical Introduction": Channel Names, Layers; "Reading and Writing Image Files": Layers;
///          "Storing Multi-View Images in OpenEXR Files"; the Foundry's ExrChannelNameToNuke.cpp (spellings)
std::vector<ExrLayer> exrLayers(std::span<const ExrPartNames> parts);

/// The layer that is read.
struct ExrLayerChoice {
  std::size_t index = 0;    ///< among the layers
  bool is_guessed = false;  ///< several are pictures, and none was asked for
  std::string oddity = {};  ///< what to say of it: DecodedImage::oddities
};

/// Chooses what is meant by the file: the layer that is most like a picture (exr_layer_rank.h); of the views of one,
/// the default view, else the first.
///
/// wanted   the name of a layer, in small or capital letters; empty: none is asked for
/// errors   not_found (no layer of that name; lists them); unsupported (none is a picture, and there are several)
Result<ExrLayerChoice> chooseExrLayer(std::span<const ExrLayer> layers, const std::string& wanted);

/// Their names and channels: DecodedImage::layers.
std::vector<PictureLayer> pictureLayers(std::span<const ExrLayer> layers);

}  // namespace mirrorball
