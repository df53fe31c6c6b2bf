// A material's map of heights (scene/relief/height_texture.h).
#include "texture_filter.glsl"
#include "height_map.glsl"

uniform highp sampler2D heights;
uniform vec4 height_form;  // how it is wrapped; its last level; the unit of slopes; steps of a search

HeightMap heightMap() { return HeightMap(int(height_form.x), int(height_form.y)); }
