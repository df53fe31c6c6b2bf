// The functions of xxHash, which stand in its header: for builds for browsers, to which the system's library is
// foreign.

#define XXH_STATIC_LINKING_ONLY
#define XXH_IMPLEMENTATION
#include <xxhash.h>
