#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {

/// A picture as a .mtl names it: a map statement with its options.
struct MtlMap {
  std::vector<std::string> readings;  ///< of the file's name; empty: none is named
  glm::vec2 scale{1.0f};              ///< -s: texture coordinates are multiplied by it,
  glm::vec2 offset{0.0f};             ///< -o: and then this is added, v growing upwards
  float strength = 1.0f;              ///< -bm, of heights
  bool is_clamped = false;            ///< -clamp on: the picture is there once
  char channel = 0;                   ///< -imfchan: 'r', 'g', 'b', 'm' (alpha), 'l' or 'z'; 0: not specified
  bool has_other_range = false;       ///< -mm changes its values, which is not done

  explicit operator bool() const { return !readings.empty(); }
};

/// The pictures of a material that are read.
enum class MtlMapKind { base_color, emission, opacity, roughness, metallic, heights, normals, occlusion };
inline constexpr std::size_t kMtlMapKinds = 8;

/// A material of a .mtl: what the file says of it, and no more.
struct MtlMaterial {
  std::string name;
  std::optional<glm::vec3> diffuse;       ///< Kd
  std::optional<glm::vec3> specular;      ///< Ks
  std::optional<glm::vec3> emission;      ///< Ke
  std::optional<float> exponent;          ///< Ns
  std::optional<float> ior;               ///< Ni
  std::optional<float> dissolve;          ///< d: 1 is opaque
  std::optional<float> transparency;      ///< Tr: 0 is opaque
  std::optional<float> illumination;      ///< illum
  std::optional<float> roughness;         ///< Pr
  std::optional<float> metallic;          ///< Pm
  std::optional<float> sheen;             ///< Ps
  std::optional<float> coat;              ///< Pc
  std::optional<float> coat_roughness;    ///< Pcr
  std::optional<float> anisotropy;        ///< aniso
  std::optional<float> anisotropy_turns;  ///< anisor
  std::array<MtlMap, kMtlMapKinds> maps;
  MtlMap ambient;                     ///< map_Ka
  std::vector<std::string> left_out;  ///< other statements that change what is seen, as "map_ks"

  const MtlMap& map(MtlMapKind kind) const { return maps[std::size_t(kind)]; }
};

/// Reads the materials of a .mtl, in order. Numbers that are none, NaN or infinite count as not written.
///
/// remarks  gets lines on what is unusual
/// from     Wavefront, "MTL material format", appendix B of the Advanced Visualizer's manual; Exocortex, "Extending the
///          Wavefront MTL format for physically-based rendering" (Pr, Pm, Ps, Pc, Pcr, aniso, anisor, norm)
std::vector<MtlMaterial> readMtl(std::string_view text, std::vector<std::string>& remarks);

}  // namespace mirrorball
