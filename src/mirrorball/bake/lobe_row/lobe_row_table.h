#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// Rows of 2, 4 and 6 lobes; formula/bsdf/lobe_row.glsl tells what they are for.
inline constexpr int kLobesInRows = 12;

/// The table of rows as it is stored with the program: kLobeRowSize · kLobesInRows texels wide, kLobeRowSize high, with
/// four channels that formula::placeInLobeRows finds and formula::lobeOfRow reads.
///
/// errors   none but of a program that was built wrong
/// cost     less than 1 ms
Result<Image> lobeRowTable();

/// The part of it with rows of so many lobes: a table of its own, that of lobe 0 to the left.
///
/// lobes    2, 4 or 6
Result<Image> lobeRowTable(int lobes);

/// The texels of a row between those of a table, as a texture is read: bilinearly.
///
/// table                  lobeRowTable(); of one count of lobes or of all
/// first, count           the row's lobes in it
/// perceptual_roughness   in [0, 1], as n·v = cosine is
std::vector<glm::vec4> lobeRowIn(const Image& table, int first, int count, float perceptual_roughness, float cosine);

/// Fits the whole table anew.
///
/// Rows are fitted from one to the next, so that each lobe keeps its role, and then a few times beside the mean of
/// their neighbours, so that the table is smooth.
///
/// errors   interrupted (when `progress` says so)
/// cost     some 2 minutes on 2 cores; the same for any number of threads
/// from     docs/lobe_rows.md
Result<Image> fittedLobeRowTable(const ProgressFunction& progress = {});

}  // namespace mirrorball
