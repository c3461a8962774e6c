// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rcDebugMessageCallbackRCX: each error as a text. [RC_RCX_debug_messages]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

struct Message {
  RCenum source, type;
  RCuint id;
  RCenum severity;
  RCsizei length;
  std::string text;
};

class DebugMessageTest : public ContextTest {
 protected:
  static void RC_APIENTRY keep(RCenum source, RCenum type, RCuint id, RCenum severity, RCsizei length,
                               const RCchar *text, const RCvoid *list) {
    auto *messages = static_cast<std::vector<Message> *>(const_cast<RCvoid *>(list));
    messages->push_back({source, type, id, severity, length, text});
  }

  std::vector<Message> messages;
};

TEST_F(DebugMessageTest, TellsFunctionErrorArgumentAndWhatIsAllowed) {
  rcDebugMessageCallbackRCX(keep, &messages);
  rcLightf(RC_LIGHT0, RC_SPOT_CUTOFF, 95);
  ASSERT_EQ(messages.size(), 1u);
  const Message &m = messages[0];
  EXPECT_EQ(m.source, RCenum(RC_DEBUG_SOURCE_API));
  EXPECT_EQ(m.type, RCenum(RC_DEBUG_TYPE_ERROR));
  EXPECT_EQ(m.id, RCuint(RC_INVALID_VALUE));
  EXPECT_EQ(m.severity, RCenum(RC_DEBUG_SEVERITY_HIGH));
  EXPECT_EQ(m.length, RCsizei(m.text.size()));
  EXPECT_EQ(m.text, "rcLightf: RC_INVALID_VALUE: params is 95 for pname RC_SPOT_CUTOFF, not 0 ... 90 degrees or 180");
}

TEST_F(DebugMessageTest, TellsEachErrorWhileTheFirstOneSticks) {
  rcDebugMessageCallbackRCX(keep, &messages);
  rcEnable(kNoToken);
  rcViewport(0, 0, -1, 1);
  rcMatrixMode(RC_MODELVIEW);
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[1].text, "rcViewport: RC_INVALID_VALUE: width x height is -1 x 1, not 0 or more");
  EXPECT_EQ(rcGetError(), RCenum(RC_INVALID_ENUM));
  EXPECT_CLEAN();
}

TEST_F(DebugMessageTest, NullEndsIt) {
  rcDebugMessageCallbackRCX(keep, &messages);
  rcDebugMessageCallbackRCX(nullptr, nullptr);
  rcEnable(kNoToken);
  EXPECT_TRUE(messages.empty());
  EXPECT_EQ(rcGetError(), RCenum(RC_INVALID_ENUM));
}

TEST_F(DebugMessageTest, BelongsToItsContext) {
  rcDebugMessageCallbackRCX(keep, &messages);
  const auto first = std::move(context);
  useProfile("guide");
  rcEnable(kNoToken);
  EXPECT_TRUE(messages.empty());
  EXPECT_EQ(rcGetError(), RCenum(RC_INVALID_ENUM));
}

}  // namespace
}  // namespace rc::test
