// Where a straight way through the texture's space meets the surface of a height map, exactly: the maxima of ever
// larger cells tell what it passes over (Tevs, Ihrke & Seidel 2008, "Maximum mipmaps for fast, accurate, and scalable
// dynamic height field rendering"), and in a patch it meets a bilinear surface, which is a quadratic equation.
// Needs: height_map.

const float kNoHit = 2.0f;  // a share of the way that is none
const int kLongestSearch = 2048;
const float kNudge = 1e-3f;  // texels: into the cell that is entered, at least

// Where a way meets a bilinear patch from above. With the height of the way, h, and that of the patch,
// c0 + c1 x + c2 y + c3 x y, both over the share s, f(s) = h − patch is f0 + f1 s + f2 s².
//   corners       patchCorners
//   entry, leave  in the patch's coordinates, [0, 1]², and height
//   is_above      at the entry; below there, it is by rounding, and meets the patch at once
//   returns       the share in [0, 1] of the way from entry to leave
FN float hitOfPatch(vec4 corners, vec3 entry, vec3 leave, bool is_above) {
  float along_x = corners.y - corners.x;
  float along_y = corners.z - corners.x;
  float twist = corners.x - corners.y - corners.z + corners.w;
  vec3 way = leave - entry;
  float f0 = entry.z - (corners.x + along_x * entry.x + along_y * entry.y + twist * entry.x * entry.y);
  if (is_above && f0 <= 0.0f) return 0.0f;
  float f1 = way.z - along_x * way.x - along_y * way.y - twist * (entry.x * way.y + entry.y * way.x);
  float f2 = -twist * way.x * way.y;
  float discriminant = f1 * f1 - 4.0f * f2 * f0;
  if (discriminant < 0.0f) return kNoHit;
  // The roots are q / f2 and f0 / q without a difference of near numbers. At one of them f falls.
  float q = -0.5f * (f1 + (f1 >= 0.0f ? 1.0f : -1.0f) * sqrt(discriminant));
  float hit = f1 < 0.0f ? f0 / q : (f2 == 0.0f ? kNoHit : q / f2);
  return hit >= 0.0f && hit <= 1.0f ? hit : kNoHit;
}

// A cell of a level: what of the map it covers, in texels, and its greatest height.
struct HeightCell {
  vec2 low;
  vec2 high;
  float top;
};

// The cell around a place. At level 0 it is a patch, whose top is not asked for.
FN HeightCell heightCellAt(MAP_SAMPLER heights, HeightMap map, vec2 place, int level) {
  vec2 size = map.size;
  bool is_tiled = map.wrap == kWrapRepeat;
  if (level == 0) {
    vec2 first = floor(place);
    return MAKE(HeightCell)(first, first + vec2(1.0f), 0.0f);
  }
  vec2 origin = is_tiled ? size * floor(place / size) : vec2(0.0f);
  vec2 cells = vec2(sizeOfLevel(map, level));
  float side = float(1 << level);
  vec2 cell = clamp(floor((place - origin) / side), vec2(0.0f), cells - vec2(1.0f));
  vec2 low = origin + cell * side;
  vec2 high = low + vec2(side);
  // The last cell has what is left of the map; beyond edges that are not tiled it goes on as it is there.
  float beyond = is_tiled ? 0.0f : 1e6f;
  if (cell.x == cells.x - 1.0f) high.x = origin.x + size.x + beyond;
  if (cell.y == cells.y - 1.0f) high.y = origin.y + size.y + beyond;
  if (cell.x == 0.0f) low.x -= beyond;
  if (cell.y == 0.0f) low.y -= beyond;
  return MAKE(HeightCell)(low, high, fetchMap(heights, placeOfLevel(map, level) + ivec2(cell), 0).x);
}

// The share of a way at which it leaves a cell.
FN float shareAtEdge(vec2 from, vec2 way, HeightCell cell) {
  float x = way.x == 0.0f ? kNoHit : ((way.x > 0.0f ? cell.high.x : cell.low.x) - from.x) / way.x;
  float y = way.y == 0.0f ? kNoHit : ((way.y > 0.0f ? cell.high.y : cell.low.y) - from.y) / way.y;
  return min(min(x, y), 1.0f);
}

// How far below the surface a way that goes on may begin: by that the sides of two prisms that are bent may differ.
const float kJoint = 0.02f;

//   from, to   place in texels, and height
//   goes_on    it is the rest of a way that was above the surface
//   returns    the share of the way from one to the other at which it meets the surface from above; kNoHit: nowhere.
//              What begins below passes through the surface before it can
FN float exactSearch(MAP_SAMPLER heights, HeightMap map, vec3 from, vec3 to, bool goes_on) {
  vec3 way = to - from;
  // In the first tile, where places have their most digits.
  vec2 start = vec2(from);
  if (map.wrap == kWrapRepeat) start -= map.size * floor(start / map.size);
  from = vec3(start, from.z);
  vec2 across = vec2(way);
  bool is_above = from.z >= 1.0f || from.z >= heightAt(heights, map, start) - (goes_on ? kJoint : 0.0f);
  vec2 farthest = max(abs(start), abs(start + across));
  vec2 nudge = max(kNudge, 5e-7f * max(farthest.x, farthest.y)) * sign(across);
  float share = 0.0f;
  // Cells as large as the way.
  float texels = max(max(abs(across.x), abs(across.y)), 1.0f);
  int level = min(int(ceil(log2(min(texels, 1e6f)))), map.last_level);
  for (int step = 0; step < kLongestSearch; ++step) {
    HeightCell cell = heightCellAt(heights, map, start + across * share + nudge, level);
    float leaving = max(shareAtEdge(start, across, cell), share);
    vec3 entry = from + way * share;
    vec3 leave = from + way * leaving;
    if (level > 0 && min(entry.z, leave.z) <= cell.top) {
      // Before it is as low as the cell's top nothing can be met.
      if (entry.z > cell.top) share = max(share, min((cell.top - from.z) / way.z, leaving));
      --level;
      continue;
    }
    if (level == 0) {
      vec3 corner = vec3(cell.low.x, cell.low.y, 0.0f);
      vec4 corners = patchCorners(heights, map, cell.low);
      float hit = hitOfPatch(corners, entry - corner, leave - corner, is_above);
      if (hit <= 1.0f) return mix(share, leaving, hit);
      is_above = is_above || leave.z >= heightOfPatch(corners, vec2(leave - corner));
    }
    if (leaving >= 1.0f) return kNoHit;
    share = leaving;
    level = is_above ? min(level + 1, map.last_level) : 0;
  }
  return kNoHit;
}
