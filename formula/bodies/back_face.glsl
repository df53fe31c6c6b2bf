// The back faces of bodies as a picture shows them: where light leaves that a front face has refracted (Wyman 2005, "An
// approximate image-space approach for interactive refraction"). A texel holds the octahedral normal, the depth along
// the eye's axis and the curvature; render/surface/back_faces.cpp draws it.

const float kNoBackFace = 3e38f;  // the depth of a texel without one

// What a texel knows of the surface around it.
struct BackFace {
  vec3 place;       // world
  vec3 normal;      // unit, outwards
  float curvature;  // how much the normal turns over a way along the surface [1/world unit]; above 0 where it bulges
};

// The mean curvature of what two neighbouring pixels show, beside and below.
//
// across, down            from the place in a pixel to that in its neighbour
// turn_across, turn_down  what is then added to the unit normal
FN float curvatureOfPixels(vec3 across, vec3 turn_across, vec3 down, vec3 turn_down) {
  float length2 = dot(across, across) + dot(down, down);
  return length2 > 0.0f ? (dot(across, turn_across) + dot(down, turn_down)) / length2 : 0.0f;
}

// The way of a ray to the plane that touches the surface at the texel's place; kNoBackFace: it does not get nearer. For
// a flat side that is where the ray leaves; for a bulging one it is a step of Newton's method towards it.
//
// direction  unit
FN float wayToBackFace(BackFace face, vec3 from, vec3 direction) {
  float towards = dot(direction, face.normal);
  return towards > 1e-6f ? dot(face.place - from, face.normal) / towards : kNoBackFace;
}

// The normal at a place beside the texel's, so that a curved surface is smooth between texels. It turns by a quarter at
// most: where the curvature is known, nothing farther away is the same surface.
FN vec3 normalBesideBackFace(BackFace face, vec3 place) {
  vec3 turn = face.curvature * (place - face.place);
  return normalize(face.normal + turn / max(1.0f, 4.0f * length(turn)));
}
