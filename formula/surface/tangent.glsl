// Frames on a surface and normals bent in them.

// A unit vector orthogonal to n, without a branch that jumps (Duff et al. 2017, "Building an orthonormal basis,
// revisited"); the second one is cross(n, tangent).
FN vec3 anyTangent(vec3 n) {
  float side = n.z >= 0.0f ? 1.0f : -1.0f;
  float a = -1.0f / (side + n.z);
  float b = n.x * n.y * a;
  return vec3(1.0f + side * n.x * n.x * a, side * b, -side * n.x);
}

// The normal of the surface p + d n (Blinn 1978). With unit n and small d,
//   p'_u = p_u + d_u n,  p'_v = p_v + d_v n,  and
//   p'_u × p'_v = p_u × p_v + d_u (n × p_v) + d_v (p_u × n)
//               = p_u × p_v + d_u (n × p_v) − d_v (n × p_u).
// For an orthonormal frame that is n − d_u p_u − d_v p_v; the lecture's slide has plus signs there, and drops
// |p_u × p_v|.
FN vec3 perturbedNormal(vec3 p_u, vec3 p_v, vec3 n, float d_u, float d_v) {
  return normalize(cross(p_u, p_v) + d_u * cross(n, p_v) - d_v * cross(n, p_u));
}

// The same for any texture coordinates: what they change of the place is taken across n, and may turn left or right.
//   up    where a height of 1 goes: n, or where a stretched object's normals go
//   d     how much the height grows a unit of u and of v
FN vec3 liftedNormal(vec3 p_u, vec3 p_v, vec3 n, vec3 up, vec2 d) {
  vec3 u = p_u - n * dot(n, p_u);
  vec3 v = p_v - n * dot(n, p_v);
  float side = dot(cross(u, v), n);
  if (abs(side) <= 1e-6f * length(u) * length(v)) return n;
  vec3 bent = perturbedNormal(u, v, up, d.x, d.y);
  return side < 0.0f ? -bent : bent;
}

FN vec3 displacedNormal(vec3 p_u, vec3 p_v, vec3 n, vec2 d) { return liftedNormal(p_u, p_v, n, n, d); }

// The normal of a surface whose slopes a map of them tells: along the surface, in the directions of p_u and p_v however
// long, so that a slope of 1 rises by 45° at any size of the map on the surface. No tangents are needed (Mikkelsen
// 2010, "Bump mapping unparametrized surfaces on the GPU"), and where p_u and p_v are at right angles it is the normal
// of a normal map that holds (−slope.x, slope.y, 1).
//   slope   (∂d/∂u, ∂d/∂v), both in lengths of the surface
FN vec3 slopedNormal(vec3 p_u, vec3 p_v, vec3 n, vec2 slope) {
  vec2 lengths = vec2(length(p_u - n * dot(n, p_u)), length(p_v - n * dot(n, p_v)));
  return displacedNormal(p_u, p_v, n, slope * lengths);
}

// A vertex's tangent brought into the surface, turned from there towards the bitangent.
//   tangent     the direction of growing u; w is the bitangent's sign. 0: any direction will do
//   turn        cosine and sine
FN vec3 turnedTangent(vec4 tangent, vec3 n, vec2 turn) {
  vec3 whole = vec3(tangent);  // as long as the object is scaled
  vec3 along = whole - n * dot(n, whole);
  vec3 t = dot(along, along) > 1e-12f * dot(whole, whole) ? normalize(along) : anyTangent(n);
  return t * turn.x + cross(n, t) * (tangent.w * turn.y);
}

// Cosine and sine of the way that roughness is stretched: a direction in the frame of the tangent, from a texture,
// turned by an angle counter-clockwise (KHR_materials_anisotropy). Without a direction, which 8 bits do not
// hold exactly, it is the angle alone.
FN vec2 anisotropyTurn(vec2 direction, float rotation) {
  vec2 from = dot(direction, direction) > 1e-4f ? normalize(direction) : vec2(1.0f, 0.0f);
  float c = cos(rotation);
  float s = sin(rotation);
  return vec2(c * from.x - s * from.y, s * from.x + c * from.y);
}

// The normal that a normal map's sample stands for, of any length: 1 always stands for 1.
//   encoded   a sample; codes as fractions of 255
//   zero      the code that stands for 0: 127.5 in glTF 2.0 (3.9.3), whose map of 8 bits cannot hold it; 128 where
//             programs write (128, 128, 255) for a flat surface; 0 where the map holds signed numbers
FN vec3 decodedNormal(vec3 encoded, float zero) {
  float least = zero / 255.0f;
  return (encoded - vec3(least)) / (1.0f - least);
}

// The reverse.
FN vec3 encodedNormal(vec3 normal, float zero) {
  float least = zero / 255.0f;
  return normal * (1.0f - least) + vec3(least);
}

// The unit normal of a decoded sample of a tangent-space normal map: +Y up along the bitangent, as in glTF. Where the
// map holds no direction it is n.
FN vec3 normalFromMap(vec3 tangent, vec3 bitangent, vec3 n, vec3 mapped, float scale) {
  vec3 bent = mapped.x * scale * tangent + mapped.y * scale * bitangent + mapped.z * n;
  return dot(bent, bent) > 1e-12f ? normalize(bent) : n;
}

// The same in the frame that a vertex's tangent makes with the unit normal.
//   tangent   the direction of growing u; w is the bitangent's sign (glTF 2.0, 3.7.2.1)
FN vec3 mappedNormal(vec4 tangent, vec3 n, vec3 mapped, float scale) {
  vec3 along = vec3(tangent);
  vec3 t = normalize(along - n * dot(n, along));
  return normalFromMap(t, cross(n, t) * tangent.w, n, mapped, scale);
}

// Mip levels of a normal map keep in alpha how unit normals spread whose mean is that long: 1 where they all agree. The
// root makes the steps of 8 bits fine where a mirror would show them.
//   mean_length   in [0, 1]
FN float alphaOfSpread(float mean_length) { return 1.0f - sqrt(max(1.0f - mean_length, 0.0f)); }

// The variance of the slopes, along one direction, that this alpha tells of: of a Gaussian that has such a mean
// (Toksvig 2005, "Mipmapping normal maps"), with slopes scaled as those of normals are.
FN float spreadOfAlpha(float alpha, float scale) {
  float root = 1.0f - alpha;
  float missing = root * root;
  return scale * scale * missing / max(1.0f - missing, 1e-3f);
}

// The world's unit normal of a decoded sample of an object-space normal map. Where the map holds no direction it is n.
//   world_from_normal   the object's normals to the world's, but for their lengths
//   n                   unit, of the surface without the map
//   scale               how far it turns from there: 1 all of the way
FN vec3 objectMappedNormal(mat3 world_from_normal, vec3 n, vec3 mapped, float scale) {
  vec3 bent = world_from_normal * mapped;
  return dot(mapped, mapped) > 1e-12f ? normalize(mix(n, normalize(bent), scale)) : n;
}
