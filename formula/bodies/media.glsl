// The bodies that a point is inside of. They may overlap, as a liquid that reaches into the wall of its glass, so that
// no gap is between them: the one of the greatest priority fills the place, and the surfaces of the others are not
// there for a ray (Schmidt & Budge 2002, "Simple nested dielectrics in ray traced images"). Among equals the one that
// was entered last fills it, so a ball of air in glass needs no priority.
//
// A ray carries this list with it, and compilers of shaders turn an array that is copied into loads and stores of each
// of its elements: so the list is two vectors, and nothing in it is reached by a variable index. Bodies inside of eight
// others are not known.

const int kGreatestPriority = 1000;  // the least is −1000
const uint kBodyBits = 0x1FFFFFu;    // of a word
const uint kPriorityShift = 21u;

// The bodies in the order in which they were entered, the last one first. A word is a body's number + 1, and above it
// its priority + 1001; 0: no body.
struct Media {
  uvec4 latest INITIALLY(uvec4(0u));
  uvec4 earliest INITIALLY(uvec4(0u));
};

FN Media noMedia() { return MAKE(Media)(uvec4(0u), uvec4(0u)); }

FN bool isWithinBody(Media media) { return media.latest.x != 0u; }

// A priority as a word holds it: those beyond the ends are as the ends are.
FN uint heldPriority(int priority) {
  return uint(clamp(priority, -kGreatestPriority, kGreatestPriority) + kGreatestPriority + 1);
}

// body      below two million; others are not known
FN Media entered(Media media, int body, int priority) {
  if (media.earliest.w != 0u || uint(body) >= kBodyBits) return media;
  uint word = (heldPriority(priority) << kPriorityShift) | uint(body + 1);
  uvec4 a = media.latest;
  uvec4 b = media.earliest;
  return MAKE(Media)(uvec4(word, a.x, a.y, a.z), uvec4(a.w, b.x, b.y, b.z));
}

// 1 for each word of a body, else 0.
FN uvec4 wordsOfBody(uvec4 words, int body) {
  return uvec4(equal(words & uvec4(kBodyBits), uvec4(uint(body + 1))));
}

// A body that was not entered, as through the hole of an open mesh, changes nothing.
FN Media left(Media media, int body) {
  uvec4 a = media.latest;
  uvec4 b = media.earliest;
  // From the word on that goes, each makes way for the one behind it: 1 there, else 0.
  uvec4 a_goes = wordsOfBody(a, body);
  uvec4 b_goes = wordsOfBody(b, body);
  a_goes.y |= a_goes.x;
  a_goes.z |= a_goes.y;
  a_goes.w |= a_goes.z;
  b_goes.x |= a_goes.w;
  b_goes.y |= b_goes.x;
  b_goes.z |= b_goes.y;
  b_goes.w |= b_goes.z;
  uvec4 stays_a = a_goes - 1u;
  uvec4 stays_b = b_goes - 1u;
  return MAKE(Media)((a & stays_a) | (uvec4(a.y, a.z, a.w, b.x) & ~stays_a),
                     (b & stays_b) | (uvec4(b.y, b.z, b.w, 0u) & ~stays_b));
}

FN int timesEntered(Media media, int body) {
  uvec4 times = wordsOfBody(media.latest, body) + wordsOfBody(media.earliest, body);
  return int(times.x + times.y + times.z + times.w);
}

// Of two words the one that fills the place, `later` being that of the body that was entered later.
FN uint prevailing(uint later, uint earlier) {
  return (earlier >> kPriorityShift) > (later >> kPriorityShift) ? earlier : later;
}

// The word of the body that fills the place; 0: the place is empty.
FN uint fillingWord(Media media) {
  uvec4 a = media.latest;
  uvec4 b = media.earliest;
  return prevailing(prevailing(prevailing(a.x, a.y), prevailing(a.z, a.w)),
                   prevailing(prevailing(b.x, b.y), prevailing(b.z, b.w)));
}

// The body that fills the place; −1: none.
FN int fillingBody(Media media) { return int(fillingWord(media) & kBodyBits) - 1; }

// Whether a body's surface is there for a ray that goes into it or out of it.
FN bool hasSurface(Media media, int body, int priority, bool is_entering) {
  // Where parts of one mesh overlap, they are one body.
  int times = timesEntered(media, body);
  if (times > (is_entering ? 0 : 1)) return false;
  uint filling = fillingWord(media);
  if (filling == 0u) return true;
  if (is_entering) return heldPriority(priority) >= filling >> kPriorityShift;
  return times == 0 || (filling & kBodyBits) == uint(body + 1);
}
