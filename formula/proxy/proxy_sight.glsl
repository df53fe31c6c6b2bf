// A map of an environment that is not infinitely far away: its light comes from a surface of a simple shape, the proxy,
// on which a ray from anywhere meets it ("parallax-corrected" cube maps: Lagarde & Zanuttini 2012, "Local image-based
// lighting with parallax-corrected cubemap"; box projection: Bjorke 2004).

// Where a ray meets a proxy.
struct ProxyHit {
  vec3 place;      // world
  vec3 normal;     // unit, of either side; 0: nothing is met, as if the proxy were infinitely far away
  float distance;  // from the ray's origin
  bool is_ground;  // it is a level ground
};

// What a ray sees, from where the map was captured.
struct ProxySight {
  vec3 direction;     // unit
  float enlargement;  // a small solid angle about the ray's becomes so many times larger there
  vec3 place;         // on the proxy, in the world
  bool is_ground;     // it is on a level ground
};

// Beyond which a solid angle is not enlarged further: of a ray along the surface it would be infinite.
const float kMostEnlargement = 1e4f;

// The square of a distance, in distances of the capture, below which a ray leaves the proxy where it begins: it sees
// that place whatever its direction, and where it goes along the surface, cosines are roundings.
const float kLeavesWhereItBegins = 1e-6f;

// Both see the same area, which takes a solid angle of cos / distance² of it.
FN ProxySight sightOfProxy(ProxyHit hit, vec3 captured_at, vec3 d) {
  vec3 to = hit.place - captured_at;
  float squared = dot(to, to);
  if (hit.normal == vec3(0.0f) || squared <= 0.0f) return MAKE(ProxySight)(d, 1.0f, hit.place, false);
  vec3 direction = to / sqrt(squared);
  float there = abs(dot(direction, hit.normal)) * hit.distance * hit.distance;
  float here = abs(dot(d, hit.normal)) * squared;
  float enlargement = there < kMostEnlargement * here ? there / here : kMostEnlargement;
  if (hit.distance * hit.distance < kLeavesWhereItBegins * squared) enlargement = 0.0f;
  return MAKE(ProxySight)(direction, enlargement, hit.place, hit.is_ground);
}

// The roughness whose lobe is so many times larger: its solid angle grows as alpha², and alpha as the square of the
// perceptual roughness.
FN float roughnessBeyondProxy(float perceptual_roughness, float enlargement) {
  if (enlargement == 1.0f) return perceptual_roughness;
  return min(perceptual_roughness * sqrt(sqrt(enlargement)), 1.0f);
}

// Where on its line a ray of an eye outside of the proxy begins, as it does if the eye is far away and all rays are
// parallel: nearest to the capture. So an eye before a room looks through the wall.
FN vec3 nearestToCapture(vec3 origin, vec3 d, vec3 captured_at) { return origin + dot(captured_at - origin, d) * d; }
