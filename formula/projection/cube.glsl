// Cube maps by OpenGL's table (OpenGL 4.3, table 8.18): faces +X −X +Y −Y +Z −Z are 0 … 5, (s, t) in [0, 1]² with
// row 0 of the image at t = 0. The table is left-handed: as pictures, faces are mirror images of what the eye sees
// from inside; every texel still answers for its own direction.

// The face that a direction goes through: that of its longest component, the first of them where two are equal.
FN int cubeFace(vec3 d) {
  vec3 size = abs(d);
  if (size.x >= size.y && size.x >= size.z) return d.x >= 0.0f ? 0 : 1;
  if (size.y >= size.z) return d.y >= 0.0f ? 2 : 3;
  return d.z >= 0.0f ? 4 : 5;
}

// (sc, tc, ma) of the table, for a face chosen by the caller; ma is positive on that face.
FN vec3 cubeProjected(int face, vec3 d) {
  if (face == 0) return vec3(-d.z, -d.y, d.x);
  if (face == 1) return vec3(d.z, -d.y, -d.x);
  if (face == 2) return vec3(d.x, d.z, d.y);
  if (face == 3) return vec3(d.x, -d.z, -d.y);
  if (face == 4) return vec3(d.x, -d.y, d.z);
  return vec3(-d.x, -d.y, -d.z);
}

// s = (sc / |ma| + 1) / 2, t = (tc / |ma| + 1) / 2.
FN vec2 cubeCoordinates(int face, vec3 d) {
  vec3 p = cubeProjected(face, d);
  return vec2((p.x / p.z + 1.0f) / 2.0f, (p.y / p.z + 1.0f) / 2.0f);
}

// The point of the cube [−1, 1]³ at (s, t) of a face: the table read backwards. (s, t) a little outside [0, 1]
// continues the face's plane, which is how the neighbour across an edge is found.
FN vec3 cubePoint(int face, vec2 st) {
  float sc = 2.0f * st.x - 1.0f;
  float tc = 2.0f * st.y - 1.0f;
  if (face == 0) return vec3(1.0f, -tc, -sc);
  if (face == 1) return vec3(-1.0f, -tc, sc);
  if (face == 2) return vec3(sc, 1.0f, tc);
  if (face == 3) return vec3(sc, -1.0f, -tc);
  if (face == 4) return vec3(sc, -tc, 1.0f);
  return vec3(-sc, -tc, -1.0f);
}

FN vec3 cubeDirection(int face, vec2 st) { return normalize(cubePoint(face, st)); }

// The solid angle between a face's centre and the point (x, y) of its plane, x and y in [−1, 1].
FN float cubeCornerSolidAngle(float x, float y) { return atan(x * y, sqrt(x * x + y * y + 1.0f)); }

// The solid angle of the rectangle from (x0, y0) to (x1, y1) of a face's plane, by its four corners.
FN float cubeRectangleSolidAngle(float x0, float y0, float x1, float y1) {
  return cubeCornerSolidAngle(x0, y0) - cubeCornerSolidAngle(x0, y1) - cubeCornerSolidAngle(x1, y0) +
         cubeCornerSolidAngle(x1, y1);
}

// The solid angle of a texel of a face of `size` texels, (s, t) being its centre. A place of the face's plane at the
// distance ρ from the cube's middle stands for 1/ρ³ of its area; the mean over the texel by Gauss's rule of 2 × 2
// points, which unlike the differences of corners keeps its digits however small the texel is.
FN float cubeTexelSolidAngle(vec2 st, float size) {
  float width = 2.0f / size;
  float offset = 0.577350269f * 0.5f * width;
  float sum = 0.0f;
  for (int i = 0; i < 4; ++i) {
    float x = 2.0f * st.x - 1.0f + (i % 2 == 0 ? -offset : offset);
    float y = 2.0f * st.y - 1.0f + (i / 2 == 0 ? -offset : offset);
    float nearness = 1.0f / sqrt(x * x + y * y + 1.0f);
    sum += nearness * nearness * nearness;
  }
  return 0.25f * sum * width * width;
}

// A unit vector orthogonal to n along a face's rows. It turns steadily over the face, and where two faces meet in the
// middle of an edge theirs differ by a multiple of 90°.
FN vec3 cubeTangent(int face, vec3 n) {
  vec3 along = cubePoint(face, vec2(1.0f, 0.5f)) - cubePoint(face, vec2(0.5f, 0.5f));
  return normalize(along - dot(along, n) * n);
}
