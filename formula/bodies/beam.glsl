// How wide the light is that one ray stands for: the lobe into which rough surfaces spread it, and the part of a pixel
// that it is seen from. Rays beside it differ by a small angle and a small place; both change linearly at a surface and
// on the way to the next one, as in a system of lenses (Igehy 1999, "Tracing ray differentials"; here with one angle
// and one place, for both the plane of incidence and across it, by their geometric means).
//
// A facet that is tilted by δ turns a reflected ray by 2 δ; a refracted one by less, and by nothing where both indices
// are the same. From Snell's law with a tilted normal, cos θ and cos θt being those on the near and on the far side,
// the direction t = i / η + (cos θ / η − cos θt) n turns by δ (cos θt − cos θ / η) across the plane of incidence, and
// by 1 / cos θt of that within it. An angle between arriving rays becomes 1 / η of itself across the plane, and
// cos θ / (η cos θt) within it.

struct Beam {
  vec3 lobe;   // of rays that rough surfaces spread: the variances of angle² and angle · place and place², in units in
               // which alpha² is that of a reflection
  vec2 pixel;  // angle and place [world units] of a ray that is seen at the edge of a sample of the pixel
};

// What a surface makes of an angle and a place: angle' = x · angle + y · place; and z: the variance that its own
// facets add to that of the angle.
//
// alpha      its GGX width
// cosine     between the ray and the normal, in [0, 1]
// eta        the index of the far side over that of the near side
// curvature  how much the normal turns over a way along the surface [1/world unit]; above 0: the side that the ray
//            comes from is hollow
FN vec3 refractionOfBeam(float alpha, float cosine, float eta, float curvature) {
  float refracted = sqrt(max(1.0f - (1.0f - cosine * cosine) / (eta * eta), 0.0f));
  // Towards the critical angle all this grows without end.
  float here = max(cosine, 0.05f);
  float beyond = max(refracted, 0.05f);
  float turn = (refracted - cosine / eta) / sqrt(beyond);
  float kick = 0.5f * alpha * turn;
  return vec3(sqrt(here / beyond) / eta, turn * curvature / sqrt(here), kick * kick);
}

// In the picture behind the mirror.
FN vec3 reflectionOfBeam(float alpha, float cosine, float curvature) {
  return vec3(1.0f, -2.0f * curvature / sqrt(max(cosine, 0.05f)), alpha * alpha);
}

// A beam after a surface.
FN Beam beamBeyond(Beam beam, vec3 surface) {
  float a = surface.x;
  float b = surface.y;
  vec3 l = beam.lobe;
  vec3 lobe = vec3(a * a * l.x + 2.0f * a * b * l.y + b * b * l.z + surface.z, a * l.y + b * l.z, l.z);
  return MAKE(Beam)(lobe, vec2(a * beam.pixel.x + b * beam.pixel.y, beam.pixel.y));
}

// And after a distance.
FN Beam beamAfter(Beam beam, float distance) {
  vec3 l = beam.lobe;
  vec3 lobe = vec3(l.x, l.y + distance * l.x, l.z + distance * (2.0f * l.y + distance * l.x));
  return MAKE(Beam)(lobe, vec2(beam.pixel.x, beam.pixel.y + distance * beam.pixel.x));
}

// Which roughness blurs the environment as the beam does.
FN float roughnessOfBeam(Beam beam) { return sqrt(sqrt(clamp(beam.lobe.x, 0.0f, 1.0f))); }

// The solid angle that one sample of the pixel sees [sr].
FN float footprintOfBeam(Beam beam) { return min(beam.pixel.x * beam.pixel.x, 4.0f); }
