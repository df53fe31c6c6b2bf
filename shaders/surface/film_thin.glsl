// Part "film" (film_none.glsl). Here: where the material has one.
#undef HAS_FILM
#define HAS_FILM(material) (material.iridescence > 0.0)
