// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The lines of the call tracer, and the names of tokens in them.
#include "api/call_trace.h"

#include <map>
#include <set>

#include "api/context_fixture.h"
#include "api/tokens.h"

namespace rc::test {
namespace {

using api::describeCall;
using api::Outcome;
using api::Traced;

constexpr struct {
  const char *name;
  RCenum value;
} kNamedTokens[] = {
#define RC_TOKEN(name, value) {#name, value},
#include "headers/token_values.inc"
#undef RC_TOKEN
};

// What a call with these arguments is written as.
template <class... Arguments>
std::string line(const char *function, const Arguments &...arguments) {
  return describeCall(function, {api::traced(arguments)...}, {.frame = 3});
}

TEST(Trace, ArgumentsByName) {
  EXPECT_EQ(line("rcLightf", RCenum(RC_LIGHT3), RCenum(RC_SPOT_CUTOFF), 95.5f),
            "frame 3: rcLightf(light = RC_LIGHT3, pname = RC_SPOT_CUTOFF, param = 95.5)");
  EXPECT_EQ(line("rcViewport", 0, -1, 640, 480), "frame 3: rcViewport(x = 0, y = -1, width = 640, height = 480)");
  EXPECT_EQ(line("rcFinish"), "frame 3: rcFinish()");
  EXPECT_EQ(line("rcColorMask", RCboolean(1), RCboolean(0), RCboolean(1), RCboolean(0)),
            "frame 3: rcColorMask(red = RC_TRUE, green = RC_FALSE, blue = RC_TRUE, alpha = RC_FALSE)");
  EXPECT_EQ(line("rcTexEnvi", RCenum(RC_TEXTURE_ENV), RCenum(RC_TEXTURE_ENV_MODE), RC_MODULATE),
            "frame 3: rcTexEnvi(target = RC_TEXTURE_ENV, pname = RC_TEXTURE_ENV_MODE, param = RC_MODULATE)");
  EXPECT_EQ(line("rcPixelStorei", RCenum(RC_PACK_ALIGNMENT), 4),
            "frame 3: rcPixelStorei(pname = RC_PACK_ALIGNMENT, param = 4)");
}

TEST(Trace, FixedPointIsMarked) {
  EXPECT_EQ(line("rcTranslatex", kFixedOne, -kFixedOne / 2, 0), "frame 3: rcTranslatex(x = 1x, y = -0.5x, z = 0x)");
  EXPECT_EQ(line("rcAlphaFuncx", RCenum(RC_LESS), kFixedOne / 4), "frame 3: rcAlphaFuncx(func = RC_LESS, ref = 0.25x)");
}

TEST(Trace, ListsAndPointers) {
  const float plane[] = {1, 0, 0.5f, -2};
  const RCfixed fixed[] = {kFixedOne, 0, 0, -kFixedOne};
  EXPECT_EQ(line("rcClipPlanef", RCenum(RC_CLIP_PLANE1), api::list(plane, 4)),
            "frame 3: rcClipPlanef(plane = RC_CLIP_PLANE1, equation = {1, 0, 0.5, -2})");
  EXPECT_EQ(line("rcClipPlanex", RCenum(RC_CLIP_PLANE1), api::list(fixed, 4)),
            "frame 3: rcClipPlanex(plane = RC_CLIP_PLANE1, equation = {1x, 0x, 0x, -1x})");
  EXPECT_EQ(line("rcClipPlanef", RCenum(RC_CLIP_PLANE1), api::list<float>(nullptr, 4)),
            "frame 3: rcClipPlanef(plane = RC_CLIP_PLANE1, equation = NULL)");
  EXPECT_EQ(line("rcDeleteTextures", -2, api::list(fixed, -2)), "frame 3: rcDeleteTextures(n = -2, textures = {})");
  EXPECT_EQ(line("rcDeleteTextures", 1, api::list(fixed, [] { return 1; })),
            "frame 3: rcDeleteTextures(n = 1, textures = {65536})");
  const void *nothing = nullptr;
  EXPECT_EQ(line("rcVertexPointer", 3, RCenum(RC_FLOAT), 12, nothing),
            "frame 3: rcVertexPointer(size = 3, type = RC_FLOAT, stride = 12, pointer = NULL)");
  EXPECT_NE(line("rcVertexPointer", 3, RCenum(RC_FLOAT), 12, static_cast<const void *>(plane)).find("pointer = 0x"),
            std::string::npos);
}

TEST(Trace, SmallTokensByTheirParameter) {
  EXPECT_EQ(line("rcDrawArrays", RCenum(RC_TRIANGLE_STRIP), 2, 7),
            "frame 3: rcDrawArrays(mode = RC_TRIANGLE_STRIP, first = 2, count = 7)");
  EXPECT_EQ(line("rcBlendFunc", RCenum(RC_ONE), RCenum(RC_ZERO)),
            "frame 3: rcBlendFunc(sfactor = RC_ONE, dfactor = RC_ZERO)");
  EXPECT_EQ(line("rcEnable", RCenum(1)), "frame 3: rcEnable(cap = 1)");
  EXPECT_EQ(line("rcEnable", kNoToken), "frame 3: rcEnable(cap = 0x7A7A)");
}

TEST(Trace, ResultsAndErrors) {
  EXPECT_EQ(describeCall("rcIsTexture", {Traced(int64_t{5})}, {.frame = 1, .result = int64_t{1}}),
            "frame 1: rcIsTexture(texture = 5) = RC_TRUE");
  EXPECT_EQ(describeCall("rcGetError", {}, {.frame = 2, .result = int64_t{RC_STACK_OVERFLOW}}),
            "frame 2: rcGetError() = RC_STACK_OVERFLOW");
  EXPECT_EQ(describeCall("rcGetString", {Traced(int64_t{RC_RENDERER})}, {.frame = 2, .result = "RayCore"}),
            "frame 2: rcGetString(name = RC_RENDERER) = \"RayCore\"");
  EXPECT_EQ(describeCall("rcPopMatrix", {},
                         {.frame = 7, .result = {}, .error = RC_STACK_UNDERFLOW, .reason = "there is one matrix"}),
            "frame 7: rcPopMatrix(): RC_STACK_UNDERFLOW: there is one matrix");
  EXPECT_EQ(describeCall("rcFinish", {}, {.frame = 0, .result = {}, .error = RC_INVALID_OPERATION, .reason = "why"}),
            "no context: rcFinish(): RC_INVALID_OPERATION: why");
}

TEST(Trace, NoErrorHasAName) {
  EXPECT_EQ(line("rcHint", RCenum(RC_FOG_HINT), RCenum(RC_NICEST)),
            "frame 3: rcHint(target = RC_FOG_HINT, mode = RC_NICEST)");
  EXPECT_EQ(describeCall("rcGetError", {}, {.frame = 2, .result = int64_t{RC_NO_ERROR}}),
            "frame 2: rcGetError() = RC_NO_ERROR");
}

// Each value has one of the names it has in the headers.
TEST(Trace, EveryTokenHasAName) {
  std::map<RCenum, std::set<std::string>> names;
  for (const auto &[name, value] : kNamedTokens) names[value].insert(name);
  for (const auto &[value, choices] : names) {
    if (value < 8) continue;  // several names each: by parameter
    EXPECT_TRUE(choices.contains(api::tokenName(value, "")))
        << api::tokenName(value, "") << " for " << *choices.begin();
  }
  EXPECT_EQ(api::tokenName(RC_LIGHT0 + 517, ""), "RC_LIGHT517");
}

TEST(Trace, EveryErrorHasAName) {
  EXPECT_STREQ(api::errorName(RC_NO_ERROR), "RC_NO_ERROR");
  EXPECT_STREQ(api::errorName(RC_OUT_OF_MEMORY), "RC_OUT_OF_MEMORY");
  EXPECT_STREQ(api::errorName(kNoToken), "an unknown error");
}

// The line of a frame says why its picture is black.
TEST(Trace, TheFramesLine) {
  ddk::FrameStats stats;
  stats.width = 64;
  stats.height = 48;
  stats.staticTriangles = 8;
  stats.dynamicTriangles = 4;
  stats.skipped = {.degenerate = 2, .notFinite = 1, .noData = 3, .clipped = 5};
  stats.lights = 2;
  stats.rays.primary = 3072;
  stats.rays.primaryHits = 0;
  stats.rays.shadow = 7;
  const std::string text = ddk::describe(stats);
  for (const char *part :
       {"64 x 48", "12 triangles (8 static, 4 dynamic)", "6 skipped (2 degenerate, 1 not finite, 3 without data)",
        "5 behind clip planes", "2 lights on", "3072 primary, of which 0 met something", "7 shadow"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
  }
  stats.defaultLight = true;
  EXPECT_NE(ddk::describe(stats).find("no light on"), std::string::npos);
}

}  // namespace
}  // namespace rc::test
