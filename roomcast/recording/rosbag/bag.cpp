// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/rosbag/bag.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "roomcast/core/little_endian.h"

namespace roomcast::recording::rosbag {
namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::string_view kAnyVersion = "#ROSBAG V";
constexpr std::size_t kIndexEntryBytes = 12;

Error ends_early() {
  return malformed("it ends too early");
}
Error damaged_record() {
  return malformed("a record of it is damaged");
}
Error too_many() {
  return {ErrorCode::kTooLarge, "it has too many messages"};
}

}  // namespace

/// A record in the file, whose data has not been read.
struct Bag::Head {
  Fields fields;
  Op op{};
  std::uint64_t data = 0;  // offset
  std::uint32_t data_bytes = 0;

  [[nodiscard]] std::uint64_t end() const { return data + data_bytes; }
};

Result<Bag> Bag::read(std::unique_ptr<ByteSource> source) {
  Bag bag(std::move(source));
  std::array<std::uint8_t, kMagic.size()> start{};
  const bool has_start = bag.source_->read(0, start).ok();
  const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
  if (!has_start || !text.starts_with(kAnyVersion)) return malformed("it is not a ROS 1 bag");
  if (text != kMagic)
    return Error{ErrorCode::kUnsupported,
                 "it is a bag of another version than 2.0; rosbag fix rewrites it"};
  if (Status status = bag.index_file(); !status) return status.error();
  return bag;
}

/// The record at `offset`. Nothing if its head is damaged or incomplete; its data may be
/// incomplete. Its fields point into `header_`.
std::optional<Bag::Head> Bag::head_at(std::uint64_t offset) {
  const std::uint64_t size = source_->size();
  std::array<std::uint8_t, 4> length{};
  if (!source_->read(offset, length)) return std::nullopt;
  const std::uint32_t header_bytes = read_u32(length.data());
  if (header_bytes > kMaxHeaderBytes || header_bytes > size - offset - 4) return std::nullopt;
  header_.resize(header_bytes);
  if (!source_->read(offset + 4, header_)) return std::nullopt;
  if (!source_->read(offset + 4 + header_bytes, length)) return std::nullopt;
  auto fields = Fields::read(header_);
  const auto op = fields ? fields->u8("op") : std::nullopt;
  if (!op) return std::nullopt;
  return Head{*std::move(fields), Op{*op}, offset + 8 + header_bytes, read_u32(length.data())};
}

Status Bag::index_file() {
  for (std::uint64_t at = kMagic.size(); at < source_->size();) {
    const auto next = index_record(at);
    if (!next) {
      if (next.error().code == ErrorCode::kTooLarge) return next.error();
      damage_ = next.error().message;
      break;
    }
    at = *next;
  }
  if (Status status = scan_open_chunk(); !status) {
    if (status.error().code == ErrorCode::kTooLarge) return status.error();
    if (!damage_) damage_ = status.error().message;
  }
  find_missing_connections();
  std::erase_if(messages_,
                [&](const MessagePlace& m) { return !connections_.contains(m.connection); });
  if (messages_.empty()) return damage_ ? malformed(*damage_) : malformed("it has no messages");
  return {};
}

/// Returns where the next record begins.
Result<std::uint64_t> Bag::index_record(std::uint64_t offset) {
  const auto head = head_at(offset);
  if (!head) return damaged_record();
  if (head->data_bytes > source_->size() - head->data) return ends_early();
  Status status;
  if (head->op == Op::kChunk) {
    status = scan_open_chunk();
    open_chunk_ = last_chunk_ = offset;
  } else if (head->op == Op::kIndex) {
    status = take_index(*head);
  } else if (head->op == Op::kConnection) {
    if (head->data_bytes > kMaxConnectionBytes) return damaged_record();
    stored_.resize(head->data_bytes);
    loaded_chunk_.reset();
    status = source_->read(head->data, stored_);
    if (status) status = take_connection(head->fields, stored_);
  }
  if (!status) return status.error();
  return head->end();
}

Status Bag::take_connection(const Fields& fields, ByteView data) {
  const auto id = fields.u32("conn");
  const auto inner = Fields::read(data);
  if (!id || !inner) return damaged_record();
  if (connections_.size() == kMaxConnections) return too_many();
  connections_.emplace(*id, Connection{fields.text("topic"), inner->text("type")});
  return {};
}

/// An index record belongs to the chunk before it.
Status Bag::take_index(const Head& head) {
  const auto connection = head.fields.u32("conn");
  if (!connection || !last_chunk_ || head.data_bytes % kIndexEntryBytes != 0)
    return damaged_record();
  const std::size_t count = head.data_bytes / kIndexEntryBytes;
  if (count > kMaxMessages - messages_.size()) return too_many();
  stored_.resize(head.data_bytes);
  loaded_chunk_.reset();
  if (Status status = source_->read(head.data, stored_); !status) return status;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* const entry = stored_.data() + i * kIndexEntryBytes;
    messages_.push_back({ros_time(entry), *last_chunk_, read_u32(entry + 8), *connection});
  }
  open_chunk_.reset();
  return {};
}

/// Reads the messages of a chunk that no index record followed, as at the end of a cut bag.
Status Bag::scan_open_chunk() {
  if (!open_chunk_) return {};
  const std::uint64_t chunk = *std::exchange(open_chunk_, std::nullopt);
  return scan_chunk(chunk, true);
}

/// A cut bag lacks the connections at its end; chunks repeat those that they use.
void Bag::find_missing_connections() {
  std::optional<std::uint64_t> tried;
  for (std::size_t i = 0; damage_ && i < messages_.size(); ++i) {
    if (tried == messages_[i].chunk || connections_.contains(messages_[i].connection)) continue;
    tried = messages_[i].chunk;
    (void)scan_chunk(*tried, false);  // its damage is told when its messages are read
  }
}

Status Bag::scan_chunk(std::uint64_t chunk, bool take_messages) {
  if (Status status = load_chunk(chunk); !status) return status;
  ByteView rest = plain_;
  while (!rest.empty()) {
    const auto offset = static_cast<std::uint32_t>(plain_.size() - rest.size());
    const auto record = take_record(rest);
    const auto op = record ? record->fields.u8("op") : std::nullopt;
    if (!op) return damaged_record();
    if (Op{*op} == Op::kConnection) {
      if (Status status = take_connection(record->fields, record->data); !status) return status;
    }
    if (Op{*op} != Op::kMessage || !take_messages) continue;
    const auto connection = record->fields.u32("conn");
    const std::string time = record->fields.text("time");
    if (!connection || time.size() != 8) return damaged_record();
    if (messages_.size() == kMaxMessages) return too_many();
    messages_.push_back(
        {ros_time(reinterpret_cast<const std::uint8_t*>(time.data())), chunk, offset, *connection});
  }
  return {};
}

Status Bag::load_chunk(std::uint64_t offset) {
  if (loaded_chunk_ == offset) return {};
  loaded_chunk_.reset();
  const auto head = head_at(offset);
  const auto size = head ? head->fields.u32("size") : std::nullopt;
  if (!size || head->op != Op::kChunk) return damaged_record();
  if (head->data_bytes > kMaxChunkBytes)
    return Error{ErrorCode::kTooLarge, "a chunk of it is too large"};
  if (head->data_bytes > source_->size() - head->data) return ends_early();
  stored_.resize(head->data_bytes);
  if (Status status = source_->read(head->data, stored_); !status) return status;
  const Status status = decompress_chunk(head->fields.text("compression"), stored_, *size, plain_);
  if (status) loaded_chunk_ = offset;
  return status;
}

Result<ByteView> Bag::data(const MessagePlace& place) {
  if (Status status = load_chunk(place.chunk); !status) return status.error();
  if (place.offset > plain_.size()) return damaged_record();
  ByteView rest = ByteView(plain_).subspan(place.offset);
  const auto record = take_record(rest);
  const auto op = record ? record->fields.u8("op") : std::nullopt;
  if (!op || Op{*op} != Op::kMessage || record->fields.u32("conn") != place.connection)
    return damaged_record();
  return record->data;
}

}  // namespace roomcast::recording::rosbag
