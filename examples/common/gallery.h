// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// gallery.h: what the pictures of gallery/ share: materials in one expression, lights, smooth surfaces from formulas.
#pragma once

#include <cmath>
#include <vector>

#include "RCFramework.h"
#include "common/box.h"
#include "common/pictures.h"

struct Rgb {
  float r = 0, g = 0, b = 0;
};
struct Point {
  float x = 0, y = 0, z = 0;
};

inline const float kPi = 3.14159265f;

// A material: colour for what it scatters, shares of the mirrored and the refracted ray, a highlight, a texture.
struct Look {
  Rgb colour = {0.8f, 0.8f, 0.8f}, mirror, clear;
  float index = 1, shine = 0;  // shine: the exponent of a white highlight; 0 for none
  RCuint texture = 0;

  // A new material, bound.
  RCuint make() const {
    RCuint name;
    rcBindMaterial(0);
    rcGenMaterials(1, &name);
    rcBindMaterial(name);
    const float white[] = {1, 1, 1};
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, &colour.r);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_REFLECTION, &mirror.r);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, &clear.r);
    rcMaterialf(RC_FRONT_AND_BACK, RC_REFRACTION_INDEX, index);
    if (shine > 0) rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, white);
    rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, shine);
    if (texture) rcEnable(RC_TEXTURE_2D), rcBindTexture(RC_TEXTURE_2D, texture);
    return name;
  }
};

inline Look glass(Rgb clear = {0.92f, 0.95f, 0.94f}) {
  return {.colour = {0.02f, 0.02f, 0.02f}, .mirror = {0.06f, 0.06f, 0.06f}, .clear = clear, .index = 1.5f, .shine = 90};
}

// Light falls through what is drawn afterwards, tinted by it.
inline void lightPasses(bool passes) { (passes ? rcEnable : rcDisable)(RC_USE_TRANSMITTANCE_SHADOW); }

// Binds material 0: a texture that is bound goes into the bound material.
inline RCuint load(const Picture &picture) {
  RCuint texture;
  rcBindMaterial(0);
  rcGenTextures(1, &texture);
  rcBindTexture(RC_TEXTURE_2D, texture);
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, picture.width, picture.height, 0, RC_RGB, RC_UNSIGNED_BYTE,
               picture.rgb.data());
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MIN_FILTER, RC_LINEAR_MIPMAP_LINEAR);
  return texture;
}

// A surface over u, v = 0 ... 1 in columns x rows cells; normals from differences of the formula.
class Surface {
 public:
  template <class Formula>
  Surface(int columns, int rows, Formula &&at) {
    for (int j = 0; j <= rows; ++j) {
      for (int i = 0; i <= columns; ++i) {
        const float u = float(i) / float(columns), v = float(j) / float(rows), e = 1e-3f;
        const Point p = at(u, v), du = at(u + e, v), back = at(u - e, v), dv = at(u, v + e), down = at(u, v - e);
        const Point a{du.x - back.x, du.y - back.y, du.z - back.z}, b{dv.x - down.x, dv.y - down.y, dv.z - down.z};
        m_Corners.insert(m_Corners.end(), {p.x, p.y, p.z});
        m_Normals.insert(m_Normals.end(), {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x});
        m_TexCoords.insert(m_TexCoords.end(), {u, v});
      }
    }
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        const RCuint corner = RCuint(j * (columns + 1) + i), above = corner + RCuint(columns) + 1;
        m_Indices.insert(m_Indices.end(), {corner, corner + 1, above + 1, corner, above + 1, above});
      }
    }
  }

  void draw() const {
    for (RCenum array : kArrays) rcEnableClientState(array);
    rcVertexPointer(3, RC_FLOAT, 0, m_Corners.data());
    rcNormalPointer(RC_FLOAT, 0, m_Normals.data());
    rcTexCoordPointer(2, RC_FLOAT, 0, m_TexCoords.data());
    rcDrawElements(RC_TRIANGLES, RCsizei(m_Indices.size()), RC_UNSIGNED_INT, m_Indices.data());
    for (RCenum array : kArrays) rcDisableClientState(array);
  }
  void drawAt(Point where, float scale = 1) const {
    rcPushMatrix();
    rcTranslatef(where.x, where.y, where.z);
    rcScalef(scale, scale, scale);
    draw();
    rcPopMatrix();
  }

 private:
  static constexpr RCenum kArrays[] = {RC_VERTEX_ARRAY, RC_NORMAL_ARRAY, RC_TEXTURE_COORD_ARRAY};
  std::vector<float> m_Corners, m_Normals, m_TexCoords;
  std::vector<RCuint> m_Indices;
};

// A unit sphere whose front is outside.
inline Surface ball(int detail = 64) {
  return Surface(detail, detail / 2, [](float u, float v) {
    const float longitude = 2 * kPi * u, latitude = kPi * std::clamp(v - 0.5f, -0.4999f, 0.4999f);
    return Point{std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                 std::cos(longitude) * std::cos(latitude)};
  });
}

// A profile (radius, height) over v, turned round the y axis.
template <class Profile>
Surface turned(int around, int upwards, Profile &&profile) {
  return Surface(around, upwards, [&](float u, float v) {
    const Point p = profile(v);
    return Point{p.x * std::sin(2 * kPi * u), p.y, p.x * std::cos(2 * kPi * u)};
  });
}

class GalleryProgram : public RCFramework {
 public:
  explicit GalleryProgram(const char *title) : RCFramework(title, 800, 480) {}

 protected:
  virtual void build() = 0;          // camera, lights, and what stands still
  virtual void move(float /*t*/) {}  // what moves; t: seconds of a film of 25 pictures a second

  BOOL OnIntialize() override {
    rcEnable(RC_LIGHTING);
    rcStaticSceneBegin();
    build();
    rcStaticSceneEnd();
    return TRUE;
  }
  BOOL OnDraw() override {
    if (IsTestMode() && m_Frame >= 3) return FALSE;
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    move(float(m_Frame++) / 25);
    return TRUE;
  }

  void camera(Point eye, Point at, float fovy) {
    rcuPerspective(fovy, float(Width()) / float(Height()), 0.1f, 1000);
    rcuLookAt(eye.x, eye.y, eye.z, at.x, at.y, at.z, 0, 1, 0);
  }
  // A lamp; w = 0 makes it a direction. The ambient light is the first lamp's.
  void lamp(int i, Point at, float w, Rgb diffuse, float ambient = 0) {
    const float position[] = {at.x, at.y, at.z, w}, dim[] = {ambient, ambient, ambient};
    const RCenum light = RC_LIGHT0 + RCenum(i);
    rcEnable(light);
    rcLightfv(light, RC_POSITION, position);
    rcLightfv(light, RC_AMBIENT, dim);
    rcLightfv(light, RC_DIFFUSE, &diffuse.r);
    rcLightfv(light, RC_SPECULAR, &diffuse.r);
  }
  // A rectangle from corner p along a and b; its front is where a x b points. The texture is repeated.
  static void quad(Point p, Point a, Point b, float across = 1, float up = 1) {
    const float corners[] = {p.x,
                             p.y,
                             p.z,
                             p.x + a.x,
                             p.y + a.y,
                             p.z + a.z,
                             p.x + a.x + b.x,
                             p.y + a.y + b.y,
                             p.z + a.z + b.z,
                             p.x + b.x,
                             p.y + b.y,
                             p.z + b.z};
    const float texCoords[] = {0, 0, across, 0, across, up, 0, up};
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, corners);
    rcTexCoordPointer(2, RC_FLOAT, 0, texCoords);
    rcDrawArrays(RC_QUADS, 0, 4);
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
    rcDisableClientState(RC_VERTEX_ARRAY);
  }
  static Picture checkers(Rgb light, Rgb dark) {
    return Picture(64, 64, [=](float u, float v, float *out) {
      const Rgb &c = (u < 0.5f) != (v < 0.5f) ? light : dark;
      out[0] = c.r, out[1] = c.g, out[2] = c.b;
    });
  }
  static Picture wood() {
    return Picture(256, 256, [](float u, float v, float *out) {
      const float plank = std::floor(v * 4), ring = 0.5f + 0.5f * std::sin(40 * (v + 0.25f * cloudNoise(u, v, 4)));
      const float gap = v * 4 - plank < 0.03f ? 0.5f : 1;
      const float tone = gap * (0.75f + 0.2f * ring + 0.15f * gridNoise(int(plank), 3));
      out[0] = 0.62f * tone, out[1] = 0.38f * tone, out[2] = 0.2f * tone;
    });
  }

 private:
  int m_Frame = 0;
};
