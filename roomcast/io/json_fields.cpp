// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/json_fields.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "roomcast/io/file_bytes.h"

namespace roomcast::io {
namespace {

using nlohmann::json;

const json& empty_object() {
  static const json kEmpty = json::object();
  return kEmpty;
}

}  // namespace

Result<json> read_json_object(const std::filesystem::path& path) {
  std::vector<std::uint8_t> bytes;
  if (Status status = read_file(path, kMaxJsonFileBytes, bytes); !status.ok()) {
    return status.error();
  }
  json parsed = json::parse(bytes.begin(), bytes.end(), nullptr, /*allow_exceptions=*/false);
  if (parsed.is_discarded()) {
    return Error{ErrorCode::kMalformed, path.string() + " is not valid JSON"};
  }
  if (!parsed.is_object()) {
    return Error{ErrorCode::kMalformed, path.string() + " must be one JSON object"};
  }
  return parsed;
}

void JsonProblems::add(const std::string& field, const std::string& what) {
  if (first_.empty()) first_ = file_.string() + ": field " + field + " " + what;
}

Status JsonProblems::status() const {
  if (first_.empty()) return {};
  return Error{ErrorCode::kMalformed, first_};
}

JsonFields::JsonFields(const json& object, std::string name, JsonProblems& problems)
    : object_(&object), name_(std::move(name)), problems_(&problems) {}

std::string JsonFields::full_name(const char* field) const {
  return name_.empty() ? field : name_ + "." + field;
}

void JsonFields::reject(const char* field, const std::string& what) const {
  problems_->add(full_name(field), what);
}

const json* JsonFields::find(const char* field) const {
  const auto found = object_->find(field);
  return found == object_->end() || found->is_null() ? nullptr : &*found;
}

bool JsonFields::has(const char* field) const {
  return find(field) != nullptr;
}

double JsonFields::number(const char* field) const {
  const json* const value = find(field);
  if (value == nullptr || !value->is_number()) {
    reject(field, value == nullptr ? "is missing" : "must be a number");
    return 0;
  }
  return value->get<double>();
}

double JsonFields::number(const char* field, double otherwise) const {
  return has(field) ? number(field) : otherwise;
}

int JsonFields::integer(const char* field) const {
  const double value = number(field);
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()) {
    reject(field, "must be a whole number");
    return 0;
  }
  return static_cast<int>(value);
}

bool JsonFields::boolean(const char* field, bool otherwise) const {
  const json* const value = find(field);
  if (value == nullptr) return otherwise;
  if (!value->is_boolean()) {
    reject(field, "must be true or false");
    return otherwise;
  }
  return value->get<bool>();
}

std::string JsonFields::text(const char* field) const {
  const json* const value = find(field);
  if (value == nullptr || !value->is_string()) {
    reject(field, value == nullptr ? "is missing" : "must be a text");
    return {};
  }
  return value->get<std::string>();
}

std::string JsonFields::text(const char* field, const std::string& otherwise) const {
  return has(field) ? text(field) : otherwise;
}

std::vector<double> JsonFields::numbers(const char* field) const {
  const json* const value = find(field);
  if (value == nullptr || !value->is_array() || value->size() > kMaxJsonArray) {
    reject(field, value == nullptr ? "is missing" : "must be a list of numbers");
    return {};
  }
  std::vector<double> numbers;
  for (const json& element : *value) {
    if (!element.is_number()) {
      reject(field, "must be a list of numbers");
      return {};
    }
    numbers.push_back(element.get<double>());
  }
  return numbers;
}

std::vector<std::uint64_t> JsonFields::counts(const char* field, std::uint64_t largest) const {
  if (!has(field)) return {};
  std::vector<std::uint64_t> counts;
  for (const double number : numbers(field)) {
    if (!(number >= 0) || number > static_cast<double>(largest) || number != std::floor(number)) {
      reject(field, "must be whole numbers from 0 to " + std::to_string(largest));
      return {};
    }
    counts.push_back(static_cast<std::uint64_t>(number));
  }
  return counts;
}

RigidTransform JsonFields::transform(const char* field) const {
  const std::vector<double> row_major = numbers(field);
  if (row_major.empty()) {
    reject(field, "is not a transform: a transform needs 16 numbers, row by row");
    return {};
  }
  auto parsed = transform_from_row_major(row_major);
  if (!parsed.ok()) {
    reject(field, "is not a transform: " + parsed.error().message);
    return {};
  }
  return *parsed;
}

JsonFields JsonFields::object(const char* field) const {
  const json* const value = find(field);
  if (value != nullptr && value->is_object()) return {*value, full_name(field), *problems_};
  reject(field, value == nullptr ? "is missing" : "must be an object");
  return {empty_object(), full_name(field), *problems_};
}

std::vector<JsonFields> JsonFields::objects(const char* field) const {
  const json* const value = find(field);
  if (value == nullptr || !value->is_array()) {
    reject(field, value == nullptr ? "is missing" : "must be a list");
    return {};
  }
  std::vector<JsonFields> objects;
  for (const json& element : *value) {
    const std::string name = full_name(field) + "[" + std::to_string(objects.size()) + "]";
    if (!element.is_object()) problems_->add(name, "must be an object");
    objects.emplace_back(element.is_object() ? element : empty_object(), name, *problems_);
  }
  return objects;
}

}  // namespace roomcast::io
