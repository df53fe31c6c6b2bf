// A material's map of heights (scene/relief/height_texture.h).
#include "texture_wrap.glsl"
#include "height_map.glsl"

uniform highp sampler2D heights;
uniform vec4 height_map;   // its size; how it is wrapped; its last level
uniform vec2 height_form;  // the unit of slopes; steps of a search

HeightMap heightMap() { return HeightMap(height_map.xy, int(height_map.z), int(height_map.w)); }

vec2 heightMapSize() { return height_map.xy; }
