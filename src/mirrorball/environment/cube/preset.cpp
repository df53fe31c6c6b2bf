#include "mirrorball/environment/cube/preset.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr auto kAliases = std::to_array<Alias>({{"gl", "opengl"},
                                                {"vk", "vulkan"},
                                                {"dx", "directx"},
                                                {"d3d", "directx"},
                                                {"direct3d", "directx"},
                                                {"ue", "unreal"},
                                                {"ue5", "unreal"},
                                                {"threejs", "three"},
                                                {"three.js", "three"},
                                                {"exr", "openexr"},
                                                {"babylonjs", "babylon"},
                                                {"babylon.js", "babylon"},
                                                {"pc", "playcanvas"},
                                                {"glb", "gltf"},
                                                {"source", "quake"},
                                                {"goldsrc", "quake"},
                                                {"marzipano", "krpano"},
                                                {"pano2vr", "krpano"},
                                                {"photo-sphere-viewer", "krpano"}});

/// OpenGL's table in the axes by which a program looks its cubes up.
CubeArrangement tableIn(const WorldAxes& axes) { return inWorld(CubeArrangement{}, axes); }

const std::array<Preset, 17>& table() {
  using enum SignedAxis;
  const CubeArrangement ours;
  // OpenGL 4.3, table 8.18; Vulkan 1.3, "Cube Map Face Selection"; Direct3D 11.3 functional specification, 7.18: the
  // one table, in whatever axes the program uses. None of the three has panoramas. Left-handed worlds see the table's
  // images as pictures: UnityGLTF (SchemaExtensions.cs) takes our (x, y, z) to (-x, y, z), Unreal's GLTFCore
  // (ConversionUtilities.h) to (x, z, y).
  const CubeArrangement x_mirrored = tableIn({.x = minus_x});
  const CubeArrangement z_up = tableIn({.x = plus_x, .y = plus_z, .z = plus_y});
  static const std::array<Preset, 17> presets{{
      {"opengl", "OpenGL", ours, plus_z, CubeLayout::faces},
      {"vulkan", "Vulkan", ours, plus_z, CubeLayout::faces},
      {"directx", "Direct3D", ours, plus_z, CubeLayout::faces},
      // Skybox-Panoramic.shader: u = 1/2 - atan2(z, x) / 2 pi in Unity's axes.
      // IHVImageFormatImporter, which reads .dds and .ktx, is documented for Texture2D alone.
      {"unity", "Unity", x_mirrored, minus_x, CubeLayout::faces, FaceNaming::px, false, false, "hdr exr png jpg tif",
       "hdr exr png jpg tif"},
      // TextureCompressorModule.cpp, LookupLongLat: u = 1/2 + atan2(x, -y) / 2 pi in Unreal's axes.
      // TextureFactory makes a Texture Cube of a .hdr panorama, InterchangeDDSTranslator one of a .dds cube.
      {"unreal", "Unreal Engine", z_up, minus_z, CubeLayout::faces, FaceNaming::px, false, false, "hdr", "dds"},
      // sky.glsl: u = atan2(x, -z) / 2 pi. ResourceImporterLayeredTexture cuts one picture into the six faces.
      // It has importers of pictures, and loads .dds as it is; of .ktx2 it reads no cubes.
      {"godot", "Godot", ours, plus_z, CubeLayout::tiles, FaceNaming::px, false, false, "hdr exr png jpg webp dds ktx2",
       "hdr exr png jpg webp dds"},
      // cmgen (CubemapUtils.cpp, mirrorCubemap and equirectangularToCubemap): u = 1/2 + atan2(-x, z) / 2 pi, and cubes
      // by the table, at which the shaders look with world directions (surface_light_indirect.fs).
      {"filament", "Filament", ours, plus_z, CubeLayout::faces},
      // envmap_fragment.glsl.js: textureCube(envMap, (-x, y, z)), and u = 1/2 + atan2(z, x) / 2 pi.
      {"three", "three.js", x_mirrored, plus_x, CubeLayout::faces},
      // Its glTF loader takes our (x, y, z) to (-x, y, z); CalcProjectionSpherical (panoramaToCubemap.ts) and the names
      // of its faces make u = 1/2 + atan2(x, z) / 2 pi in those axes.
      {"babylon", "Babylon.js", x_mirrored, plus_z, CubeLayout::faces},
      // reflectionCube.js: a cube is read at (-x, y, z); spherical.js: u = 1/2 + atan2(-x, z) / 2 pi.
      {"playcanvas", "PlayCanvas", x_mirrored, plus_z, CubeLayout::faces},
      // It has our axes, and no maps but those in EXT_lights_image_based.
      {"gltf", "glTF", std::nullopt, plus_z, CubeLayout::faces},
      // Cycles, camera/projection.h: u = 1/2 - atan2(y, x) / 2 pi in Blender's axes, our (x, -z, y).
      // Of .dds it reads pictures of 8 bits alone (imbuf), of .ktx and .ktx2 nothing.
      {"blender", "Blender", std::nullopt, plus_x, CubeLayout::faces, FaceNaming::px, false, false,
       "hdr exr png jpg tif webp", ""},
      // RISpec 3.2, RiMakeCubeFaceEnvironment, as Aqsis has it (cubeenvironmentsampler.h): OpenGL's table came from
      // there. OpenUSD's hdPrman (light.cpp) turns a dome light so that OpenEXR's directions hold.
      {"renderman", "RenderMan", ours, plus_z, CubeLayout::faces},
      // ImfEnvmap.h: the faces are pictures seen from inside, those of +-Y upright for an eye that looks along -Z.
      {"openexr", "OpenEXR",
       CubeArrangement{{{{plus_x, plus_z, minus_y},
                         {minus_x, minus_z, minus_y},
                         {plus_y, plus_x, minus_z},
                         {minus_y, plus_x, plus_z},
                         {plus_z, minus_x, minus_y},
                         {minus_z, plus_x, minus_y}}}},
       plus_z, CubeLayout::vstrip, FaceNaming::signs, true, true},
      // Quake III, tr_sky.c: sky_texorder, st_to_vec and MakeSkyVec, the same as in Quake II (gl_warp.c); the suffixes
      // in tr_shader.c. Its (x, y, z) is our (x, z, -y): rt is in +x, lf in -x, bk in +y and ft in -y, each as an eye
      // sees it, which has rt at the left of ft. GoldSrc and Source have kept it (vbsp/cubemap.cpp).
      {"quake", "Quake",
       CubeArrangement{{{{plus_x, plus_z, minus_y},
                         {minus_x, minus_z, minus_y},
                         {plus_y, plus_z, plus_x},
                         {minus_y, plus_z, minus_x},
                         {plus_z, minus_x, minus_y},
                         {minus_z, plus_x, minus_y}}}},
       plus_z, CubeLayout::faces, FaceNaming::quake},
      // Its documentation of <image>: the sides l f r b u d, as an eye sees them that looks along f, with u above it
      // and d below; panoramas with f in their middle. Marzipano, Pannellum and Photo Sphere Viewer read the same
      // images.
      {"krpano", "krpano", x_mirrored, plus_z, CubeLayout::faces, FaceNaming::letters},
      // OgreTextureUnitState.cpp, setCubicTextureName; OgreSceneManager.cpp, createSkyboxPlane: fr is in -z, the others
      // around it as an eye sees them.
      {"ogre", "OGRE", tableIn({.z = minus_z}), plus_z, CubeLayout::faces, FaceNaming::ogre},
  }};
  return presets;
}

}  // namespace

std::span<const Preset> presets() { return table(); }

std::span<const std::string_view> presetNames() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const Preset& preset : presets()) all.push_back(preset.name);
    return all;
  }();
  return names;
}

Result<Preset> presetNamed(std::string_view name) {
  if (const auto index = indexOfName(name, presetNames(), kAliases)) return presets()[*index];
  return tl::unexpected<Error>(unknownName("program", name, presetNames()));
}

std::optional<std::string> importedInstead(const Preset& preset, Projection projection, std::string_view extension) {
  const bool is_cube = faceCount(projection) == 6;
  const auto listed = [](std::string_view files) { return split(files, ' '); };
  const std::vector<std::string> taken = listed(is_cube ? preset.cube_files : preset.panorama_files);
  const std::string_view written = extension == "jpeg" ? "jpg" : extension == "tiff" ? "tif" : extension;
  if ((is_cube ? preset.cube_files : preset.panorama_files).empty() || contains(taken, written)) return std::nullopt;
  const auto named = [&](std::string_view what, std::string_view files) {
    return "a " + std::string(what) + " in ." + join(listed(files), " or .");
  };
  std::string text = std::string(preset.program) + " makes light of " + named("panorama", preset.panorama_files);
  if (!preset.cube_files.empty()) text += " and of " + named("cube", preset.cube_files);
  return text + ", not of a " + (is_cube ? "cube" : "panorama") + " in ." + std::string(extension);
}

Result<MapForm> formFor(const Preset& preset, Projection projection, CubeLayout layout) {
  const std::string program(preset.program);
  MapForm form{projection, layout};
  form.has_texels_on_edges = preset.has_texels_on_edges;
  if (projection == Projection::equirect) {
    form.centre = preset.centre;
    return form;
  }
  if (faceCount(projection) != 6 || (projection == Projection::eac && form.has_texels_on_edges))
    return fail(ErrorCode::usage, "for " + program + " only cubes and panoramas are known, no map of projection " +
                                      std::string(nameOf(projection)) + "; leave '" + std::string(preset.name) +
                                      "' out");
  if (!preset.cube)
    return fail(ErrorCode::usage, program + " has no cube maps; give it a panorama", FixHint::convert_to_panorama);
  if (form.has_texels_on_edges && layout != CubeLayout::faces && layout != preset.layout)
    return fail(ErrorCode::usage, program + " has cubes in the layout " + std::string(nameOf(preset.layout)) +
                                      " (or faces) only, not " + std::string(nameOf(layout)));
  form.arrangement = *preset.cube;
  return form;
}

}  // namespace mirrorball
