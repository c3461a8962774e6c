// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What the thread sanitizer asks a program for when it starts; without it nobody asks.
//
// oneTBB comes from the distribution without the thread sanitizer, so that its own synchronisation cannot be seen;
// base/parallel.cpp tells what our tasks hand over to one another.
// The threads of a parent have not ended in a child of its fork: they are not there.
extern "C" __attribute__((visibility("default"))) const char *__tsan_default_options() {
  return "report_thread_leaks=0";
}

extern "C" __attribute__((visibility("default"))) const char *__tsan_default_suppressions() {
  return "called_from_lib:libtbb.so\n";
}
