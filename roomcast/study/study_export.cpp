// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/study_export.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/core/csv_field.h"
#include "roomcast/io/new_folder.h"
#include "roomcast/study/log_records.h"

namespace roomcast::study {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

struct Column {
  std::string_view name, type, unit, meaning;
};

constexpr std::array kParticipantColumns = {
    Column{"participant", "text", "", "number of the person, who is known by nothing else"},
    Column{"number", "number", "",
           "counts the participants from 1; decides the order of conditions"},
    Column{"consented_at", "time", "UTC", "when the person agreed"},
    Column{"plan", "text", "",
           "begin of the SHA-256 of the plan: plans/ in the folder of the study"},
    Column{"order", "text", "", "names of the conditions in the order of this person"},
    Column{"steps", "number", "", "steps of the session that have ended"},
    Column{"seconds", "number", "s", "length of the session, up to its last record"}};
constexpr std::array kEveryColumns = {
    Column{"participant", "text", "", "number of the person"},
    Column{"t_s", "number", "s", "since the session began"},
    Column{"condition", "text", "", "in which it was written; empty: in none"}};

std::string number_text(const Json& value) {
  return value.is_number_float() ? fmt::format("{:.10g}", value.get<double>()) : value.dump();
}

std::string cell(const Json& value) {
  if (value.is_string()) return csv_field(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  return number_text(value);
}

class CsvFiles {
 public:
  explicit CsvFiles(fs::path folder) : folder_(std::move(folder)) {}

  void row(const std::string& file, const std::vector<std::string>& cells) {
    auto& [stream, rows] = at(file);
    for (std::size_t i = 0; i < cells.size(); ++i) stream << (i == 0 ? "" : ",") << cells[i];
    stream << "\r\n";
    ++rows;
  }
  Status finish(std::map<std::string, std::size_t>& rows) {
    for (auto& [name, file] : files_) {
      file.stream.close();
      if (!file.stream)
        return Error{ErrorCode::kUnavailable,
                     "cannot write " + (folder_ / name).string() + ": is the disk full?"};
      rows[name] = file.rows - 1;  // without the names of the columns
    }
    return {};
  }

 private:
  struct File {
    std::ofstream stream;
    std::size_t rows = 0;
  };
  File& at(const std::string& name) {
    auto& file = files_[name];
    if (!file.stream.is_open()) file.stream.open(folder_ / name, std::ios::binary);
    return file;
  }

  const fs::path folder_;
  std::map<std::string, File> files_;
};

std::string file_of(const LogKind& kind) {
  return std::string(kind.name) + ".csv";
}

/// The names of all columns, and what they mean.
void write_heads(CsvFiles& files) {
  const std::string dictionary = "data_dictionary.csv";
  files.row(dictionary, {"file", "column", "type", "unit", "meaning"});
  const auto describe = [&](const std::string& file, const Column& column) {
    files.row(dictionary, {csv_field(file), std::string(column.name), std::string(column.type),
                           std::string(column.unit), csv_field(std::string(column.meaning))});
  };
  std::vector<std::string> names;
  for (const Column& column : kParticipantColumns) {
    names.emplace_back(column.name);
    describe("participants.csv", column);
  }
  files.row("participants.csv", names);
  for (const LogKind& kind : log_kinds()) {
    names.clear();
    for (const Column& column : kEveryColumns) {
      names.emplace_back(column.name);
      describe(file_of(kind), column);
    }
    for (const LogField& field : kind.fields) {
      names.emplace_back(field.name);
      describe(file_of(kind), {field.name, name_of(field.type), field.unit, field.meaning});
    }
    files.row(file_of(kind), names);
  }
}

void write_session(const std::string& id, const std::vector<Json>& records, CsvFiles& files) {
  std::string condition;
  for (const Json& record : records) {
    const LogKind& kind = *find_kind(record.at("kind").get_ref<const std::string&>());
    const auto change = condition_after(record);
    if (change && !change->empty()) condition = *change;
    std::vector<std::string> cells = {id, number_text(record.at("t")), csv_field(condition)};
    for (const LogField& field : kind.fields) cells.push_back(cell(record.at(field.name)));
    files.row(file_of(kind), cells);
    if (change && change->empty()) condition.clear();  // its end is still within it
  }
}

}  // namespace

Result<StudyExport> export_csv(const StudyFolder& study, const fs::path& out) {
  if (auto status = io::make_new_folder(out); !status) return status.error();
  CsvFiles files(out);
  write_heads(files);
  StudyExport done;
  for (const std::string& id : study.participants()) {
    const auto person = study.participant(id);
    if (!person) return person.error();
    const auto log = study.log(id);
    if (!log) return log.error();
    write_session(id, log->records, files);
    std::string order;
    for (const std::string& name : person->order) order += (order.empty() ? "" : " ") + name;
    files.row("participants.csv",
              {id, std::to_string(person->number), person->consented_at,
               person->plan_sha256.substr(0, 16), csv_field(order),
               std::to_string(log->progress.steps), fmt::format("{:.3f}", log->progress.t)});
    ++done.participants;
  }
  if (auto status = files.finish(done.rows); !status) return status.error();
  return done;
}

}  // namespace roomcast::study
