// SPDX-License-Identifier: Apache-2.0
#include "roomcast/python/errors.h"

#include "roomcast/core/error_name.h"

namespace roomcast::python {
namespace {

namespace py = pybind11;

constexpr const char* kDoc =
    "Raised wherever roomcast cannot do what was asked: its text is one sentence for people.\n\n"
    "Attribute code (str): invalid_argument, not_found, malformed, too_large, unsupported,\n"
    "unavailable or closed.";

/// Sentences quote files, whose names and contents need not be UTF-8.
py::object text_of(const std::string& sentence) {
  PyObject* text = PyUnicode_DecodeUTF8(sentence.data(), static_cast<Py_ssize_t>(sentence.size()),
                                        "backslashreplace");
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(text);
}

}  // namespace

void add_error(py::module_& module) {
  module.attr("Error") = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc("roomcast.Error", kDoc, PyExc_Exception, nullptr));
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Failure& failure) {
      const py::object type = py::module_::import("roomcast._core").attr("Error");
      const py::object error = type(text_of(failure.error().message));
      error.attr("code") = std::string(name_of(failure.error().code));
      PyErr_SetObject(type.ptr(), error.ptr());
    }
  });
}

}  // namespace roomcast::python
