// Texture coordinates (s, t, r, q) that are generated for a point of a surface instead of being stored with its
// vertices: glTexGen of OpenGL 1.0 to 2.1 (OpenGL 2.1 specification, 2.11.4 "Generating Texture Coordinates"). A
// matrix follows, of what is linear in a mode (its planes, the eye's frame) and of the user's texture matrix; and at
// last s and t are divided by q.
// Needs: sphere_map.

struct TexgenPoint {
  vec3 object_position;
  vec3 position;         // world
  vec3 normal;           // world, unit
  vec3 ray;              // world, unit, from the eye
  mat3 eye_from_world;
};

// GL_OBJECT_LINEAR: a coordinate is the product of a plane with the vertex as the object has it. Four planes are the
// rows of a matrix.
FN vec4 objectCoordinates(TexgenPoint p) { return vec4(p.object_position, 1.0f); }

// GL_EYE_LINEAR, whose matrix begins by turning the world into the eye's frame; with a light's frame instead, it is a
// projector (Segal et al. 1992, "Fast Shadows and Lighting Effects Using Texture Mapping").
FN vec4 placeCoordinates(TexgenPoint p) { return vec4(p.position, 1.0f); }

// GL_NORMAL_MAP.
FN vec4 normalCoordinates(TexgenPoint p) { return vec4(p.normal, 1.0f); }

// GL_REFLECTION_MAP.
FN vec4 reflectionCoordinates(TexgenPoint p) { return vec4(reflect(p.ray, p.normal), 1.0f); }

// GL_SPHERE_MAP: the reflected ray in the eye's frame, found on the picture of a mirror ball.
FN vec4 sphereCoordinates(TexgenPoint p) {
  vec2 st = sphereMapCoordinates(p.eye_from_world * reflect(p.ray, p.normal));
  return vec4(st.x, st.y, 0.0f, 1.0f);
}

// Texture coordinates as glTF has them, v downwards from the picture's first row, and as OpenGL has them, t upwards.
FN vec4 coordinatesOfUv(vec2 uv) { return vec4(uv.x, 1.0f - uv.y, 0.0f, 1.0f); }
FN vec2 uvOfCoordinates(vec4 c) { return vec2(c.x / c.w, 1.0f - c.y / c.w); }

// Whether a projector's picture falls on a point, 1 or 0: not behind the projector, where q is below 0 and a mirror
// image of the picture would be, and not beside the picture.
FN float projectedShare(vec4 c) {
  if (c.w <= 0.0f) return 0.0f;
  bool is_beside = c.x < 0.0f || c.x > c.w || c.y < 0.0f || c.y > c.w;
  return is_beside ? 0.0f : 1.0f;
}

// The coordinates of places in the world for a projector: q is the distance along its axis, and s / q and t / q go from
// 0 to 1 over the width and the height of its picture, to the right and upwards as it is seen from the projector.
//   forward    unit, where it looks
//   up         unit, across it
//   widening   half the picture's width at the distance 1
FN mat4 projectorMatrix(vec3 place, vec3 forward, vec3 up, float widening) {
  vec3 right = cross(forward, up);
  vec3 s = 0.5f * (right / widening + forward);
  vec3 t = 0.5f * (up / widening + forward);
  return mat4(vec4(s.x, t.x, 0.0f, forward.x), vec4(s.y, t.y, 0.0f, forward.y), vec4(s.z, t.z, 0.0f, forward.z),
              vec4(-dot(s, place), -dot(t, place), 0.0f, -dot(forward, place)));
}
