#pragma once

#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What a texture's numbers are: which of them make sense.
enum class TextureUse { factors, light, normals };
TextureUse useOf(const MaterialMap& map);

/// Gives a texture what its file holds. Codes stay as they are. Floats are linear; what is not finite becomes the mean
/// of its neighbours; factors are cut to 0 … 1 and light to 0 … 65504; normals stay as they are, but blue, where the
/// file has none, becomes that of unit normals. Grey normals stay, and are reported.
///
/// texels   4 channels
/// returns  what was changed, for remarks: "has …"
/// errors   non_finite: no texel is finite
Result<std::vector<std::string>> setTexels(Texels texels, TextureUse use, Texture& texture);

/// Whether all texels are grey, as those of heights are and hardly any normals.
bool isGrey(const SharedPicture& picture);

/// Whether a picture of which that is not known is a normal map: most of the texels that have a colour are unit vectors
/// that lean by less than 60° from the surface's. Texels that are nearly grey say nothing: a JPEG of heights has
/// others, and what lies beside the charts of a map is black.
bool looksLikeNormals(const SharedPicture& picture);

/// The normals of a map as signed numbers of any length: 3 channels.
Image decodedNormals(const SharedPicture& map, float zero);

/// What stands for 0 in a normal map: `Material::normal_zero`.
///
/// returns  128 where the most frequent texel is (128, 128, 255) of 255, with which programs say "flat", though by
///          glTF's rule it leans by 0.3°; of floats 0 where some are negative, or where all are nearer to unit vectors
///          as they are than decoded; else 127.5, glTF's
/// cost     isNeutralAt128()'s; of floats 10 ns a texel
float findNormalZero(const SharedPicture& map);

/// Sets what stands for 0 in every normal map of a scene, and adds one remark to its warnings where that is 128.
///
/// name     what has the maps, for the remark
/// only     the row of the maps to look at; nullptr: all
void findNormalZeros(Scene& scene, const std::string& name, const MaterialMap* only = nullptr);

}  // namespace mirrorball
