/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * A library with one function of OpenGL ES 1.1, loaded when the program runs already.
 */
unsigned char glIsBuffer(unsigned int buffer);
unsigned char glIsBuffer(unsigned int buffer) { return buffer == 7; }
