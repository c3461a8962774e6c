// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// caps.h: what rcEnable accepts without effect. [reference 4.3]
#pragma once

#include <algorithm>
#include <iterator>

#include "RC/rctokens.h"
#include "RC/rctypes.h"

namespace rc::api {

// Caps of GL ES 1.1 that mean nothing to rays: accepted, and always reported off. [reference 4.3]
inline constexpr RCenum kInertCaps[] = {RC_ALPHA_TEST,
                                        RC_BLEND,
                                        RC_COLOR_LOGIC_OP,
                                        RC_CLIP_PLANE0,
                                        RC_CLIP_PLANE1,
                                        RC_CLIP_PLANE2,
                                        RC_CLIP_PLANE3,
                                        RC_CLIP_PLANE4,
                                        RC_CLIP_PLANE5,
                                        RC_COLOR_MATERIAL,
                                        RC_CULL_FACE,
                                        RC_DEPTH_TEST,
                                        RC_DITHER,
                                        RC_FOG,
                                        RC_LINE_SMOOTH,
                                        RC_MULTISAMPLE,
                                        RC_NORMALIZE,
                                        RC_POINT_SMOOTH,
                                        RC_POINT_SPRITE_OES,
                                        RC_POLYGON_OFFSET_FILL,
                                        RC_RESCALE_NORMAL,
                                        RC_SAMPLE_ALPHA_TO_COVERAGE,
                                        RC_SAMPLE_ALPHA_TO_ONE,
                                        RC_SAMPLE_COVERAGE,
                                        RC_SCISSOR_TEST,
                                        RC_STENCIL_TEST};

inline bool isInertCap(RCenum cap) {
  return std::find(std::begin(kInertCaps), std::end(kInertCaps), cap) != std::end(kInertCaps);
}

}  // namespace rc::api
