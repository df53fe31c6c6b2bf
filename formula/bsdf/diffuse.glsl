// Lambert's surface: as bright from all sides. Directions are unit vectors in the frame of the surface, whose normal is
// +Z; l is where light comes from. evalX is the BSDF without the cosine of the light [1/sr], sampleX makes a direction
// from two numbers in [0, 1), pdfX is that direction's density [1/sr]: so for diffuse.glsl, ggx.glsl and phong.glsl.
// Needs: constants.

FN float evalDiffuse() { return 1.0f / kPi; }

// The disc's area is what the hemisphere's cosine makes of it (Malley's method; Pharr, Jakob & Humphreys 2023, A.5.3).
FN vec3 sampleDiffuse(vec2 u) {
  float radius = sqrt(u.x);
  return vec3(radius * cos(kTwoPi * u.y), radius * sin(kTwoPi * u.y), sqrt(1.0f - u.x));
}

FN float pdfDiffuse(vec3 l) { return max(l.z, 0.0f) / kPi; }
