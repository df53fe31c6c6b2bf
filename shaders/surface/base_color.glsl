// The base colour of a material at a point, and its opacity.
vec4 colorAt(SurfacePoint point) {
  return vec4(material.base_color, material.opacity) * point.color * base_color_map_at(point);
}
