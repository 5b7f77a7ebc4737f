// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mcap/reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "roomcast/recording/mcap/linear_scan.h"
#include "roomcast/recording/mcap/summary_section.h"

namespace roomcast::recording::mcap {

Result<Reader> Reader::open(const std::filesystem::path& path) {
  auto source = open_file(path);
  if (!source) return source.error();
  return read(std::move(*source), path.string());
}

Result<Reader> Reader::read(std::unique_ptr<ByteSource> source, std::string name) {
  Reader reader(std::move(source), std::move(name));
  if (auto status = reader.check_start(); !status) return reader.named(status.error());
  auto summary = reader.read_end();
  if (summary) {
    reader.summary_ = std::move(*summary);
    reader.sound_bytes_ = reader.source_->size();
    return reader;
  }
  auto scan = scan_from_start(*reader.source_);
  reader.summary_ = std::move(scan.summary);
  reader.sound_bytes_ = scan.sound_bytes;
  reader.damage_ = reader.named(summary.error()).message;
  return reader;
}

Status Reader::check_start() const {
  std::array<std::uint8_t, kMagic.size()> start{};
  const bool is_mcap = source_->read(0, start) && start == kMagic;
  if (is_mcap) return {};
  return Error{ErrorCode::kMalformed, "it is not an MCAP file"};
}

Result<Summary> Reader::read_end() const {
  Bytes end(kFooterBytes + kMagic.size());
  if (source_->size() < kMagic.size() + end.size())
    return Error{ErrorCode::kMalformed, "its end is missing"};
  const std::uint64_t footer_start = source_->size() - end.size();
  if (auto status = source_->read(footer_start, end); !status) return status.error();
  const auto footer = read_footer(end);
  if (!footer) return footer.error();
  if (footer->summary_start == 0) return Error{ErrorCode::kMalformed, "it has no summary"};
  const std::uint64_t section_end = source_->size() - kMagic.size() - 4;  // just before the CRC
  if (footer->summary_start > footer_start ||
      section_end - footer->summary_start > kMaxSummaryBytes) {
    return Error{ErrorCode::kMalformed, "its summary's position is invalid"};
  }
  Bytes section(static_cast<std::size_t>(section_end - footer->summary_start));
  if (auto status = source_->read(footer->summary_start, section); !status) return status.error();
  return read_summary(section, *footer);
}

Result<Bytes> Reader::record_at(std::uint64_t offset, std::uint64_t length, Opcode opcode,
                                std::size_t limit) const {
  if (length < kRecordHeaderBytes || length > limit + kRecordHeaderBytes)
    return Error{ErrorCode::kTooLarge, "a record in it has an invalid length"};
  if (offset > source_->size() || length > source_->size() - offset)
    return Error{ErrorCode::kMalformed, "its summary names records beyond its end"};
  std::array<std::uint8_t, 1> found{};
  if (auto status = source_->read(offset, found); !status) return status.error();
  if (Opcode{found[0]} != opcode)
    return Error{ErrorCode::kMalformed, "its summary names missing records"};
  Bytes content(static_cast<std::size_t>(length - kRecordHeaderBytes));
  if (auto status = source_->read(offset + kRecordHeaderBytes, content); !status)
    return status.error();
  return content;
}

Result<ChunkContents> Reader::chunk(std::size_t number) const {
  const ChunkIndex& index = summary_.chunks[number];
  auto record = record_at(index.offset, index.length, Opcode::kChunk, kMaxChunkBytes);
  if (!record) return named(record.error());
  auto contents = open_chunk(std::move(*record));
  if (!contents) return named(contents.error());
  return contents;
}

Result<StringMap> Reader::metadata(const std::string& name) const {
  const auto& list = summary_.metadata;
  const auto found = std::find_if(list.rbegin(), list.rend(),
                                  [&](const MetadataIndex& index) { return index.name == name; });
  if (found == list.rend())
    return named({ErrorCode::kNotFound, "it has no metadata \"" + name + "\""});
  const auto record = record_at(found->offset, found->length, Opcode::kMetadata, kMaxMetadataBytes);
  if (!record) return named(record.error());
  auto metadata = read_metadata(*record);
  if (!metadata) return named({ErrorCode::kMalformed, "its metadata is damaged"});
  return std::move(metadata->values);
}

Error Reader::named(Error error) const {
  return {error.code, name_ + ": " + error.message};
}

}  // namespace roomcast::recording::mcap
