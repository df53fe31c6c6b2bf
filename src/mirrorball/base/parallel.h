#pragma once

#include <cstddef>
#include <functional>
#include <future>

namespace mirrorball {

// Where the build has no threads (MIRRORBALL_THREADS=OFF), everything here is done by the one that there is, with the
// same results: parallel_serial.cpp.

/// Calls `body(begin, end)` for consecutive pieces of [0, count) on all cores, and returns when all are done.
///
/// count    how many items there are
/// grain    how many items a piece has (the last may have fewer); the pieces are the same for any number of
///          threads, so a result that is gathered by piece is bit-identical everywhere
/// body     must not throw, and writes only what belongs to its own items
void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

/// How many threads compute at a time: as many as there are cores, or as setThreadLimit said.
int threadLimit();

/// Changes this number for the whole process, before it computes anything. Results do not depend on it; without threads
/// it stays 1.
///
/// threads  at least 1
void setThreadLimit(int threads);

/// The launch policy of std::async for a task that runs beside others: on a thread of its own or, if only one thread
/// may compute, when somebody waits for it.
std::launch besideOthers();

}  // namespace mirrorball
