#pragma once

#include <functional>
#include <vector>

namespace mirrorball::bench {

/// Runs `work` in a process of its own, so that neither its memory nor what it left in caches and pools is there for
/// what comes after. The caller has no threads yet.
///
/// returns  what `work` returned; nothing when it died
std::vector<double> inChild(const std::function<std::vector<double>()>& work);

/// The most memory [MB] that was resident while `work` ran, above what was before it.
double memoryTakenBy(const std::function<void()>& work);

}  // namespace mirrorball::bench
