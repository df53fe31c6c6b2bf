// The bodies that a point is inside of. They may overlap, as a liquid that reaches into the wall of its glass, so that
// no gap is between them: the one of the greatest priority fills the place, and the surfaces of the others are not
// there for a ray (Schmidt & Budge 2002, "Simple nested dielectrics in ray traced images"). Among equals the one that
// was entered last fills it, so a ball of air in glass needs no priority.

const int kMaxMedia = 8;  // beyond this many, bodies inside of bodies are not known

struct Media {
  int count INITIALLY(0);
  int bodies[kMaxMedia] INITIALLY({});  // in the order in which they were entered
  int priorities[kMaxMedia] INITIALLY({});
};

FN Media entered(Media media, int body, int priority) {
  if (media.count == kMaxMedia) return media;
  media.bodies[media.count] = body;
  media.priorities[media.count] = priority;
  ++media.count;
  return media;
}

// A body that was not entered, as through the hole of an open mesh, changes nothing.
FN Media left(Media media, int body) {
  int last = media.count - 1;
  while (last >= 0 && media.bodies[last] != body) --last;
  if (last < 0) return media;
  for (int i = last; i + 1 < media.count; ++i) {
    media.bodies[i] = media.bodies[i + 1];
    media.priorities[i] = media.priorities[i + 1];
  }
  --media.count;
  return media;
}

FN int timesEntered(Media media, int body) {
  int times = 0;
  for (int i = 0; i < media.count; ++i) times += media.bodies[i] == body ? 1 : 0;
  return times;
}

// Where the body that fills the place stands in the list; −1: the place is empty.
FN int fillingPlace(Media media) {
  int greatest = -1;
  for (int i = 0; i < media.count; ++i)
    if (greatest < 0 || media.priorities[i] >= media.priorities[greatest]) greatest = i;
  return greatest;
}

// The body that fills the place; −1: none.
FN int fillingBody(Media media) {
  int place = fillingPlace(media);
  return place < 0 ? -1 : media.bodies[place];
}

// Whether a body's surface is there for a ray that goes into it or out of it.
FN bool hasSurface(Media media, int body, int priority, bool is_entering) {
  // Where parts of one mesh overlap, they are one body.
  int times = timesEntered(media, body);
  if (times > (is_entering ? 0 : 1)) return false;
  int filling = fillingPlace(media);
  if (filling < 0) return true;
  if (is_entering) return priority >= media.priorities[filling];
  return times == 0 || media.bodies[filling] == body;
}
