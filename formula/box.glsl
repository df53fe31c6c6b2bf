// Boxes along the axes.

// The distances along a ray between which it is in the box; the first is greater: nowhere.
FN vec2 wayThroughBox(vec3 low, vec3 high, vec3 origin, vec3 direction) {
  // A way along a side never reaches it.
  vec3 slow = vec3(abs(direction.x) < 1e-12f ? 1e-12f : direction.x, abs(direction.y) < 1e-12f ? 1e-12f : direction.y,
                   abs(direction.z) < 1e-12f ? 1e-12f : direction.z);
  vec3 to_low = (low - origin) / slow;
  vec3 to_high = (high - origin) / slow;
  vec3 enter = min(to_low, to_high);
  vec3 leave = max(to_low, to_high);
  return vec2(max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}
