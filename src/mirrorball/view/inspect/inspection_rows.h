#pragma once

#include <vector>

#include "mirrorball/scene/scene.h"
#include "mirrorball/view/inspect/inspector.h"

namespace mirrorball {

/// The facts of an inspection as text: numbers have four digits. Of the material those that every one has, and those
/// that are not a new material's, by the names and units of its table (materialParameters).
///
/// scene    that was inspected
std::vector<InspectionRow> rowsOf(const Inspection& inspection, const Scene& scene);

}  // namespace mirrorball
