// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/mcap_store.h"

#include <map>
#include <string>
#include <utility>

#include "roomcast/recording/import/ros2_store.h"
#include "roomcast/recording/mcap/reader.h"

namespace roomcast::recording {
namespace {

constexpr std::size_t kMaxMcapMessages = 8U << 20U;

struct ChunkPlace {
  std::uint32_t chunk = 0, number = 0;  // of the message in its chunk
};

class McapStore final : public RosStore {
 public:
  McapStore(mcap::Reader reader, std::string encoding)
      : reader_(std::move(reader)), encoding_(std::move(encoding)) {}

  [[nodiscard]] Status index() {
    std::map<mcap::ChannelId, std::uint32_t> topic_of;
    for (const auto& [id, channel] : reader_.summary().channels) {
      if (channel.message_encoding != encoding_) continue;
      topic_of[id] = static_cast<std::uint32_t>(topics_.size());
      const auto schema = reader_.summary().schemas.find(channel.schema);
      const bool known = schema != reader_.summary().schemas.end();
      topics_.push_back(
          {channel.topic, known ? ros1_type(schema->second.name) : "", channel.metadata});
    }
    for (std::size_t i = 0; i < reader_.summary().chunks.size(); ++i) {
      if (Status status = load(i); !status) {
        if (!damage_) damage_ = status.error().message;  // the other chunks may be readable
        continue;
      }
      for (std::size_t m = 0; m < loaded_.messages.size(); ++m) {
        const auto topic = topic_of.find(loaded_.messages[m].channel);
        if (topic == topic_of.end()) continue;
        if (messages_.size() == kMaxMcapMessages)
          return Error{ErrorCode::kTooLarge, "it has too many messages"};
        messages_.push_back({topic->second, loaded_.messages[m].log_time});
        places_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(m)});
      }
    }
    return {};
  }

  [[nodiscard]] ros::Serialisation serialisation() const override {
    return ros::Serialisation::kRos2;
  }
  [[nodiscard]] const std::vector<StoredTopic>& topics() const override { return topics_; }
  [[nodiscard]] const std::vector<StoredMessage>& messages() const override { return messages_; }
  [[nodiscard]] Result<ros::ByteView> data(std::size_t message) override {
    const ChunkPlace place = places_[message];
    if (Status status = load(place.chunk); !status) return status.error();
    if (place.number >= loaded_.messages.size()) return malformed("its file has changed");
    return loaded_.messages[place.number].data;
  }
  [[nodiscard]] std::optional<std::string> damage() const override {
    return damage_ ? damage_ : reader_.damage();
  }

 private:
  [[nodiscard]] Status load(std::size_t chunk) {
    if (loaded_number_ == chunk) return {};
    loaded_number_.reset();
    auto contents = reader_.chunk(chunk);
    if (!contents) return contents.error();
    loaded_ = *std::move(contents);
    loaded_number_ = chunk;
    return {};
  }

  mcap::Reader reader_;
  std::string encoding_;
  std::vector<StoredTopic> topics_;
  std::vector<StoredMessage> messages_;
  std::vector<ChunkPlace> places_;
  std::optional<std::string> damage_;
  mcap::ChunkContents loaded_;
  std::optional<std::size_t> loaded_number_;
};

Result<std::shared_ptr<McapStore>> open_mcap(const std::filesystem::path& path,
                                             const std::string& encoding,
                                             const std::string& without_topics) {
  auto reader = mcap::Reader::open(path);
  if (!reader) return reader.error();
  auto store = std::make_shared<McapStore>(*std::move(reader), encoding);
  Status status = store->index();
  if (status && store->topics().empty()) status = Error{ErrorCode::kUnsupported, without_topics};
  if (!status) return Error{status.error().code, path.string() + ": " + status.error().message};
  return store;
}

}  // namespace

Result<std::shared_ptr<RosStore>> open_mcap_store(const std::filesystem::path& path) {
  auto store = open_mcap(path, "cdr", "it has no messages of ROS 2 (CDR)");
  if (!store) return store.error();
  return std::shared_ptr<RosStore>(*std::move(store));
}

Result<std::shared_ptr<MessageStore>> open_protobuf_store(const std::filesystem::path& path) {
  auto store = open_mcap(path, kProtobufEncoding, "it has no messages in Protobuf");
  if (!store) return store.error();
  return std::shared_ptr<MessageStore>(*std::move(store));
}

}  // namespace roomcast::recording
