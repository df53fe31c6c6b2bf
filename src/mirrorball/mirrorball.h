#pragma once

/// \mainpage
/// Everything to load, convert, prefilter and save environment maps, and to render models in their light. Functions and
/// their errors are described where they are declared; MIRRORBALL_TRY (base/result.h) passes failures on. Link
/// mirrorball::mirrorball.

#include "mirrorball/bake/bake.h"
#include "mirrorball/bake/brdf/brdf_table.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/environment/statistics.h"
#include "mirrorball/height_field/cone_map.h"
#include "mirrorball/height_field/heights_from_normals.h"
#include "mirrorball/height_field/maximum_pyramid.h"
#include "mirrorball/height_field/occlusion.h"
#include "mirrorball/height_field/slopes.h"
#include "mirrorball/metric/comparison.h"
#include "mirrorball/metric/flip/flip.h"
#include "mirrorball/metric/image_error.h"
#include "mirrorball/metric/picture/comparison_sheet.h"
#include "mirrorball/metric/picture/heat_map.h"
#include "mirrorball/metric/ssim.h"
#include "mirrorball/output/baked/baked_set.h"
#include "mirrorball/output/convert_file.h"
#include "mirrorball/output/save_map.h"
#include "mirrorball/photo/find_ball.h"
#include "mirrorball/photo/merge.h"
#include "mirrorball/photo/photograph.h"
#include "mirrorball/photo/unwrap.h"
#include "mirrorball/render/frame/cube_capture.h"
#include "mirrorball/render/frame/render_inputs.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/frame/turntable.h"
#include "mirrorball/scene/gltf/gltf_writer.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material_changes.h"
#include "mirrorball/scene/tangents.h"

// The rooms that trace rays are not in a build without Embree, nor are their headers installed.
#if __has_include("mirrorball/rays/geometry.h")
#include "mirrorball/study/fresnel_forms.h"
#include "mirrorball/study/page/page.h"
#include "mirrorball/study/section_sheet.h"
#include "mirrorball/study/study.h"
#include "mirrorball/trace/path_tracer.h"
#include "mirrorball/transfer/detail_transfer.h"
#include "mirrorball/transfer/normal_space.h"
#include "mirrorball/transfer/simplify.h"
#include "mirrorball/transfer/unwrap/unwrap.h"
#endif
