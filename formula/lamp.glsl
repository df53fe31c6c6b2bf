// What is small enough to be a point and sends light, or so far away that its light comes from one direction.

const int kLampPhong = 0;        // a point; color: the radiance of a white diffuse surface that faces it, however far
const int kLampPoint = 1;        // color: its luminous intensity [cd]
const int kLampSpot = 2;         // color: that within its inner cone
const int kLampDirectional = 3;  // color: the illuminance of a surface facing it [lx]

struct Lamp {
  int kind INITIALLY(kLampPoint);
  vec3 position INITIALLY(vec3(0.0f));                // world; not of directional light
  vec3 direction INITIALLY(vec3(0.0f, 0.0f, -1.0f));  // world, unit: the way its light goes
  vec3 color INITIALLY(vec3(1.0f));
  float range INITIALLY(0.0f);                        // where its light ends; 0: nowhere
  float cosine_inner INITIALLY(1.0f);                 // of the angles at which a spot begins to fade and is dark
  float cosine_outer INITIALLY(0.70710678f);
};

// The unit direction from a place to the lamp.
FN vec3 towardsLamp(Lamp lamp, vec3 place) {
  if (lamp.kind == kLampDirectional) return -lamp.direction;
  vec3 away = lamp.position - place;
  return away / max(length(away), 1e-15f);
}

// The share of a point's light that its range leaves at a distance (KHR_lights_punctual).
FN float shareInRange(Lamp lamp, float distance2) {
  if (lamp.range <= 0.0f) return 1.0f;
  float ratio2 = distance2 / (lamp.range * lamp.range);
  return clamp(1.0f - ratio2 * ratio2, 0.0f, 1.0f);
}

// The share of a spot's light that is left aside of its axis (KHR_lights_punctual).
FN float shareInCone(Lamp lamp, vec3 towards) {
  if (lamp.kind != kLampSpot) return 1.0f;
  float width = max(lamp.cosine_inner - lamp.cosine_outer, 0.001f);
  float share = clamp((-dot(towards, lamp.direction) - lamp.cosine_outer) / width, 0.0f, 1.0f);
  return share * share;
}

// The illuminance of a surface at that place that faces the lamp [lx]; not of Phong's.
FN vec3 lampIlluminance(Lamp lamp, vec3 place) {
  if (lamp.kind == kLampDirectional) return lamp.color;
  vec3 away = lamp.position - place;
  float distance2 = max(dot(away, away), 1e-24f);  // a model may be 1e-6 large
  return lamp.color * (shareInRange(lamp, distance2) * shareInCone(lamp, towardsLamp(lamp, place)) / distance2);
}
