// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The pictures of the reference: one scene, drawn in the state that the argument names. Without one: the first.
#include <cstring>

#include "RCFramework.h"
#include "common/pictures.h"
#include "common/sphere.h"

namespace {

enum class Subject { Row, Ball, Room, Panes };

struct State {
  const char *name;
  Subject subject;
  void (*set)();
};

void fog(float mode) {
  const float haze[] = {0.75f, 0.8f, 0.85f, 1};
  rcEnable(RC_FOG);
  rcFogf(RC_FOG_MODE, mode);
  rcFogfv(RC_FOG_COLOR, haze);
  rcFogf(RC_FOG_START, 3);
  rcFogf(RC_FOG_END, 18);
  rcFogf(RC_FOG_DENSITY, 0.1f);
}

void sides(RCenum which) {
  rcEnable(RC_CULL_FACE);
  rcCullFace(which);
}

void spot(float exponent, float outer) {
  const float down[] = {0.4f, -0.6f, -0.7f};
  rcLightfv(RC_LIGHT0, RC_SPOT_DIRECTION, down);
  rcLightf(RC_LIGHT0, RC_SPOT_EXPONENT, exponent);
  rcLightf(RC_LIGHT0, RC_SPOT_INNER_CONE, 10);
  rcLightf(RC_LIGHT0, RC_SPOT_OUTER_CONE, outer);
}

void wrap(RCint mode) {
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, mode);
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_WRAP_T, mode);
}

void environment(RCint mode) {
  const float blue[] = {0.1f, 0.2f, 0.8f, 1};
  rcTexEnvi(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, mode);
  rcTexEnvfv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_COLOR, blue);
}

void three(RCenum name, float value) {
  const float values[] = {value, value, value};
  rcMaterialfv(RC_FRONT_AND_BACK, name, values);
}

void highlight(float exponent) {
  three(RC_SPECULAR, 1);
  rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, exponent);
}

void glass(float index) {
  three(RC_TRANSMITTANCE, 0.9f);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFRACTION_INDEX, index);
}

void cutOff() {
  const float plane[] = {0.4f, -1, -0.3f, 1.1f};
  rcEnable(RC_CLIP_PLANE0);
  rcClipPlanef(RC_CLIP_PLANE0, plane);
}

// The state of the model is set before it is drawn, with its material bound.
constexpr State kStates[] = {
    {"fog-off", Subject::Row, [] {}},
    {"fog-linear", Subject::Row, [] { fog(RC_LINEAR); }},
    {"fog-exp", Subject::Row, [] { fog(RC_EXP); }},
    {"fog-exp2", Subject::Row, [] { fog(RC_EXP2); }},
    {"cull-off", Subject::Room, [] {}},
    {"cull-front", Subject::Room, [] { sides(RC_FRONT); }},
    {"cull-back", Subject::Room, [] { sides(RC_BACK); }},
    {"shade-smooth", Subject::Ball, [] { rcShadeModel(RC_SMOOTH); }},
    {"shade-flat", Subject::Ball, [] { rcShadeModel(RC_FLAT); }},
    {"clip", Subject::Ball, cutOff},
    {"spot-wide", Subject::Row, [] { spot(0, 40); }},
    {"spot-narrow", Subject::Row, [] { spot(0, 20); }},
    {"spot-exponent", Subject::Row, [] { spot(40, 40); }},
    {"attenuation", Subject::Row, [] { rcLightf(RC_LIGHT0, RC_QUADRATIC_ATTENUATION, 0.03f); }},
    {"wrap-repeat", Subject::Panes, [] { wrap(RC_REPEAT); }},
    {"wrap-mirrored", Subject::Panes, [] { wrap(RC_MIRRORED_REPEAT); }},
    {"wrap-clamp", Subject::Panes, [] { wrap(RC_CLAMP_TO_EDGE); }},
    {"env-modulate", Subject::Panes, [] { environment(RC_MODULATE); }},
    {"env-add", Subject::Panes, [] { environment(RC_ADD); }},
    {"env-blend", Subject::Panes, [] { environment(RC_BLEND); }},
    {"shininess-5", Subject::Ball, [] { highlight(5); }},
    {"shininess-80", Subject::Ball, [] { highlight(80); }},
    {"reflection", Subject::Ball, [] { three(RC_REFLECTION, 0.6f); }},
    {"transmittance", Subject::Ball, [] { glass(1); }},
    {"refraction-index", Subject::Ball, [] { glass(1.5f); }},
    {"ortho", Subject::Row, [] { rcOrthof(-5, 5, -3, 3, 0.1f, 100); }},
};

const State &stateNamed(const char *name) {
  for (const State &state : kStates) {
    if (std::strcmp(state.name, name) == 0) return state;
  }
  return kStates[0];
}

class States : public RCFramework {
 public:
  States() : RCFramework("The reference's states", 400, 240) {}

 protected:
  BOOL OnIntialize() override {
    const State &state = stateNamed(m_Cmd.argc > 1 ? m_Cmd.argv[1] : "");
    rcClearColor(0.55f, 0.65f, 0.8f, 1);
    rcuPerspective(40, float(Width()) / float(Height()), 0.1f, 100);
    rcuLookAt(-1.2f, 2, 6.5f, 0.3f, 0.6f, 0, 0, 1, 0);
    setLight();
    rcStaticSceneBegin();
    draw(state);
    rcStaticSceneEnd();
    return TRUE;
  }

 private:
  static void setLight() {
    const float lamp[] = {-4, 6, 6, 1}, dim[] = {0.3f, 0.3f, 0.3f}, full[] = {1, 1, 1};
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcLightfv(RC_LIGHT0, RC_POSITION, lamp);
    rcLightfv(RC_LIGHT0, RC_AMBIENT, dim);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, full);
    rcLightfv(RC_LIGHT0, RC_SPECULAR, full);
  }

  // What is drawn before set() is the same in all pictures of a subject.
  void draw(const State &state) const {
    drawFloor();
    switch (state.subject) {
      case Subject::Panes:
        return drawPane(state.set);
      case Subject::Room:
        newMaterial(0.8f, 0.6f, 0.3f);
        state.set();
        return drawOpenBox();
      case Subject::Row:
        newMaterial(0.8f, 0.15f, 0.1f);
        state.set();
        drawBall(-1, 2, 0.9f, Sphere(48, 24));
        drawBall(1.6f, -2, 0.9f, Sphere(48, 24));
        drawBall(5.5f, -8, 0.9f, Sphere(48, 24));
        return;
      case Subject::Ball:
        newMaterial(0.8f, 0.15f, 0.1f);
        state.set();
        return drawBall(0.3f, 1.5f, 1.2f, Sphere(16, 10));
    }
  }

  static void newMaterial(float r, float g, float b) {
    const float colour[] = {r, g, b};
    RCuint material;
    rcBindMaterial(0);
    rcGenMaterials(1, &material);
    rcBindMaterial(material);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, colour);
  }

  static void drawBall(float x, float z, float radius, const Sphere &sphere) {
    rcPushMatrix();
    rcTranslatef(x, radius, z);
    rcScalef(radius, radius, radius);
    sphere.draw();
    rcPopMatrix();
  }

  // Without a lid, and open to the viewer.
  static void drawOpenBox() {
    static const float box[] = {
        -1,   0, 2, -1,   0, 0, -1,   1.6f, 0, -1,   1.6f, 2,  // left, right, back; fronts look inwards
        1.6f, 0, 0, 1.6f, 0, 2, 1.6f, 1.6f, 2, 1.6f, 1.6f, 0, -1, 0, 0, 1.6f, 0, 0, 1.6f, 1.6f, 0, -1, 1.6f, 0};
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, box);
    rcDrawArrays(RC_QUADS, 0, 12);
    rcDisableClientState(RC_VERTEX_ARRAY);
  }

  static void bindTexture(const Picture &picture) {
    RCuint texture;
    rcGenTextures(1, &texture);
    rcEnable(RC_TEXTURE_2D);
    rcBindTexture(RC_TEXTURE_2D, texture);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, picture.width, picture.height, 0, RC_RGB, RC_UNSIGNED_BYTE,
                 picture.rgb.data());
  }

  static void drawTextured(const float *vertices, const float *texCoords) {
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcTexCoordPointer(2, RC_FLOAT, 0, texCoords);
    rcDrawArrays(RC_QUADS, 0, 4);
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
    rcDisableClientState(RC_VERTEX_ARRAY);
  }

  static void drawFloor() {
    static const float floor[] = {-30, 0, 8, 30, 0, 8, 30, 0, -60, -30, 0, -60}, often[] = {0, 0, 30, 0, 30, 34, 0, 34};
    newMaterial(1, 1, 1);
    bindTexture(Picture(64, 64, [](float u, float v, float *out) {
      const float tone = (u < 0.5f) != (v < 0.5f) ? 0.85f : 0.35f;
      out[0] = tone, out[1] = 0.95f * tone, out[2] = 0.85f * tone;
    }));
    drawTextured(floor, often);
  }

  // A picture with a corner of its own, three times each way.
  static void drawPane(void (*set)()) {
    static const float pane[] = {-1.4f, 0.02f, 1, 2, 0.02f, 1, 2, 2.3f, 0, -1.4f, 2.3f, 0};
    static const float thrice[] = {-1, -1, 2, -1, 2, 2, -1, 2};
    newMaterial(0.9f, 0.5f, 0.3f);
    bindTexture(Picture(64, 64, [](float u, float v, float *out) {
      const bool isCorner = u + v < 0.6f, isFrame = std::min(std::min(u, v), std::min(1 - u, 1 - v)) < 0.06f;
      out[0] = isFrame ? 0.1f : isCorner ? 0.9f : 0.3f + 0.5f * u;
      out[1] = isFrame ? 0.1f : isCorner ? 0.2f : 0.7f;
      out[2] = isFrame ? 0.1f : isCorner ? 0.2f : 0.4f + 0.5f * v;
    }));
    set();
    drawTextured(pane, thrice);
  }
};

States g_Program;

}  // namespace
