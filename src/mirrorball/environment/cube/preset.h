#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/cube/cube_arrangement.h"
#include "mirrorball/environment/file/face_files.h"
#include "mirrorball/environment/file/map_form.h"

namespace mirrorball {

/// How another program stores environment maps in files. docs/conventions.md has the table with each row's source.
struct Preset {
  std::string_view name;                ///< "three"
  std::string_view program;             ///< "three.js"
  std::optional<CubeArrangement> cube;  ///< nothing if it has no cube maps
  SignedAxis centre;                    ///< our direction in the middle of its upright panoramas
  CubeLayout layout;                    ///< of a cube, by default
  FaceNaming naming = FaceNaming::px;   ///< of a cube's six files
  bool has_texels_on_edges = false;     ///< MapForm::has_texels_on_edges
  bool reads_primaries = false;         ///< of a file that states others than Rec.709's
  // Which files the program makes light of, by their extensions: "hdr exr". Empty: any, or not known.
  std::string_view panorama_files = {};
  std::string_view cube_files = {};
};

/// What a program imports instead of a map in such a file: "Unreal Engine makes light of a panorama in .hdr and of a
/// cube in .dds, not of a panorama in .dds".
///
/// extension   of the file, without its dot
/// returns     nothing if it imports that, or if it is not known
std::optional<std::string> importedInstead(const Preset& preset, Projection projection, std::string_view extension);

/// opengl, vulkan, directx, unity, unreal, godot, filament, three, babylon, playcanvas, gltf, blender, renderman,
/// openexr, quake, krpano, ogre
std::span<const Preset> presets();

/// Their names, in that order.
std::span<const std::string_view> presetNames();

/// The preset of a program, also by its other names: "threejs", "dx".
///
/// errors   usage: lists the names
Result<Preset> presetNamed(std::string_view name);

/// The form in which a program expects a map.
///
/// layout   of a cube; Preset::layout by default
/// errors   usage: the program has no such maps, or the preset does not define that projection
Result<MapForm> formFor(const Preset& preset, Projection projection, CubeLayout layout);

}  // namespace mirrorball
