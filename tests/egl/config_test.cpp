// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Configs: what there is, what a list without an attribute asks for, which configs satisfy a list and in which order.
// The rules are written here once more, from the tables of the specification. [EGL 1.5, 3.4]
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "egl/egl_fixture.h"

namespace rc::test {
namespace {

enum class Rule { AtLeast, Exact, Mask, None };
struct Row {
  EGLint name;
  EGLint initial;
  Rule rule;
};

// Table 3.4: what a list without the attribute asks for, and how it is compared.
const Row kTable34[] = {
    {EGL_BUFFER_SIZE, 0, Rule::AtLeast},
    {EGL_RED_SIZE, 0, Rule::AtLeast},
    {EGL_GREEN_SIZE, 0, Rule::AtLeast},
    {EGL_BLUE_SIZE, 0, Rule::AtLeast},
    {EGL_LUMINANCE_SIZE, 0, Rule::AtLeast},
    {EGL_ALPHA_SIZE, 0, Rule::AtLeast},
    {EGL_ALPHA_MASK_SIZE, 0, Rule::AtLeast},
    {EGL_BIND_TO_TEXTURE_RGB, EGL_DONT_CARE, Rule::Exact},
    {EGL_BIND_TO_TEXTURE_RGBA, EGL_DONT_CARE, Rule::Exact},
    {EGL_COLOR_BUFFER_TYPE, EGL_RGB_BUFFER, Rule::Exact},
    {EGL_CONFIG_CAVEAT, EGL_DONT_CARE, Rule::Exact},
    {EGL_CONFIG_ID, EGL_DONT_CARE, Rule::Exact},
    {EGL_CONFORMANT, 0, Rule::Mask},
    {EGL_DEPTH_SIZE, 0, Rule::AtLeast},
    {EGL_LEVEL, 0, Rule::Exact},
    {EGL_MAX_SWAP_INTERVAL, EGL_DONT_CARE, Rule::Exact},
    {EGL_MIN_SWAP_INTERVAL, EGL_DONT_CARE, Rule::Exact},
    {EGL_NATIVE_RENDERABLE, EGL_DONT_CARE, Rule::Exact},
    {EGL_NATIVE_VISUAL_TYPE, EGL_DONT_CARE, Rule::Exact},
    {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, Rule::Mask},
    {EGL_SAMPLE_BUFFERS, 0, Rule::AtLeast},
    {EGL_SAMPLES, 0, Rule::AtLeast},
    {EGL_STENCIL_SIZE, 0, Rule::AtLeast},
    {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, Rule::Mask},
    {EGL_TRANSPARENT_TYPE, EGL_NONE, Rule::Exact},
    {EGL_TRANSPARENT_RED_VALUE, EGL_DONT_CARE, Rule::None},
    {EGL_TRANSPARENT_GREEN_VALUE, EGL_DONT_CARE, Rule::None},
    {EGL_TRANSPARENT_BLUE_VALUE, EGL_DONT_CARE, Rule::None},
    {EGL_MAX_PBUFFER_WIDTH, EGL_DONT_CARE, Rule::None},
    {EGL_MAX_PBUFFER_HEIGHT, EGL_DONT_CARE, Rule::None},
    {EGL_MAX_PBUFFER_PIXELS, EGL_DONT_CARE, Rule::None},
    {EGL_NATIVE_VISUAL_ID, EGL_DONT_CARE, Rule::None},
};

using Values = std::map<EGLint, EGLint>;

class Configs : public Egl {
 protected:
  std::vector<EGLConfig> all() {
    EGLConfig found[100];
    EGLint count = 0;
    EXPECT_TRUE(eglGetConfigs(mDisplay, found, 100, &count));
    return std::vector<EGLConfig>(found, found + count);
  }
  std::vector<EGLint> ids(std::vector<EGLint> list) {
    list.push_back(EGL_NONE);
    EGLConfig found[100];
    EGLint count = -1;
    EXPECT_TRUE(eglChooseConfig(mDisplay, list.data(), found, 100, &count));
    std::vector<EGLint> numbers;
    for (EGLint i = 0; i < count; ++i) numbers.push_back(valueOf(found[i], EGL_CONFIG_ID));
    return numbers;
  }

  // The specification's answer for what a list asks for.
  std::vector<EGLint> expected(const Values &asked) {
    std::vector<Values> matching;
    for (const Values &config : everything()) {
      if (matches(config, asked)) matching.push_back(config);
    }
    std::stable_sort(matching.begin(), matching.end(),
                     [&](const Values &a, const Values &b) { return comesBefore(a, b, asked); });
    std::vector<EGLint> numbers;
    for (const Values &config : matching) numbers.push_back(config.at(EGL_CONFIG_ID));
    return numbers;
  }

 private:
  const std::vector<Values> &everything() {
    if (!mEverything.empty()) return mEverything;
    for (const EGLConfig config : all()) {
      Values values;
      for (const Row &row : kTable34) values[row.name] = valueOf(config, row.name);
      mEverything.push_back(values);
    }
    std::reverse(mEverything.begin(), mEverything.end());  // the order must come from the rules
    return mEverything;
  }

  static EGLint wanted(const Values &asked, const Row &row) {
    const auto found = asked.find(row.name);
    return found == asked.end() ? row.initial : found->second;
  }

  static bool matches(const Values &config, const Values &asked) {
    const auto id = asked.find(EGL_CONFIG_ID);
    if (id != asked.end() && id->second != EGL_DONT_CARE) return config.at(EGL_CONFIG_ID) == id->second;
    for (const Row &row : kTable34) {
      const EGLint want = wanted(asked, row), have = config.at(row.name);
      if (want == EGL_DONT_CARE || row.rule == Rule::None) continue;
      if (row.rule == Rule::AtLeast && have < want) return false;
      if (row.rule == Rule::Exact && have != want) return false;
      if (row.rule == Rule::Mask && (have & want) != want) return false;
    }
    return true;
  }

  // 3.4.1.2, rule by rule.
  static bool comesBefore(const Values &a, const Values &b, const Values &asked) {
    const auto caveat = [](const Values &c) {
      return c.at(EGL_CONFIG_CAVEAT) == EGL_NONE ? 0 : c.at(EGL_CONFIG_CAVEAT) == EGL_SLOW_CONFIG ? 1 : 2;
    };
    if (caveat(a) != caveat(b)) return caveat(a) < caveat(b);
    if (a.at(EGL_COLOR_BUFFER_TYPE) != b.at(EGL_COLOR_BUFFER_TYPE))
      return a.at(EGL_COLOR_BUFFER_TYPE) == EGL_RGB_BUFFER;
    EGLint bitsOfA = 0, bitsOfB = 0;
    for (const EGLint size : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_LUMINANCE_SIZE, EGL_ALPHA_SIZE}) {
      if (!asked.contains(size) || asked.at(size) == 0 || asked.at(size) == EGL_DONT_CARE) continue;
      bitsOfA += a.at(size);
      bitsOfB += b.at(size);
    }
    if (bitsOfA != bitsOfB) return bitsOfA > bitsOfB;
    for (const EGLint smaller : {EGL_BUFFER_SIZE, EGL_SAMPLE_BUFFERS, EGL_SAMPLES, EGL_DEPTH_SIZE, EGL_STENCIL_SIZE,
                                 EGL_ALPHA_MASK_SIZE, EGL_CONFIG_ID}) {
      if (a.at(smaller) != b.at(smaller)) return a.at(smaller) < b.at(smaller);
    }
    return false;
  }

  std::vector<Values> mEverything;
};

TEST_F(Configs, EveryColourDepthAndNumberOfSamples) {
  std::set<std::vector<EGLint>> found;
  for (const EGLConfig config : all()) {
    std::vector<EGLint> key;
    for (const EGLint name :
         {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE, EGL_DEPTH_SIZE, EGL_SAMPLES}) {
      key.push_back(valueOf(config, name));
    }
    EXPECT_TRUE(found.insert(key).second) << "twice the same";
    EXPECT_EQ(valueOf(config, EGL_BUFFER_SIZE), key[0] + key[1] + key[2] + key[3]);
    EXPECT_EQ(valueOf(config, EGL_SAMPLE_BUFFERS), key[5] > 0 ? 1 : 0);
    EXPECT_EQ(valueOf(config, EGL_BIND_TO_TEXTURE_RGBA), key[3] > 0 ? EGL_TRUE : EGL_FALSE);
    EXPECT_EQ(valueOf(config, EGL_SURFACE_TYPE) & (EGL_WINDOW_BIT | EGL_PBUFFER_BIT | EGL_PIXMAP_BIT),
              EGL_WINDOW_BIT | EGL_PBUFFER_BIT | EGL_PIXMAP_BIT);
    EXPECT_EQ(valueOf(config, EGL_RENDERABLE_TYPE), EGL_OPENGL_ES_BIT);
    EXPECT_EQ(valueOf(config, EGL_CONFORMANT), 0) << "rays pass no test of OpenGL ES";
    EXPECT_EQ(valueOf(config, EGL_CONFIG_CAVEAT), EGL_NONE)
        << "the mask has said it, and none is slower than the others";
  }
  EXPECT_EQ(found.size(), 36u);
  EXPECT_TRUE(found.contains({8, 8, 8, 0, 16, 0})) << "the guide's";
  EXPECT_TRUE(found.contains({5, 6, 5, 0, 16, 4}));
  EXPECT_TRUE(found.contains({8, 8, 8, 8, 24, 16}));
}

// A list that names one attribute with its default finds what the empty list finds.
TEST_F(Configs, TheDefaultOfEveryAttribute) {
  const std::vector<EGLint> byDefault = ids({});
  EXPECT_EQ(byDefault.size(), 36u);
  for (const Row &row : kTable34) EXPECT_EQ(ids({row.name, row.initial}), byDefault) << std::hex << row.name;
  EXPECT_EQ(ids({EGL_MATCH_NATIVE_PIXMAP, EGL_NONE}), byDefault);
}

TEST_F(Configs, TheDefaultsExclude) {
  EXPECT_TRUE(ids({EGL_LEVEL, 1}).empty());
  EXPECT_TRUE(ids({EGL_COLOR_BUFFER_TYPE, EGL_LUMINANCE_BUFFER}).empty());
  EXPECT_TRUE(ids({EGL_TRANSPARENT_TYPE, EGL_TRANSPARENT_RGB}).empty());
  EXPECT_TRUE(ids({EGL_RENDERABLE_TYPE, EGL_OPENGL_ES2_BIT}).empty());
  EXPECT_TRUE(ids({EGL_CONFORMANT, EGL_OPENGL_ES_BIT}).empty());
  EXPECT_TRUE(ids({EGL_CONFIG_CAVEAT, EGL_SLOW_CONFIG}).empty());
  EXPECT_TRUE(ids({EGL_CONFIG_CAVEAT, EGL_NON_CONFORMANT_CONFIG}).empty());
  EXPECT_TRUE(ids({EGL_STENCIL_SIZE, 1}).empty());
}

TEST_F(Configs, TheListsOfProgramsFindWhatTheyMean) {
  const std::vector<EGLint> guide = {
      EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 16, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT};
  const EGLConfig config = choose(guide);
  ASSERT_TRUE(config);
  EXPECT_EQ(valueOf(config, EGL_ALPHA_SIZE), 0);
  EXPECT_EQ(valueOf(config, EGL_DEPTH_SIZE), 16);
  EXPECT_EQ(valueOf(config, EGL_SAMPLES), 0);
  EXPECT_EQ(ids({EGL_CONFIG_CAVEAT, EGL_NONE}).size(), 36u) << "programs that want no caveat";
  EXPECT_EQ(ids({EGL_SURFACE_TYPE, EGL_PIXMAP_BIT}).size(), 36u) << "full screen";
  EXPECT_EQ(valueOf(choose({EGL_RED_SIZE, 8, EGL_SAMPLE_BUFFERS, 1, EGL_SAMPLES, 5}), EGL_SAMPLES), 8);
}

TEST_F(Configs, AnIdIsAllThatCounts) {
  EXPECT_EQ(ids({EGL_CONFIG_ID, 2, EGL_STENCIL_SIZE, 99}), std::vector<EGLint>{2});
  EXPECT_TRUE(ids({EGL_CONFIG_ID, 9999}).empty());
}

TEST_F(Configs, RandomListsAgreeWithTheRules) {
  std::mt19937 random(1);
  const auto below = [&](size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random); };
  // What each attribute is asked for: values in and out of reach.
  const std::map<EGLint, std::vector<EGLint>> choices = {
      {EGL_COLOR_BUFFER_TYPE, {EGL_RGB_BUFFER, EGL_RGB_BUFFER, EGL_LUMINANCE_BUFFER}},
      {EGL_CONFIG_CAVEAT, {EGL_NONE, EGL_NONE, EGL_SLOW_CONFIG, EGL_NON_CONFORMANT_CONFIG}},
      {EGL_CONFIG_ID, {EGL_DONT_CARE, EGL_DONT_CARE, EGL_DONT_CARE, 1, 17, 36, 99}},
      {EGL_CONFORMANT, {0, 0, 0, EGL_OPENGL_ES_BIT}},
      {EGL_LEVEL, {0, 0, 0, 1}},
      {EGL_NATIVE_VISUAL_TYPE, {EGL_DONT_CARE, EGL_NONE, 4}},
      {EGL_RENDERABLE_TYPE, {EGL_OPENGL_ES_BIT, 0, EGL_OPENGL_ES_BIT, EGL_OPENGL_ES2_BIT}},
      {EGL_SURFACE_TYPE,
       {0, EGL_WINDOW_BIT, EGL_PBUFFER_BIT | EGL_PIXMAP_BIT, EGL_MULTISAMPLE_RESOLVE_BOX_BIT,
        EGL_SWAP_BEHAVIOR_PRESERVED_BIT, EGL_VG_ALPHA_FORMAT_PRE_BIT}},
      {EGL_TRANSPARENT_TYPE, {EGL_NONE, EGL_NONE, EGL_TRANSPARENT_RGB}},
      {EGL_BIND_TO_TEXTURE_RGB, {EGL_TRUE, EGL_TRUE, EGL_FALSE}},
      {EGL_BIND_TO_TEXTURE_RGBA, {EGL_TRUE, EGL_FALSE}},
      {EGL_NATIVE_RENDERABLE, {EGL_FALSE, EGL_FALSE, EGL_TRUE}},
      {EGL_RED_SIZE, {0, 1, 5, 6, 8, 9}},
      {EGL_GREEN_SIZE, {0, 1, 5, 6, 7, 8}},
      {EGL_BLUE_SIZE, {0, 1, 5, 6, 8}},
      {EGL_ALPHA_SIZE, {0, 0, 1, 8}},
      {EGL_BUFFER_SIZE, {0, 16, 17, 24, 32, 33}},
      {EGL_DEPTH_SIZE, {0, 1, 16, 17, 24, 32}},
      {EGL_SAMPLES, {0, 1, 4, 5, 8, 16, 17}},
      {EGL_SAMPLE_BUFFERS, {0, 1, 1, 2}},
  };
  size_t found = 0;
  for (int round = 0; round < 5000; ++round) {
    std::vector<EGLint> list;
    Values asked;
    for (size_t i = below(6); i-- > 0;) {
      const EGLint name = kTable34[below(std::size(kTable34))].name;
      const auto values = choices.find(name);
      EGLint value = values == choices.end() ? 0 : values->second[below(values->second.size())];
      if (name != EGL_LEVEL && below(6) == 0) value = EGL_DONT_CARE;
      list.insert(list.end(), {name, value});
      asked[name] = value;
    }
    const std::vector<EGLint> got = ids(list);
    ASSERT_EQ(got, expected(asked)) << testing::PrintToString(list);
    found += got.size();
  }
  EXPECT_GT(found, 5000u) << "most lists must find something, or nothing is tested";
}

TEST_F(Configs, CountsAndRoom) {
  EGLConfig found[40];
  std::fill(std::begin(found), std::end(found), kNothing);
  EGLint count = -1;
  EXPECT_TRUE(eglGetConfigs(mDisplay, nullptr, 0, &count));
  EXPECT_EQ(count, 36);
  EXPECT_TRUE(eglGetConfigs(mDisplay, found, 5, &count));
  EXPECT_EQ(count, 5);
  EXPECT_NE(found[4], kNothing);
  EXPECT_EQ(found[5], kNothing);
  EXPECT_TRUE(eglChooseConfig(mDisplay, nullptr, nullptr, 3, &count));
  EXPECT_EQ(count, 36) << "without room all are counted";
  EXPECT_TRUE(eglChooseConfig(mDisplay, nullptr, found, 0, &count));
  EXPECT_EQ(count, 0);
}

TEST_F(Configs, ValuesThatMeanNothingAreErrors) {
  const std::vector<std::vector<EGLint>> wrong = {{0x7777, 1},
                                                  {0, 0},
                                                  {EGL_RED_SIZE, -2},
                                                  {EGL_BIND_TO_TEXTURE_RGB, 4},
                                                  {EGL_BIND_TO_TEXTURE_RGBA, 5},
                                                  {EGL_COLOR_BUFFER_TYPE, EGL_NONE},
                                                  {EGL_CONFIG_CAVEAT, EGL_TRUE},
                                                  {EGL_TRANSPARENT_TYPE, EGL_RGB_BUFFER},
                                                  {EGL_NATIVE_RENDERABLE, 7},
                                                  {EGL_LEVEL, EGL_DONT_CARE},
                                                  {EGL_SURFACE_TYPE, 1 << 20},
                                                  {EGL_RENDERABLE_TYPE, 1 << 20},
                                                  {EGL_MATCH_NATIVE_PIXMAP, 5}};
  for (std::vector<EGLint> list : wrong) {
    list.push_back(EGL_NONE);
    EGLint count = -1;
    EXPECT_FALSE(eglChooseConfig(mDisplay, list.data(), nullptr, 0, &count)) << std::hex << list[0];
    expectError(EGL_BAD_ATTRIBUTE);
    EXPECT_EQ(count, -1) << "a failing call changes nothing";
  }
  EGLint value = 0;
  EXPECT_FALSE(eglGetConfigAttrib(mDisplay, mConfig, EGL_MATCH_NATIVE_PIXMAP, &value)) << "only to choose by";
  expectError(EGL_BAD_ATTRIBUTE);
}

}  // namespace
}  // namespace rc::test
