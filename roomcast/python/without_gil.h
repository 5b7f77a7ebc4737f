// SPDX-License-Identifier: Apache-2.0
// WithoutGil: while it lives, its thread runs without the lock of Python's interpreter, so that
// other Python threads run meanwhile. Unlike pybind11's gil_scoped_release it is safe when the
// program ends: an interpreter that ends kills threads that ask for the lock (before Python 3.14),
// by an unwinding that C++ destructors do not survive. A thread that comes back so late waits here
// for the end of the process instead. Threading: each object belongs to one thread.
#pragma once

#include <pybind11/pybind11.h>

namespace roomcast::python {

class WithoutGil {
 public:
  /// The thread must hold the lock.
  WithoutGil();
  ~WithoutGil();
  WithoutGil(const WithoutGil&) = delete;
  WithoutGil& operator=(const WithoutGil&) = delete;

 private:
  PyThreadState* const state_;
};

/// Makes Python call prepare_for_exit() before its interpreter ends.
void register_exit(pybind11::module_& module);

}  // namespace roomcast::python
