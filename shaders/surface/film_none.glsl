// Part "film": whether a thin film lies on the surface, for formula/surface/shading.glsl.
//   HAS_FILM(material)
// Here: never.
#undef HAS_FILM
#define HAS_FILM(material) false
