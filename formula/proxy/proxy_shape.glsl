// Proxies of simple shapes, met from within. A place outside counts as the nearest one within, so that no light jumps.
// Needs: proxy_sight.

// Where nothing is; its square is still a number.
const float kFarAway = 1e18f;

FN vec3 withinBox(vec3 low, vec3 high, vec3 place) { return clamp(place, low, high); }

// The way along one axis out of a slab.
FN float wayOut(float low, float high, float from, float d) {
  if (d > 0.0f) return min((high - from) / d, kFarAway);
  if (d < 0.0f) return min((low - from) / d, kFarAway);
  return kFarAway;
}

// A ray leaves a box through the nearest of the three sides that it goes towards.
FN ProxyHit hitOfBox(vec3 low, vec3 high, vec3 origin, vec3 d) {
  vec3 from = withinBox(low, high, origin);
  vec3 ways = vec3(wayOut(low.x, high.x, from.x, d.x), wayOut(low.y, high.y, from.y, d.y),
                   wayOut(low.z, high.z, from.z, d.z));
  float distance = min(min(ways.x, ways.y), ways.z);
  vec3 normal = vec3(0.0f, 0.0f, 1.0f);
  if (ways.x <= distance)
    normal = vec3(1.0f, 0.0f, 0.0f);
  else if (ways.y <= distance)
    normal = vec3(0.0f, 1.0f, 0.0f);
  return MAKE(ProxyHit)(from + distance * d, normal, distance, false);
}

FN vec3 withinSphere(vec3 center, float radius, vec3 place) {
  vec3 to = place - center;
  float outside = length(to) / radius;
  return outside > 1.0f ? center + to / outside : place;
}

// A ray leaves a sphere at the far solution of |origin + t d − center|² = radius².
FN ProxyHit hitOfSphere(vec3 center, float radius, vec3 origin, vec3 d) {
  vec3 from = withinSphere(center, radius, origin);
  vec3 to = from - center;
  float along = dot(to, d);
  float distance = sqrt(max(along * along - dot(to, to) + radius * radius, 0.0f)) - along;
  vec3 place = from + distance * d;
  return MAKE(ProxyHit)(place, (place - center) / radius, distance, false);
}

FN vec3 withinDome(vec3 center, float radius, float ground, vec3 place) {
  return withinSphere(center, radius, vec3(place.x, max(place.y, ground), place.z));
}

// A dome over a level ground: the lower part of a sphere about the place of the capture is cut off. So a panorama lies
// on the ground without distortion around the point below its camera, and bends up where the sphere begins.
//
// center   where the panorama was captured, above the ground and within the dome
FN ProxyHit hitOfGround(vec3 center, float radius, float ground, vec3 origin, vec3 d) {
  vec3 from = withinDome(center, radius, ground, origin);
  ProxyHit dome = hitOfSphere(center, radius, from, d);
  float distance = d.y < 0.0f ? min((ground - from.y) / d.y, kFarAway) : kFarAway;
  if (distance >= dome.distance) return dome;
  return MAKE(ProxyHit)(from + distance * d, vec3(0.0f, 1.0f, 0.0f), distance, true);
}

// What is left of the light of a photographed ground where something blocks its light. It is taken as matt: `blocked`
// is the share of its irradiance that is missing. What shines by itself goes on to shine.
//
// photo        radiance of the ground in the panorama
// irradiance   that reaches a level ground from the whole panorama, divided by π
FN vec3 shadowedGround(vec3 photo, vec3 irradiance, vec3 blocked) { return photo - min(photo, irradiance) * blocked; }
