#include "mirrorball/output/lamps/lamp_snippet.h"

#include <array>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/output/lamps/directional_light.h"

namespace mirrorball {
namespace {

std::string numbersText(std::span<const float> numbers) {
  std::vector<std::string> texts;
  for (const float number : numbers) texts.push_back(formatNumber(double(number)));
  return join(texts);
}

std::string vectorText(glm::vec3 v) { return numbersText(std::span(&v.x, 3)); }

std::string numberText(float number) { return formatNumber(double(number)); }

/// One line of code for each lamp after a heading.
std::string snippetOf(std::span<const MapLamp> lamps, std::string heading,
                      std::string (*lines)(const DirectionalLight&)) {
  for (const DirectionalLight& light : directionalLights(lamps)) heading += "\n" + lines(light);
  return heading;
}

// three.js, lights_physical_pars_fragment.glsl.js: a light's colour times intensity times n.l is irradiance, and
// BRDF_Lambert divides by pi. A light shines from its position towards its target, the origin at first.
constexpr const char* kThreeHeading =
    "// Lamps of a map for three.js, in a `scene` whose scene.environment is the map without them, as\n"
    "// mirrorball writes it --for three. Axes: three's, +Y up. Unit: color times intensity is the irradiance of a\n"
    "// surface that faces the lamp, as in RE_Direct_Physical (lights_physical_pars_fragment.glsl.js).\n"
    "import * as THREE from 'three';\n";

std::string threeLines(const DirectionalLight& light) {
  return "{\n  // " + light.name + ", " + numberText(glm::degrees(light.angular_size_rad)) +
         " degrees wide\n  const lamp = new THREE.DirectionalLight(new THREE.Color(" + vectorText(light.color) + "), " +
         numberText(light.intensity) + ");\n  lamp.position.set(" + vectorText(light.towards) +
         ").multiplyScalar(100);\n  lamp.castShadow = true;\n  scene.add(lamp);\n}\n";
}

// Babylon.js, pbrDirectLightingFunctions.fx: computeDiffuseLighting divides by pi, so that a light's diffuse colour
// times intensity is irradiance. Its direction is the way that the light goes.
constexpr const char* kBabylonHeading =
    "// Lamps of a map for Babylon.js, in a right-handed `scene` (scene.useRightHandedSystem = true), lit by the map\n"
    "// without them. In a left-handed scene, as Babylon's default is, turn the sign of each direction's z.\n"
    "// Axes: +Y up; direction is the way that light goes. Unit: diffuse times intensity is the irradiance of a\n"
    "// surface that faces the lamp, as in computeDiffuseLighting (pbrDirectLightingFunctions.fx).\n"
    "import { Color3, DirectionalLight, Vector3 } from '@babylonjs/core';\n";

std::string babylonLines(const DirectionalLight& light) {
  const std::string color = "new Color3(" + vectorText(light.color) + ")";
  return "{\n  // " + numberText(glm::degrees(light.angular_size_rad)) + " degrees wide\n" +
         "  const lamp = new DirectionalLight('" + light.name + "', new Vector3(" + vectorText(-light.towards) +
         "), scene);\n  lamp.diffuse = " + color + ";\n  lamp.specular = " + color +
         ";\n  lamp.intensity = " + numberText(light.intensity) + ";\n}\n";
}

// Godot 4, light_storage.cpp: without physical light units the energy is multiplied by pi, and the colour is taken from
// sRGB to linear light. A light shines along its own -Z.
constexpr const char* kGodotHeading =
    "# Lamps of a map for Godot 4: a script of a node under which they are made; the sky is the map without them, as\n"
    "# mirrorball writes it --for godot. Axes: Godot's, +Y up; a light shines along its -Z. Unit: light_energy is\n"
    "# irradiance / pi, since Godot multiplies it by pi (light_storage.cpp); with physical light units set\n"
    "# light_intensity_lux to light_energy * PI, and light_energy to 1.\n"
    "extends Node3D\n\nfunc _ready() -> void:\n"
    "\tfor lamp in LAMPS:\n"
    "\t\tvar light := DirectionalLight3D.new()\n"
    "\t\tlight.light_color = lamp.color.linear_to_srgb()\n"
    "\t\tlight.light_energy = lamp.irradiance / PI\n"
    "\t\tlight.light_angular_distance = lamp.degrees\n"
    "\t\tlight.shadow_enabled = true\n"
    "\t\tlight.sky_mode = DirectionalLight3D.SKY_MODE_LIGHT_ONLY\n"
    "\t\tadd_child(light)\n"
    "\t\tvar up := Vector3.UP if absf(lamp.towards.y) < 0.99 else Vector3.BACK\n"
    "\t\tlight.basis = Basis.looking_at(-lamp.towards, up)\n\n"
    "const LAMPS := [";

std::string godotLines(const DirectionalLight& light) {
  return "\t{\"towards\": Vector3(" + vectorText(light.towards) + "), \"color\": Color(" + vectorText(light.color) +
         "), \"irradiance\": " + numberText(light.intensity) +
         ", \"degrees\": " + numberText(glm::degrees(light.angular_size_rad)) + "},";
}

std::string godotSnippet(std::span<const MapLamp> lamps) {
  return snippetOf(lamps, kGodotHeading, godotLines) + "\n]\n";
}

// Blender, SunLight.energy: strength in W/m2, the irradiance of a surface that faces it; angle is its diameter. The
// light shines along its own -Z. Our (x, y, z) is Blender's (x, -z, y).
constexpr const char* kBlenderHeading =
    "# Lamps of a map for Blender: run it as a script; the world is the map without them, as mirrorball writes it\n"
    "# --for blender. Axes: Blender's, +Z up; a sun shines along its -Z. Unit: the strength of a sun is the "
    "irradiance\n"
    "# of a surface that faces it (W/m2, bpy.types.SunLight.energy), angle its diameter.\n"
    "import bpy\nfrom mathutils import Vector\n\n"
    "def add_sun(name, towards, color, strength, angle):\n"
    "    light = bpy.data.lights.new(name, 'SUN')\n"
    "    light.color = color\n"
    "    light.energy = strength\n"
    "    light.angle = angle\n"
    "    sun = bpy.data.objects.new(name, light)\n"
    "    sun.rotation_mode = 'QUATERNION'\n"
    "    sun.rotation_quaternion = Vector(towards).to_track_quat('Z', 'Y')\n"
    "    bpy.context.collection.objects.link(sun)\n\n";

std::string blenderLines(const DirectionalLight& light) {
  const glm::vec3 towards(light.towards.x, -light.towards.z, light.towards.y);
  return "add_sun('" + light.name + "', (" + vectorText(towards) + "), (" + vectorText(light.color) + "), " +
         numberText(light.intensity) + ", " + numberText(light.angular_size_rad) + ")";
}

constexpr auto kSnippets = std::to_array<LampSnippet>({
    {"three", "three.js", ".three.js",
     [](std::span<const MapLamp> lamps) { return snippetOf(lamps, kThreeHeading, threeLines); }},
    {"babylon", "Babylon.js", ".babylon.js",
     [](std::span<const MapLamp> lamps) { return snippetOf(lamps, kBabylonHeading, babylonLines); }},
    {"godot", "Godot", ".gd", godotSnippet},
    {"blender", "Blender", ".py",
     [](std::span<const MapLamp> lamps) { return snippetOf(lamps, kBlenderHeading, blenderLines) + "\n"; }},
});

}  // namespace

std::span<const LampSnippet> lampSnippets() { return kSnippets; }

const LampSnippet* lampSnippetFor(std::string_view name) {
  for (const LampSnippet& snippet : kSnippets)
    if (snippet.name == name) return &snippet;
  return nullptr;
}

}  // namespace mirrorball
