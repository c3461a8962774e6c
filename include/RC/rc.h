/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * rc.h: the RayCore API, every rc* function. C99 and C++11.
 *
 * A program sets state, submits triangles, and says with rcFinish (or eglSwapBuffers) that the
 * frame is complete; then the picture is ray traced into the back buffer of the current EGL surface.
 *
 * In every line below:
 *   - angles are in degrees, colours are 0 ... 1, matrices are 16 values column by column;
 *   - names ending in x take 16.16 fixed-point numbers and mean the same as their f twins;
 *   - a call that raises an error changes nothing; the first error sticks until rcGetError reads it;
 *   - IE, IV, IO stand for RC_INVALID_ENUM, RC_INVALID_VALUE, RC_INVALID_OPERATION;
 *   - calls that make names, images, buffers or structures, that draw, trace or read rays raise
 *     RC_OUT_OF_MEMORY where there is not enough;
 *   - calls on matrices raise IO while RC_MATRIX_PALETTE_OES is the mode and the palette is disabled;
 *   - without a current context nothing happens (rcGetError then says RC_INVALID_OPERATION).
 * docs/reference/ holds a page for each family; [G n] is the chapter of the Programming Guide.
 */
#ifndef RC_RC_H
#define RC_RC_H

#include <RC/rctokens.h>
#include <RC/rctypes.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Camera [G 2] --------------------------------------------------------------------------- */

/* Size of the picture in pixels; x and y are not used. Initially the surface's size. IV: w or h < 0. */
RC_APICALL void RC_APIENTRY rcViewport(RCint x, RCint y, RCsizei width, RCsizei height);
/* Window at distance zNear from the eye, in world units; nothing is clipped by near or far.
 * Initially rcuPerspective(60, 800/480, 0.1, 100). IV: near or far <= 0, near = far, l = r, b = t. */
RC_APICALL void RC_APIENTRY rcFrustum(RCdouble left, RCdouble right, RCdouble bottom, RCdouble top, RCdouble zNear,
                                      RCdouble zFar);
RC_APICALL void RC_APIENTRY rcFrustumf(RCfloat left, RCfloat right, RCfloat bottom, RCfloat top, RCfloat zNear,
                                       RCfloat zFar);
RC_APICALL void RC_APIENTRY rcFrustumx(RCfixed left, RCfixed right, RCfixed bottom, RCfixed top, RCfixed zNear,
                                       RCfixed zFar);
/* Colour of pixels whose ray meets nothing, clamped to 0 ... 1; initially black. Alpha is kept, not used. */
RC_APICALL void RC_APIENTRY rcClearColor(RCclampf red, RCclampf green, RCclampf blue, RCclampf alpha);
RC_APICALL void RC_APIENTRY rcClearColorx(RCclampx red, RCclampx green, RCclampx blue, RCclampx alpha);
/* Any mask is accepted and nothing happens: a frame begins after the last one was traced. */
RC_APICALL void RC_APIENTRY rcClear(RCbitfield mask);

/* ---- Transforms [G 3] ----------------------------------------------------------------------- */

/* The matrix the calls below act on: RC_MODELVIEW (initially), RC_PROJECTION, RC_TEXTURE,
 * RC_MATRIX_PALETTE_OES (IO while the palette is not enabled). IE: others. */
RC_APICALL void RC_APIENTRY rcMatrixMode(RCenum mode);
/* Replaces the current matrix by the identity. */
RC_APICALL void RC_APIENTRY rcLoadIdentity(void);
/* Replaces the current matrix by m. */
RC_APICALL void RC_APIENTRY rcLoadMatrixf(const RCfloat *m);
RC_APICALL void RC_APIENTRY rcLoadMatrixx(const RCfixed *m);
/* current = current * m */
RC_APICALL void RC_APIENTRY rcMultMatrixf(const RCfloat *m);
RC_APICALL void RC_APIENTRY rcMultMatrixx(const RCfixed *m);
/* current = current * translation by (x, y, z), in units of the object. */
RC_APICALL void RC_APIENTRY rcTranslatef(RCfloat x, RCfloat y, RCfloat z);
RC_APICALL void RC_APIENTRY rcTranslatex(RCfixed x, RCfixed y, RCfixed z);
/* current = current * rotation by angle degrees, counter-clockwise about (x, y, z). A zero axis: no change. */
RC_APICALL void RC_APIENTRY rcRotatef(RCfloat angle, RCfloat x, RCfloat y, RCfloat z);
RC_APICALL void RC_APIENTRY rcRotatex(RCfixed angle, RCfixed x, RCfixed y, RCfixed z);
/* current = current * scale by (x, y, z). Zero collapses what is drawn: no error, nothing seen. */
RC_APICALL void RC_APIENTRY rcScalef(RCfloat x, RCfloat y, RCfloat z);
RC_APICALL void RC_APIENTRY rcScalex(RCfixed x, RCfixed y, RCfixed z);
/* Saves a copy of the current matrix; 32 levels, 31 pushes. Error: RC_STACK_OVERFLOW. */
RC_APICALL void RC_APIENTRY rcPushMatrix(void);
/* Brings the last saved matrix back. Error: RC_STACK_UNDERFLOW. */
RC_APICALL void RC_APIENTRY rcPopMatrix(void);

/* ---- Lights [G 4] --------------------------------------------------------------------------- */

/* One value of light RC_LIGHT0 ... 7: RC_SPOT_EXPONENT (>= 0), RC_SPOT_INNER_CONE, RC_SPOT_OUTER_CONE =
 * RC_SPOT_CUTOFF (half angles 0 ... 90, or 180), RC_CONSTANT_/LINEAR_/QUADRATIC_ATTENUATION (>= 0),
 * RC_START_/END_ATTENUATION (world units, >= 0). IE: light or pname; IV: range. */
RC_APICALL void RC_APIENTRY rcLightf(RCenum light, RCenum pname, RCfloat param);
RC_APICALL void RC_APIENTRY rcLightx(RCenum light, RCenum pname, RCfixed param);
/* Those, and RC_AMBIENT, RC_DIFFUSE, RC_SPECULAR (3 values are read), RC_POSITION (4; w = 0: direction),
 * RC_SPOT_DIRECTION (3), RC_ATTENUATION_RANGE (2: start, end). Position and spot direction pass through
 * the modelview matrix of this moment into world space. */
RC_APICALL void RC_APIENTRY rcLightfv(RCenum light, RCenum pname, const RCfloat *params);
RC_APICALL void RC_APIENTRY rcLightxv(RCenum light, RCenum pname, const RCfixed *params);
/* Reads a value back; position and direction in world space. IE: light or pname. */
RC_APICALL void RC_APIENTRY rcGetLightfv(RCenum light, RCenum pname, RCfloat *params);
RC_APICALL void RC_APIENTRY rcGetLightxv(RCenum light, RCenum pname, RCfixed *params);

/* ---- Textures [G 5] ------------------------------------------------------------------------- */

/* Makes n texture names, the lowest free ones. IV: n < 0. */
RC_APICALL void RC_APIENTRY rcGenTextures(RCsizei n, RCuint *textures);
/* Deletes; 0 and unknown names are ignored. A material that holds the texture keeps its image. IV: n < 0. */
RC_APICALL void RC_APIENTRY rcDeleteTextures(RCsizei n, const RCuint *textures);
/* Makes a texture current and part of the bound material. target RC_TEXTURE_2D or RC_TEXTURE_2D_NORMAL. IE. */
RC_APICALL void RC_APIENTRY rcBindTexture(RCenum target, RCuint texture);
/* RC_TRUE if the name is in use (0 too). */
RC_APICALL RCboolean RC_APIENTRY rcIsTexture(RCuint texture);
/* Loads the current texture, mip levels included. level and border 0; sides powers of two, 16 ... 1024;
 * internalformat = format = RC_RGB or RC_RGBA; type (UNSIGNED_)BYTE, (UNSIGNED_)SHORT (5-6-5, RGB only) or
 * GL's packed types. Rows follow RC_UNPACK_ALIGNMENT, the first one is at v = 0. NULL pixels: nothing. IE IV IO OOM. */
RC_APICALL void RC_APIENTRY rcTexImage2D(RCenum target, RCint level, RCint internalformat, RCsizei width,
                                         RCsizei height, RCint border, RCenum format, RCenum type,
                                         const RCvoid *pixels);
/* Alpha given to RGB images loaded from now on, 0 ... 255; initially 16, which is opaque; 0 is transparent. */
RC_APICALL void RC_APIENTRY rcTextureAlpha(RCubyte value);
/* RC_TEXTURE_WRAP_S/T (RC_REPEAT initially, RC_CLAMP_TO_EDGE, RC_MIRRORED_REPEAT), RC_TEXTURE_MIN_/MAG_FILTER
 * (any value; RC_LINEAR_MIPMAP_LINEAR is trilinear, else bilinear), RC_GENERATE_MIPMAP,
 * RC_TEXTURE_OPAQUE_ALPHA (1 ... 255, initially 16), RC_TEXTURE_MAX_ANISOTROPY_EXT (1 and more; 16 at most are used;
 * initially 1). IE: target, pname, wrap value; IV: range. */
RC_APICALL void RC_APIENTRY rcTexParameterf(RCenum target, RCenum pname, RCfloat param);
RC_APICALL void RC_APIENTRY rcTexParameteri(RCenum target, RCenum pname, RCint param);
RC_APICALL void RC_APIENTRY rcTexParameterx(RCenum target, RCenum pname, RCfixed param);
RC_APICALL void RC_APIENTRY rcTexParameterfv(RCenum target, RCenum pname, const RCfloat *params);
RC_APICALL void RC_APIENTRY rcTexParameteriv(RCenum target, RCenum pname, const RCint *params);
RC_APICALL void RC_APIENTRY rcTexParameterxv(RCenum target, RCenum pname, const RCfixed *params);
/* Reads one value back. xv gives the plain integer, as the original does. IE: target or pname. */
RC_APICALL void RC_APIENTRY rcGetTexParameterfv(RCenum target, RCenum pname, RCfloat *params);
RC_APICALL void RC_APIENTRY rcGetTexParameteriv(RCenum target, RCenum pname, RCint *params);
RC_APICALL void RC_APIENTRY rcGetTexParameterxv(RCenum target, RCenum pname, RCfixed *params);

/* ---- Materials [G 6] ------------------------------------------------------------------------ */

/* Makes n material names (1 ... 511), each a copy of the bound material. IV: n < 0; OOM: past 511,
 * those that fitted stay and the rest of the array is left alone. */
RC_APICALL void RC_APIENTRY rcGenMaterials(RCsizei n, RCuint *materials);
/* Frees names; 0 and unknown ones are ignored; the bound one gives way to 0. IV: n < 0. */
RC_APICALL void RC_APIENTRY rcDeleteMaterials(RCsizei n, RCuint *materials);
/* Material for what follows; an unused name 1 ... 511 is made. Its texture becomes current. OOM: above 511. */
RC_APICALL void RC_APIENTRY rcBindMaterial(RCuint material);
/* RC_TRUE if the name is in use (0 too). */
RC_APICALL RCboolean RC_APIENTRY rcIsMaterial(RCuint material);
/* face RC_FRONT_AND_BACK. RC_SHININESS (>= 0), RC_SPECULAR_LEVEL (>= 0), RC_REFRACTION_INDEX (>= 0; 0 is taken
 * as 1), RC_ROUGHNESS (>= 0; second generation, stored), RC_REFLECTION and RC_TRANSMITTANCE (for all three
 * channels, clamped to 0 ... 1). IE: face, pname; IV: range. */
RC_APICALL void RC_APIENTRY rcMaterialf(RCenum face, RCenum pname, RCfloat param);
RC_APICALL void RC_APIENTRY rcMaterialx(RCenum face, RCenum pname, RCfixed param);
/* Those (reflection and transmittance as three values), and the colours RC_AMBIENT, RC_DIFFUSE,
 * RC_AMBIENT_AND_DIFFUSE, RC_SPECULAR, RC_EMISSION: three values are read, never a fourth. */
RC_APICALL void RC_APIENTRY rcMaterialfv(RCenum face, RCenum pname, const RCfloat *params);
RC_APICALL void RC_APIENTRY rcMaterialxv(RCenum face, RCenum pname, const RCfixed *params);
/* Reads the bound material; colours with alpha 1. face FRONT, BACK or FRONT_AND_BACK. IE: face, pname. */
RC_APICALL void RC_APIENTRY rcGetMaterialfv(RCenum face, RCenum pname, RCfloat *params);
RC_APICALL void RC_APIENTRY rcGetMaterialxv(RCenum face, RCenum pname, RCfixed *params);
/* Ambient and diffuse of the bound material, 0 ... 1 (ub: 0 ... 255); its specular becomes 0. */
RC_APICALL void RC_APIENTRY rcColor4f(RCfloat red, RCfloat green, RCfloat blue, RCfloat alpha);
RC_APICALL void RC_APIENTRY rcColor4ub(RCubyte red, RCubyte green, RCubyte blue, RCubyte alpha);
RC_APICALL void RC_APIENTRY rcColor4x(RCfixed red, RCfixed green, RCfixed blue, RCfixed alpha);

/* ---- Geometry [G 7] ------------------------------------------------------------------------- */

/* RC_VERTEX_ARRAY, RC_NORMAL_ARRAY, RC_TEXTURE_COORD_ARRAY, RC_COLOR_ARRAY, RC_MATRIX_INDEX_ARRAY_OES,
 * RC_WEIGHT_ARRAY_OES on and off; initially off. IE. */
RC_APICALL void RC_APIENTRY rcEnableClientState(RCenum array);
RC_APICALL void RC_APIENTRY rcDisableClientState(RCenum array);
/* Where the arrays lie. type RC_BYTE, RC_SHORT, RC_FLOAT, RC_FIXED; stride in bytes, 0 = packed.
 * size 3 for vertices, 2 for texture coordinates. IV: size, stride < 0; IE: type. Read at the draw call. */
RC_APICALL void RC_APIENTRY rcVertexPointer(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer);
RC_APICALL void RC_APIENTRY rcTexCoordPointer(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer);
RC_APICALL void RC_APIENTRY rcNormalPointer(RCenum type, RCsizei stride, const RCvoid *pointer);
/* Colours of vertices, which multiply the material's ambient and diffuse; size 4, alpha is not used. types
 * (UNSIGNED_)BYTE, (UNSIGNED_)SHORT (over their largest value), RC_FIXED, RC_FLOAT; clamped to 0 ... 1. */
RC_APICALL void RC_APIENTRY rcColorPointer(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer);
/* Pointer of an array, or its offset in a buffer object: RC_..._ARRAY_POINTER. IE. */
RC_APICALL void RC_APIENTRY rcGetPointerv(RCenum pname, RCvoid **params);
/* Submits vertices first ... first + count - 1 as RC_TRIANGLES, _QUADS, _TRIANGLE_FAN or _TRIANGLE_STRIP.
 * An incomplete last primitive is dropped. IE: mode; IV: first or count < 0. */
RC_APICALL void RC_APIENTRY rcDrawArrays(RCenum mode, RCint first, RCsizei count);
/* The same through count indices of type (UNSIGNED_)BYTE, _SHORT or _INT, all read as unsigned.
 * IE: mode, type; IV: count < 0; IO: NULL indices. */
RC_APICALL void RC_APIENTRY rcDrawElements(RCenum mode, RCsizei count, RCenum type, const RCvoid *indices);

/* ---- Buffer objects: arrays and indices in memory of the library [OpenGL ES 1.1] ----------------- */

/* Makes n names, the lowest free ones. IV: n < 0. */
RC_APICALL void RC_APIENTRY rcGenBuffers(RCsizei n, RCuint *buffers);
/* Deletes; 0 and unknown names are ignored; arrays that read a deleted buffer have no data. IV: n < 0. */
RC_APICALL void RC_APIENTRY rcDeleteBuffers(RCsizei n, const RCuint *buffers);
/* target RC_ARRAY_BUFFER: rc*Pointer calls take offsets into it (IV: beyond its end; IO: it is empty).
 * RC_ELEMENT_ARRAY_BUFFER: rcDrawElements does. An unused name is made; 0: client memory. IE. */
RC_APICALL void RC_APIENTRY rcBindBuffer(RCenum target, RCuint buffer);
/* RC_TRUE if the name is in use (0 too). */
RC_APICALL RCboolean RC_APIENTRY rcIsBuffer(RCuint buffer);
/* Replaces the data of the bound buffer: size bytes, zeros for NULL; usage RC_STATIC_DRAW or RC_DYNAMIC_DRAW.
 * IE: target, usage; IV: size < 0; IO: name 0 is bound; OOM. */
RC_APICALL void RC_APIENTRY rcBufferData(RCenum target, RCsizeiptr size, const RCvoid *data, RCenum usage);
/* Replaces a part of a RC_DYNAMIC_DRAW buffer. IE: target; IO: name 0 is bound, RC_STATIC_DRAW; IV: the part is
 * empty or not within the buffer, NULL data. */
RC_APICALL void RC_APIENTRY rcBufferSubData(RCenum target, RCintptr offset, RCsizeiptr size, const RCvoid *data);
/* RC_BUFFER_SIZE in bytes, RC_BUFFER_USAGE. IE: target, pname; IO: name 0 is bound. */
RC_APICALL void RC_APIENTRY rcGetBufferParameteriv(RCenum target, RCenum pname, RCint *params);

/* ---- Matrix palette: vertices that follow bones [OES_matrix_palette] ----------------------------- */

/* A vertex becomes the sum of weight * palette matrix * modelview * vertex. rcEnable(RC_MATRIX_PALETTE_OES) comes
 * first: without it these raise IO. In matrix mode RC_MATRIX_PALETTE_OES rcLoadIdentity, rcLoadMatrix* and
 * rcMultMatrix* act on the current palette matrix. */
/* Current palette matrix, 0 ... 127; 0 whenever the palette is enabled or disabled. IV. */
RC_APICALL void RC_APIENTRY rcCurrentPaletteMatrixOES(RCuint index);
/* Copies the modelview matrix into the current palette matrix, which is zero before anything is loaded. */
RC_APICALL void RC_APIENTRY rcLoadPaletteFromModelViewMatrixOES(void);
/* Palette matrices of each vertex: 1 ... 128 RC_UNSIGNED_BYTE or RC_UNSIGNED_INT. IE: type; IV: size, stride. */
RC_APICALL void RC_APIENTRY rcMatrixIndexPointerOES(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer);
/* Their weights: 1 ... 128 RC_FLOAT or RC_FIXED. IE: type; IV: size, stride. */
RC_APICALL void RC_APIENTRY rcWeightPointerOES(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer);

/* ---- Scenes and frames [G 8, 9] ------------------------------------------------------------- */

/* Drops static and dynamic geometry, binds material 0; textures, materials, lights, camera stay. */
RC_APICALL void RC_APIENTRY rcSceneAllInit(void);
/* What is drawn until rcStaticSceneEnd replaces the static scene, which lives until it is replaced. */
RC_APICALL void RC_APIENTRY rcStaticSceneBegin(void);
/* Builds the acceleration structure of the static scene. Without a Begin it is ignored. */
RC_APICALL void RC_APIENTRY rcStaticSceneEnd(void);
/* Traces the frame; the picture is in the back buffer on return. Nothing changed: nothing done.
 * IO: a static scene was begun and not ended (it is dropped). rcFlush is the same. */
RC_APICALL void RC_APIENTRY rcFinish(void);
RC_APICALL void RC_APIENTRY rcFlush(void);
/* Generations of rays after the primary hit, clamped to 0 ... 14; initially 10. */
RC_APICALL void RC_APIENTRY rcDepthBounce(RCuint value);

/* ---- Second generation (RayCore MC): stored, without effect on the picture yet ----------------- */

/* Radius of all lights in world units; 0: hard shadows. Initially 100. */
RC_APICALL void RC_APIENTRY rcSetLightRadius(RCfloat radius);
/* Probability of a diffuse ray in tenths, 0 ... 10; initially 10. */
RC_APICALL void RC_APIENTRY rcSetDiffuseRate(RCuint rate);
/* Samples a pixel, 1 ... 32; initially 8. */
RC_APICALL void RC_APIENTRY rcSetSPPCount(RCuint count);

/* ---- State and errors ----------------------------------------------------------------------- */

/* The first error since the last call, then RC_NO_ERROR. */
RC_APICALL RCenum RC_APIENTRY rcGetError(void);
/* RC_LIGHTING, RC_LIGHT0 ... 7, RC_USE_SHADOW, RC_USE_COLOR_SHADOW (frame); RC_TEXTURE_2D(_NORMAL) (bound
 * material); RC_USE_TEXTURE_ONLY, RC_USE_TRANSMITTANCE_SHADOW, RC_USE_TEXTURE_ALPHA_SHADOW (captured by
 * each draw); RC_MATRIX_PALETTE_OES; RC_LARGE_TEXTURES. Of GL ES 1.1's: RC_FOG, RC_SCISSOR_TEST, RC_MULTISAMPLE
 * (frame; the last one is on initially), RC_CULL_FACE, RC_ALPHA_TEST, RC_CLIP_PLANE0 ... 5 (each draw); the others
 * are kept without effect. IE: names that are none. */
RC_APICALL void RC_APIENTRY rcEnable(RCenum cap);
RC_APICALL void RC_APIENTRY rcDisable(RCenum cap);
RC_APICALL RCboolean RC_APIENTRY rcIsEnabled(RCenum cap);
/* RC_MIPMAP_HINT: RC_NICEST always samples the base level. RC_RAYBOUNCE_THRESHOLD_HINT: RC_THRESHOLD_LEVELi
 * drops secondary rays of weight under (i+1)/100. RC_RENDERING_HINT: RC_NICEST takes four samples a pixel,
 * _FASTEST_AND_NICEST only at edges. RC_STRUCTURE_HINT: RC_STRUCTURE_KD_TREE, _BVH, _NONE are what is built from now
 * on. GL's other hints are accepted. Initially RC_DONT_CARE. IE: target or mode. */
RC_APICALL void RC_APIENTRY rcHint(RCenum target, RCenum mode);
/* Beyond the vendor's API: calls that fail in the current context tell callback what, where and why; NULL (initially):
 * nobody. The message is that of RAYCORE_LOG=error. The callback must call no rc* function and let no exception out. */
RC_APICALL void RC_APIENTRY rcDebugMessageCallbackRCX(RCDEBUGPROCRCX callback, const RCvoid *userParam);
/* State by name, converted to the type asked for; RGBA colours become 0 ... 255 in integers. IE: pname. */
RC_APICALL void RC_APIENTRY rcGetBooleanv(RCenum pname, RCboolean *params);
RC_APICALL void RC_APIENTRY rcGetFixedv(RCenum pname, RCfixed *params);
RC_APICALL void RC_APIENTRY rcGetFloatv(RCenum pname, RCfloat *params);
RC_APICALL void RC_APIENTRY rcGetIntegerv(RCenum pname, RCint *params);
/* RC_VENDOR, RC_RENDERER, RC_VERSION, RC_EXTENSIONS; a constant string, never to be freed. IE: NULL. */
RC_APICALL const RCubyte *RC_APIENTRY rcGetString(RCenum name);

/* ---- Beyond the vendor's API ------------------------------------------------------------------ */

/* What the primary rays of pixels meet, and what it cost: RC_RAY_DISTANCE, _MATERIAL, _BOXES, _TRIANGLES; one value a
 * pixel, the lowest row first. IE: pname; IV: a negative size; IO: no surface. [RC_RCX_ray_queries] */
RC_APICALL void RC_APIENTRY rcReadRaysRCX(RCint x, RCint y, RCsizei width, RCsizei height, RCenum pname,
                                          RCfloat *values);

#ifdef __cplusplus
}
#endif

#include <RC/rces11.h>

/* The guide's other spellings of functions above. [G 4.1e, 7.2a] */
#define rcDrawArray rcDrawArrays
#define rcLight rcLightf
#define rcLightv rcLightfv

#endif /* RC_RC_H */
