// SPDX-License-Identifier: Apache-2.0
// Strict reading of untrusted JSON files: every field is read by name and type, and the first
// problem is kept as a sentence with file and field. Throws no exceptions. Single-threaded. Include
// only in .cpp files: the JSON library is slow to compile.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::io {

inline constexpr std::size_t kMaxJsonFileBytes = 4U << 20U;
inline constexpr std::size_t kMaxJsonArray = 1U << 20U;

/// Returns kNotFound, kTooLarge as read_file; kMalformed unless the file is one JSON object.
Result<nlohmann::json> read_json_object(const std::filesystem::path& path);

/// The first problem of a file, if any.
class JsonProblems {
 public:
  explicit JsonProblems(std::filesystem::path file) : file_(std::move(file)) {}
  void add(const std::string& field, const std::string& what);
  [[nodiscard]] Status status() const;

 private:
  std::filesystem::path file_;
  std::string first_;
};

/// One object of a file. A field that is missing or of the wrong type is reported, and reads as
/// zero, empty or false.
class JsonFields {
 public:
  /// `name` is the path to `object` inside the file, empty for the root; both must outlive this
  /// object.
  JsonFields(const nlohmann::json& object, std::string name, JsonProblems& problems);

  [[nodiscard]] bool has(const char* field) const;  // present and not null
  [[nodiscard]] double number(const char* field) const;
  [[nodiscard]] double number(const char* field, double otherwise) const;
  [[nodiscard]] int integer(const char* field) const;  // any value of int
  [[nodiscard]] bool boolean(const char* field, bool otherwise) const;
  [[nodiscard]] std::string text(const char* field) const;
  [[nodiscard]] std::string text(const char* field, const std::string& otherwise) const;
  [[nodiscard]] std::vector<double> numbers(const char* field) const;
  /// Integers from 0 to `largest`; empty if the field is missing.
  [[nodiscard]] std::vector<std::uint64_t> counts(const char* field, std::uint64_t largest) const;
  [[nodiscard]] RigidTransform transform(const char* field) const;  // row-major 4x4
  [[nodiscard]] JsonFields object(const char* field) const;
  [[nodiscard]] std::vector<JsonFields> objects(const char* field) const;

  /// Reports the problem `what` of a field.
  void reject(const char* field, const std::string& what) const;

 private:
  [[nodiscard]] const nlohmann::json* find(const char* field) const;
  [[nodiscard]] std::string full_name(const char* field) const;

  const nlohmann::json* object_;
  std::string name_;
  JsonProblems* problems_;
};

}  // namespace roomcast::io
